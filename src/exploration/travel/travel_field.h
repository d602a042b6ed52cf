#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {

/// What a TraversableSpace keeps clear of.
enum class KeepClearOf {
  kObstacles,            ///< unknown cells are not traversable, but need no clearance
  kObstaclesAndUnknown,  ///< unknown cells need the clearance too: they may turn out to be obstacles
};

/// Where the robot's centre may be: known free cells at least `clearance` away from the cells to keep clear of (centre
/// to centre). Updated by changed blocks.
class TraversableSpace {
 public:
  /// `clearance` [m] >= 0: half the width of the robot's lane, or the radius it needs to turn, with a margin.
  explicit TraversableSpace(double clearance, KeepClearOf obstacles = KeepClearOf::kObstacles)
      : clearance_(clearance), obstacles_(obstacles) {}

  /// Recomputes the cells that a change of `map` within `changed` can affect; all cells if the geometry is new.
  /// Returns the block of these cells.
  CellRect update(const OccupancyGrid& map, const CellRect& changed);

  bool traversable(Cell c) const { return passable_.get(c, 0) != 0; }
  /// Bit i: the neighbour in direction i (0 east, then counter-clockwise by 45 degrees) is traversable. 0 where the
  /// cell itself is not.
  const Grid<std::uint8_t>& neighbours() const { return neighbours_; }
  const GridGeometry& geometry() const { return passable_.geometry(); }
  double clearance() const { return clearance_; }

 private:
  void markNearObstacles(const OccupancyGrid& map, const CellRect& window);
  void keepFree(const OccupancyGrid& map, const CellRect& window);

  double clearance_;
  KeepClearOf obstacles_;
  std::vector<int> half_widths_;  ///< of the disc that an obstacle blocks, by the row's distance from its centre
  Grid<std::uint8_t> passable_;   ///< 0xFF or 0
  Grid<std::uint8_t> neighbours_;
};

/// Travel distance from one cell to every cell that can be reached through a TraversableSpace: octile paths over
/// 8-neighbours, 5 : 7 for straight : diagonal steps.
/// A bucket queue (Dial, "Algorithm 360", CACM 12, 1969) that expands each cell only in the directions that no other
/// shortest path covers (Harabor & Grastien, "Online Graph Pruning for Pathfinding on Grid Maps", AAAI 2011; Sturtevant
/// & Rabin, "Canonical Orderings on Grids", IJCAI 2016): exact, with about one relaxation per cell instead of eight.
/// Straight runs over open ground are labelled several cells at a time, so that most cells never enter the queue and a
/// cache line is fetched once; a label that is too large because it was set ahead of the queue's order is corrected
/// when the shorter path arrives.
class TravelField {
 public:
  /// If the robot stands closer to an obstacle than the clearance, paths first lead over cells that are not occupied,
  /// for up to `escape_radius` [m]. Nothing is reached if there is no traversable cell within that.
  void compute(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius);

  /// The same from a traversable cell, over cells given by the masks of their traversable neighbours, which must be
  /// symmetric, as far as `farthest` [m]; cells beyond it need not be reached. Nothing is reached if `start` has no
  /// neighbour. Costs what lies within that distance, not what the grid holds.
  void compute(const Grid<std::uint8_t>& neighbours, Cell start, double farthest);
  /// The same, but only the distances of `targets` are exact: ends as soon as they are known. Others may be too large.
  void compute(const Grid<std::uint8_t>& neighbours, Cell start, double farthest, const std::vector<Cell>& targets);

  bool reached(Cell c) const { return units_.get(c, kUnreached) != kUnreached; }
  /// The reached cell that is the fewest steps from `place`, over cells of `map` that are not occupied and at most
  /// `radius` [m] away: where a way to a place that is too near to an obstacle ends.
  std::optional<Cell> nearestReached(const OccupancyGrid& map, Cell place, double radius) const;
  /// Whether any cell of `rect` is reached.
  bool anyReached(const CellRect& rect) const;
  /// Number of cells of `rect` that are reached.
  std::size_t countReached(const CellRect& rect) const;
  /// Travel distance [m]; infinite if the cell is not reached.
  double distance(Cell c) const;
  std::size_t reachedCount() const { return reached_count_; }
  const GridGeometry& geometry() const { return units_.geometry(); }

 private:
  static constexpr std::uint32_t kUnreached = 0xFFFFFFFFU;
  static constexpr std::uint32_t kBuckets = 128;  ///< a power of two above the longest run and the farthest seed
  static constexpr std::uint32_t kStraight = 5;
  static constexpr std::uint32_t kDiagonal = 7;
  static constexpr std::uint32_t kRun = 16;  ///< straight steps at once: the cells of a cache line

  void restart(const GridGeometry& geometry, const CellRect& window);
  /// `ended(units)` says whether that is enough when all labels of at most `units` are exact.
  template <class Ended>
  void spread(const Grid<std::uint8_t>& neighbours, std::uint32_t farthest, Ended ended);
  std::uint32_t begin(const Grid<std::uint8_t>& neighbours, Cell start, double farthest);
  void seed(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius);
  void label(std::size_t index, std::uint32_t units);
  void push(std::size_t index, unsigned direction, std::uint32_t units);
  void expandCell(std::size_t index, unsigned direction, std::uint32_t units, const std::uint8_t* open);
  void goStraight(std::size_t index, unsigned direction, std::uint32_t units, const std::uint8_t* open);

  Grid<std::uint32_t> units_;
  CellRect labelled_;                     ///< holds all cells that are reached
  std::array<std::size_t, 8> offsets_{};  ///< of the neighbours' indices
  grids::BucketQueue<kBuckets> queue_;
  std::size_t reached_count_ = 0;
};

/// The neighbour of `cell` that is nearest to where the wavefront began; `cell` itself if none is nearer.
Cell nextTowardsOrigin(const TravelField& field, Cell cell);

}  // namespace frontier_pilot::exploration
