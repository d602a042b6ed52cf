#pragma once

#include <limits>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// Why a frontier cannot be chosen now. [EXP-3]
enum class Rejection {
  kNone,
  kTooSmall,      ///< its cluster, before it was cut, has fewer cells than min_frontier_cells
  kUnreachable,   ///< no cell from which it is visible can be reached
  kTooNear,       ///< every goal tried fails a filter; the first one is nearer than min_distance
  kCluttered,     ///< every goal tried fails a filter; the first one has more than max_obstacle_density around it
  kBlacklisted,   ///< near a blacklisted goal
  kNothingToSee,  ///< the unknown area expected to be seen from the goal is below the minimum
  kSmallCorner,   ///< little floor is expected behind it, too little for a trip
  kNotRich,       ///< in phase RICH: information density below rich_min_density
  kFruitless,     ///< near an earlier goal that did not show the area expected of it
  kClaimed,       ///< another robot claims it and sees it sooner
  kLeftOut,       ///< not judged: too many others are larger or nearer
};
const char* toString(Rejection rejection);

/// What a view from a place is expected to show.
struct ViewGain {
  double area = 0.0;     ///< unknown area in sight [m^2]
  double density = 0.0;  ///< unknown share of all the area in sight, 0 to 1
};

/// One cluster of frontier cells as the explorer judges it.
struct Frontier {
  static constexpr double kNotOnTour = std::numeric_limits<double>::quiet_NaN();

  std::vector<Cell> cells;  ///< filled on request only
  int cell_count = 0;
  Vec2 centroid = Vec2::Zero();  ///< [m]; may lie in a wall
  Cell anchor;                   ///< the cell of the frontier nearest to the centroid
  Rejection rejection = Rejection::kNone;
  Vec2 goal = Vec2::Zero();       ///< reachable place to see it from [m]; the anchor's centre if none was found
  double heading = 0.0;           ///< from the goal to the frontier [rad]
  double distance = 0.0;          ///< travel distance to the goal [m], from the robot or a fall-back's start
  ViewGain info;                  ///< what the view from the goal is expected to show
  double obstacle_density = 0.0;  ///< occupied share of the known cells around the goal
  int visits = 0;                 ///< goals reached earlier within visit_radius
  double score = 0.0;             ///< set if selectable
  int place = 0;                  ///< in the tour over the selectable frontiers, from 1; 0 if it is not on it
  double cost = kNotOnTour;       ///< time that the tour takes until it is seen [s]

  bool selectable() const { return rejection == Rejection::kNone; }
};

}  // namespace frontier_pilot::exploration
