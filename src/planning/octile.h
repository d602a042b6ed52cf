#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "frontier_pilot/planning/clearance_map.h"

/// Integer costs of 8-connected steps between cells, or between blocks of cells.
namespace frontier_pilot::planning {

/// 99/70 is the square root of two to a relative error of 5e-5.
constexpr std::uint32_t kStraightCost = 70;
constexpr std::uint32_t kDiagonalCost = 99;

/// The cost of a step into a cell: [class][whether it is diagonal].
using StepCosts = std::array<std::array<std::uint32_t, 2>, ClearanceMap::kClasses>;

inline StepCosts stepCosts(const ClearanceMap& map) {
  StepCosts costs{};
  for (int i = 1; i < ClearanceMap::kClasses; ++i) {
    costs[static_cast<std::size_t>(i)] = {static_cast<std::uint32_t>(std::lround(kStraightCost * map.weight(i))),
                                          static_cast<std::uint32_t>(std::lround(kDiagonalCost * map.weight(i)))};
  }
  return costs;
}

/// Cost of the steps between two cells where each costs the least possible.
inline std::uint32_t octileCost(Cell a, Cell b) {
  const auto dx = static_cast<std::uint32_t>(std::abs(a.x - b.x));
  const auto dy = static_cast<std::uint32_t>(std::abs(a.y - b.y));
  return kStraightCost * std::max(dx, dy) + (kDiagonalCost - kStraightCost) * std::min(dx, dy);
}

}  // namespace frontier_pilot::planning
