#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "exploration/observed_map.h"

namespace frontier_pilot::exploration {

/// The unknown cells that are connected over 4-neighbours with the unknown neighbours of a frontier cell within
/// `radius` [m] of it. The search ends when it has found at least `most` of them.
std::vector<Cell> unknownBehind(const OccupancyGrid& map, Cell frontier, double radius,
                                std::size_t most = std::numeric_limits<std::size_t>::max());

/// The unknown area that is connected over 4-neighbours with the unknown neighbours of a frontier cell, within 2.5 m of
/// it: small for a pocket behind an object, large where the building goes on. Remembered until the map changes there.
/// Of what is larger than `most` [m^2] it only says that.
class UnknownRegions {
 public:
  explicit UnknownRegions(double most) : most_(most) {}

  /// [m^2]
  double areaBehind(Cell frontier, const ObservedMap& map);

 private:
  struct Region {
    std::uint64_t changes = 0;  ///< of the map around the frontier, and one
    double area = 0.0;          ///< [m^2]
  };

  double most_;            ///< [m^2]
  GridGeometry geometry_;  ///< of the map, by which cells are numbered
  std::unordered_map<std::size_t, Region> regions_;
};

}  // namespace frontier_pilot::exploration
