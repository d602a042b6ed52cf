#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/grids/distance_field.h"

namespace frontier_pilot::planning {

/// How much clearance a path keeps from obstacles.
struct ClearanceParams {
  double inscribed_radius = 0.105;      ///< of the robot's lane: set from the robot model, not a parameter [m]
  double preferred_clearance = 0.35;    ///< centre of the robot to obstacle cells [m]
  double wall_weight = 1.5;             ///< a metre beside a wall costs 1 + this
  double tight_weight = 10.0;           ///< a metre through a tight place costs this; 0: not passable
  bool unknown_is_traversable = false;  ///< whether paths may lead through unknown cells

  template <class Visitor>
  void describe(Visitor& v) {
    v.moved("inscribed_radius", "robot/disc_radius");
    v.field("preferred_clearance", preferred_clearance, "m",
            "distance that paths keep from walls where that costs little", between(0.0, 2.0));
    v.fixed({"wall_weight", "tight_weight"});
    v.field("unknown_is_traversable", unknown_is_traversable, "", "paths may lead through unknown cells");
  }
};

/// Where the robot's centre may be: the map and live obstacles, their distance field and the cost of each cell.
///
/// The field measures between cell centres, and an obstacle fills its cell. A point whose bilinearly interpolated
/// distance is D has its nearest obstacle's surface at least D - (sqrt(1/2) + 0.1) cells away: half a diagonal of the
/// obstacle's cell, and what interpolation overestimates at two cells and more. `requiredClearance` is the radius plus
/// 0.9 cells, so contact is impossible; at 5 cm it is 0.15 m for the Burger, so every place that a disc of 0.15 m can
/// reach, centre to centre, can be reached here.
///
/// In a noisy map corners are up to a cell too thick, so that this rule would close narrow doors. Where the distance is
/// less, but at least the radius plus 0.4 cells, a cell is tight: passable at a cost that makes it the last resort.
/// There the follower decides by the live scan.
///
/// Changes are collected and take effect at `refresh`, at a cost proportional to the number of tiles they touch.
class ClearanceMap {
 public:
  explicit ClearanceMap(const ClearanceParams& params = {});

  /// Takes over the differences inside `changed`, or the whole map if its geometry is new, which also removes the live
  /// obstacles. Returns whether the geometry was new.
  bool setMap(const OccupancyGrid& map, const CellRect& changed);
  /// Another preferred clearance, and other rules for unknown cells; the radius of the lane stays. The whole map is
  /// rated anew at once. Returns whether anything differs.
  bool setParams(const ClearanceParams& params);
  /// Adds or removes an obstacle that is missing from the map. `cell` must be in the map.
  void setLive(Cell cell, bool obstacle);
  /// Brings field and costs up to date. Returns the block of cells whose clearance may have changed.
  CellRect refresh();

  bool empty() const { return obstacle_.empty(); }
  const GridGeometry& geometry() const { return obstacle_.geometry(); }
  const ClearanceParams& params() const { return params_; }
  const grids::DistanceField& field() const { return field_; }
  /// Least interpolated distance at which contact is impossible [m].
  double requiredClearance() const { return required_; }
  /// What `clearance` gives where every obstacle is at least so far away [m].
  double farthestClearance() const { return field_.maxDistance(); }
  /// Least interpolated distance that a path keeps, tight places included [m].
  double leastClearance() const { return least_; }

  bool isKnownFree(Cell c) const { return state_.get(c, kStateUnknown) == kStateFree; }
  bool isUnknown(Cell c) const { return state_.get(c, kStateUnknown) == kStateUnknown; }
  bool isOccupied(Cell c) const { return obstacle_.get(c, 0) != 0; }
  /// Whether the map itself, not the live obstacles, has an occupied cell within `radius` [cells] (a square).
  bool isMapOccupiedNear(Cell c, int radius) const;
  /// Whether the map knows the cell to be free, and has nothing within `radius` [cells] (a square) of it: what a scan
  /// shows there is missing from the map.
  bool isFreeFloor(Cell c, int radius) const { return isKnownFree(c) && !isMapOccupiedNear(c, radius); }
  /// Whether the robot's centre may be at the cell's centre.
  bool isPassable(Cell c) const { return costClass(c) != 0; }

  /// Interpolated distance to the nearest obstacle [m], at most the field's maximum. Outside the map: that at its edge.
  double clearance(const Vec2& point) const;
  /// Whether a path may pass through `point`.
  bool isValid(const Vec2& point) const;
  /// Whether a path may lead straight from `from` to `to`, both ends included.
  bool isValid(const Vec2& from, const Vec2& to) const { return segmentCost(from, to) >= 0.0; }
  /// The length of a valid segment, weighted by the nearness of walls [m]; negative if it is not valid. Of a segment
  /// that costs more than `limit` [m] it is enough to know that: the result may then be anything above, whether the
  /// segment is valid or not.
  double segmentCost(const Vec2& from, const Vec2& to, double limit = std::numeric_limits<double>::infinity()) const;

  /// Classes of cells: 0 is not passable, else `weight(class)` is the cost of a metre.
  static constexpr int kClasses = 33;
  static constexpr int kTightClass = 32;
  std::uint8_t costClass(Cell c) const { return static_cast<std::uint8_t>(cost_.get(c, 0) & kClassMask); }
  double weight(int cost_class) const { return weights_[static_cast<std::size_t>(cost_class)]; }
  const Grid<std::uint8_t>& costs() const { return cost_; }
  static constexpr std::uint8_t kClassMask = 0x3F;

 private:
  enum : std::uint8_t { kStateFree = 0, kStateOccupied = 1, kStateUnknown = 2 };
  static constexpr std::uint8_t kRoomy = 0x80;  ///< every point in the cell is valid
  static constexpr int kTile = 16;              ///< side of a tile [cells]
  enum : std::uint8_t { kTileClean = 0, kTileCost = 1, kTileField = 2 };

  void reset(const OccupancyGrid& map);
  void measure();
  void takeRow(const std::int8_t* map, Cell from, int count);
  void setCell(Cell cell, std::uint8_t state);
  void refreshTiles(Cell first_tile, int count, std::uint8_t level, CellRect& touched);
  void rateCells(const CellRect& cells);
  std::uint8_t rate(Cell cell) const;
  bool isRoomy(Cell cell) const;
  int fieldReach() const;

  ClearanceParams params_;
  double required_ = 0.0;
  double least_ = 0.0;
  std::array<double, kClasses> weights_{};
  Grid<std::uint8_t> state_;     ///< of the map
  Grid<std::uint8_t> live_;      ///< 1 where a live obstacle is
  Grid<std::uint8_t> obstacle_;  ///< in the map or live
  grids::DistanceField field_;
  Grid<std::uint8_t> cost_;  ///< class and kRoomy
  Grid<std::uint8_t> dirty_tiles_;
  std::vector<std::uint8_t> row_;
};

}  // namespace frontier_pilot::planning
