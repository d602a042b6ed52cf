#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/patrol/parameters.h"

namespace frontier_pilot::patrol {

/// What can be patrolled; the values are those of ROBOTIS' Patrol action.
enum class PatrolShape { kSquare = 1, kTriangle = 2, kCircle = 3 };
const char* toString(PatrolShape shape);

/// A goal as it was sent, unchecked: ROBOTIS' encoding.
struct PatrolOrder {
  double mode = 0.0;  ///< 1 square, 2 triangle, 3 circle
  double size = 0.0;  ///< side or radius [m]
  double laps = 0.0;
};

/// What is wrong with a goal; nothing if it can be driven. [PAT-1]
std::optional<std::string> problemOf(const PatrolOrder& goal, const PatrolParameters& parameters);

/// One piece of a patrol, in the plan's frame: the base's pose when the patrol began.
struct PatrolStep {
  enum class Kind { kLine, kTurn, kArc };
  Kind kind = Kind::kLine;
  Pose2 start;          ///< where the step begins if everything before went as planned
  double amount = 0.0;  ///< length of a line [m]; angle of a turn or of an arc (all laps) [rad], counter-clockwise
  double radius = 0.0;  ///< of an arc [m]
  int leg = 0;          ///< number of the leg that begins with the step, from 1; 0: none does
};

/// The steps of a goal without problems: left turns only, and a last turn back to the first heading. On a circle each
/// lap is a leg, and all of them are one arc, so that the robot does not stop in between.
std::vector<PatrolStep> planPatrol(const PatrolOrder& goal);

/// How many legs the goal has.
int legsOf(const PatrolOrder& goal);

}  // namespace frontier_pilot::patrol
