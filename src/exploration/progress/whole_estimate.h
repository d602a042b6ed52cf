#pragma once

#include <optional>

#include "frontier_pilot/exploration/explorer_types.h"

namespace frontier_pilot::exploration {

/// What is known of an exploration at one of its decisions.
struct ExplorationRecord {
  double explored_area = 0.0;    ///< known free floor [m^2]
  double area_in_sight = 0.0;    ///< unknown area that the goals of all frontiers which can be chosen should show [m^2]
  double explored_before = 0.0;  ///< of that, what was known before `time` began [m^2]
  double time = 0.0;             ///< explored so far [s]
  double distance = 0.0;         ///< driven in that time [m]
  double tour_length = 0.0;      ///< from the first stop of the tour to its last one [m]; 0 without a tour
};

/// Estimates the whole floor and the time left. What is left is taken to be proportional to a power of what the present
/// frontiers should show and to become less by the area that is known already; what a second and a metre bring is taken
/// from the run itself. The constants are fitted to the odd plans of bench/floor_plans. Nothing in the first ten
/// seconds, or while nothing is known; without a time left (NaN) if nothing was explored in `time`. [EXP-12]
std::optional<WholeEstimate> estimateWhole(const ExplorationRecord& record);

}  // namespace frontier_pilot::exploration
