#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

/// Where a disc's centre may be: the cells from which everything within the disc's radius is free, as far as they can
/// be reached from one of them.
class Terrain {
 public:
  /// Throws std::invalid_argument when the disc does not fit at `start`. `radius` [m].
  Terrain(const OccupancyGrid& truth, const Vec2& start, double radius);

  const GridGeometry& geometry() const { return passable_.geometry(); }
  bool isPassable(Cell cell) const { return passable_.get(cell, 0) != 0; }
  /// From the cell's centre to the nearest thing that is not free [m], up to 2 m.
  double clearance(Cell cell) const { return clearance_[cell]; }
  /// Whether the straight line passes through passable cells only.
  bool isStraight(const Vec2& from, const Vec2& to) const;

 private:
  Grid<std::uint8_t> passable_;
  Grid<float> clearance_;
};

/// Waypoints all over a terrain with straight edges between near ones, and the shortest ways between all of them.
class WaypointGraph {
 public:
  /// The first waypoint is `start`. Neighbouring ones are about `spacing` [m] apart, or less where it is narrow.
  WaypointGraph(const Terrain& terrain, const Vec2& start, double spacing);

  int size() const { return static_cast<int>(places_.size()); }
  const Vec2& place(int node) const { return places_[static_cast<std::size_t>(node)]; }
  double distance(int from, int to) const { return distance_[pair(from, to)]; }
  /// Appends the waypoints after `from` up to and with `to`.
  void appendWay(int from, int to, std::vector<int>& way) const;

 private:
  struct Edge {
    int to;
    float length;
  };
  std::size_t pair(int from, int to) const {
    return static_cast<std::size_t>(from) * places_.size() + static_cast<std::size_t>(to);
  }
  void placeNodes(const Terrain& terrain);
  void addNode(const Terrain& terrain, const Vec2& place);
  void linkNeighbours(const Terrain& terrain);
  void link(int a, int b);
  void bridge(const Terrain& terrain);
  bool areNear(int a, int b) const;
  void searchFrom(int source);

  double spacing_;
  std::vector<Vec2> places_;
  std::vector<std::vector<Edge>> edges_;
  Grid<std::int32_t> owner_;  ///< a waypoint on a straight line from each passable cell; -1 where there is none
  std::vector<float> distance_;
  std::vector<std::uint16_t> next_;  ///< the waypoint after the first one on the shortest way
};

}  // namespace frontier_pilot::bench
