#pragma once

#include <vector>

#include "support/tour/sight.h"
#include "support/tour/waypoint_graph.h"

namespace frontier_pilot::bench {

/// A path along which a floor is seen, and which can be made shorter as long as enough of it is.
class SeeingPath {
 public:
  SeeingPath(const Terrain& terrain, const Grid<std::uint8_t>& floor, const Sight& sight, std::vector<Vec2> corners);

  /// Leaves out corners and moves them nearer to the line between their neighbours, while `share` of the floor is seen.
  void shorten(double share);

  /// The share of the floor that is seen from places at most 0.4 m apart.
  double seen() const { return seen_.share(); }
  double length() const;
  const std::vector<Vec2>& corners() const { return corners_; }

 private:
  bool pass(double share);
  bool tryToReplace(std::size_t corner, const std::vector<Vec2>& by, double share);
  void see(std::size_t from, std::size_t to, bool added);
  std::vector<Vec2> places(std::size_t from, std::size_t to) const;

  const Terrain& terrain_;
  SeenFloor seen_;
  std::vector<Vec2> corners_;
};

}  // namespace frontier_pilot::bench
