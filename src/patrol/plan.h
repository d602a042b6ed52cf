#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/patrol/patrol.h"

namespace frontier_pilot::patrol {

/// One step of a patrol, in the plan's frame, which is the base frame at the moment when the patrol began.
struct PatrolStep {
  enum class Kind { kLine, kTurn, kArc };
  Kind kind = Kind::kLine;
  Pose2 start;          ///< where the step begins if all steps before went as planned
  double amount = 0.0;  ///< length of a line [m]; angle of a turn or of an arc (all laps) [rad], counter-clockwise
  double radius = 0.0;  ///< of an arc [m]
  int leg = 0;          ///< number, from 1, of the leg that begins with this step; 0: no leg begins
};

/// The steps of a valid goal: left turns only, with a last turn back to the first heading. On a circle each lap is a
/// leg, but all laps are one arc, so that the robot does not stop in between.
std::vector<PatrolStep> planPatrol(const PatrolOrder& goal);

}  // namespace frontier_pilot::patrol
