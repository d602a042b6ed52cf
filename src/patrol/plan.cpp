#include "patrol/plan.h"

#include <cmath>
#include <sstream>

namespace frontier_pilot::patrol {
namespace {

bool isShape(double mode) { return mode == 1.0 || mode == 2.0 || mode == 3.0; }

PatrolShape shapeOf(const PatrolOrder& goal) { return static_cast<PatrolShape>(static_cast<int>(goal.mode)); }

int cornersOf(PatrolShape shape) { return shape == PatrolShape::kSquare ? 4 : 3; }

std::string complaint(const char* field, const std::string& rule, double value) {
  std::ostringstream out;
  out << "invalid " << field << ": must be " << rule << ", is " << value;
  return out.str();
}

std::string upTo(const char* rule, double most, const char* unit) {
  std::ostringstream out;
  out << rule << " and at most " << most << unit;
  return out.str();
}

std::vector<PatrolStep> polygon(int corners, double side, int laps) {
  const double angle = 2.0 * kPi / corners;
  std::vector<PatrolStep> steps;
  Pose2 pose;
  for (int leg = 0; leg < corners * laps; ++leg) {
    // Every lap starts from the same pose, so that rounding errors do not accumulate over the laps.
    if (leg % corners == 0) pose = Pose2();
    steps.push_back({PatrolStep::Kind::kLine, pose, side, 0.0, leg + 1});
    pose = pose * Pose2(side, 0.0, 0.0);
    steps.push_back({PatrolStep::Kind::kTurn, pose, angle, 0.0, 0});
    pose = pose * Pose2(0.0, 0.0, angle);
  }
  return steps;
}

}  // namespace

const char* toString(PatrolShape shape) {
  constexpr const char* kNames[] = {"square", "triangle", "circle"};
  return kNames[static_cast<int>(shape) - 1];
}

std::optional<std::string> problemOf(const PatrolOrder& goal, const PatrolParameters& parameters) {
  if (!isShape(goal.mode)) return "invalid patrol mode";
  if (!(goal.size > 0.0 && goal.size <= parameters.max_side)) {
    const char* field = shapeOf(goal) == PatrolShape::kCircle ? "goal.y (radius)" : "goal.y (side)";
    return complaint(field, upTo("finite, above 0", parameters.max_side, " m"), goal.size);
  }
  const bool whole = std::isfinite(goal.laps) && goal.laps == std::floor(goal.laps);
  if (!whole || goal.laps < 1.0 || goal.laps > parameters.max_laps) {
    return complaint("goal.z (laps)", upTo("a whole number, at least 1", parameters.max_laps, ""), goal.laps);
  }
  return std::nullopt;
}

std::vector<PatrolStep> planPatrol(const PatrolOrder& goal) {
  const int laps = static_cast<int>(goal.laps);
  const PatrolShape shape = shapeOf(goal);
  if (shape != PatrolShape::kCircle) return polygon(cornersOf(shape), goal.size, laps);
  return {{PatrolStep::Kind::kArc, Pose2(), 2.0 * kPi * laps, goal.size, 1}};
}

int legsOf(const PatrolOrder& goal) {
  const int laps = static_cast<int>(goal.laps);
  const PatrolShape shape = shapeOf(goal);
  return shape == PatrolShape::kCircle ? laps : cornersOf(shape) * laps;
}

}  // namespace frontier_pilot::patrol
