#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/patrol/parameters.h"

namespace frontier_pilot::patrol {

/// The shapes of a patrol; the values are those of ROBOTIS' Patrol action.
enum class PatrolShape { kSquare = 1, kTriangle = 2, kCircle = 3 };
const char* toString(PatrolShape shape);

/// A goal as it was sent, unchecked, in ROBOTIS' encoding.
struct PatrolOrder {
  double mode = 0.0;  ///< 1 square, 2 triangle, 3 circle
  double size = 0.0;  ///< side or radius [m]
  double laps = 0.0;
};

/// Why a goal is refused; nothing if it can be driven. [PAT-1]
std::optional<std::string> problemOf(const PatrolOrder& goal, const PatrolParameters& parameters);

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

/// How many legs the goal has.
int legsOf(const PatrolOrder& goal);

}  // namespace frontier_pilot::patrol
