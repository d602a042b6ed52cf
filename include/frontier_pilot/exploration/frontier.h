#pragma once

#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// Why a frontier cannot be chosen now. [EXP-3]
enum class Rejection {
  kNone,
  kTooSmall,      ///< its whole frontier, before it is cut, has fewer cells than min_frontier_cells
  kUnreachable,   ///< no cell in sight of it can be reached
  kTooNear,       ///< travel distance below min_distance, from every cell that sees it
  kCluttered,     ///< obstacle density around every such cell above max_obstacle_density
  kBlacklisted,   ///< near a blacklisted goal
  kNothingToSee,  ///< no beam from the goal is expected to find unknown ground
  kNotRich,       ///< in phase RICH: information density below rich_min_density
  kFruitless,     ///< reached before, and what it was to show stayed unknown
  kLeftOut,       ///< not judged: there are too many others, larger or nearer ones
};
const char* toString(Rejection rejection);

/// What may be seen from a place.
struct ViewGain {
  double area = 0.0;     ///< unknown area in sight [m^2]
  double density = 0.0;  ///< unknown share of all the area in sight, 0 to 1
};

/// One cluster of frontier cells as the explorer judges it.
struct Frontier {
  std::vector<Cell> cells;  ///< filled on request only
  int cell_count = 0;
  Vec2 centroid = Vec2::Zero();  ///< [m]; may lie in a wall
  Cell anchor;                   ///< its own cell nearest to the centroid
  Rejection rejection = Rejection::kNone;
  Vec2 goal = Vec2::Zero();       ///< a reachable place that sees it [m]; meaningless when unreachable
  double heading = 0.0;           ///< from the goal to the frontier [rad]
  double distance = 0.0;          ///< of travel, from the robot to the goal [m]
  ViewGain info;                  ///< what the goal is expected to show
  double obstacle_density = 0.0;  ///< occupied share of the known cells around the goal
  int visits = 0;                 ///< earlier goals close by
  double score = 0.0;             ///< of selectable ones

  bool selectable() const { return rejection == Rejection::kNone; }
};

}  // namespace frontier_pilot::exploration
