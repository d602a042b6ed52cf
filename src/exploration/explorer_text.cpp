#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace frontier_pilot::exploration {
namespace {

/// By the number of the reason.
constexpr std::array kReasonTexts = {
    "none",
    "waiting for inputs",
    "paused",
    "navigation gone",
    "map gone",
    "pose gone",
    "odometry gone",
    "all inputs are there",
    "goal sent",
    "goal reached",
    "goal failed",
    "goal timed out",
    "goal preempted by another client",
    "nothing left to see at the goal",
    "a better goal",
    "no rich frontier left",
    "all that is left is blacklisted, trying once more",
    "no reachable frontier left",
    "all that is left is blacklisted",
    "the map changed",
    "returning to the start",
    "no known free ground around the robot",
    "reset",
    "the clock jumped",
    "too many frontiers: the map is noise, or larger than can be explored",
    "the area asked for is explored",
    "the time asked for has passed",
    "the distance asked for is driven",
    "the robot stands outside of the bounds",
    "the bounds have changed",
    "waiting for your goal to end",
    "started again",
    "the share asked for is explored",
    "the battery is down to the limit",
    "inspecting a pose that was asked for",
    "nothing is to be inspected any more",
    "what is left is another robot's",
    "the emergency stop is latched",
    "the robot is not localised on the map",
    "the arbiter does not heed the navigation",
    "the navigation gave the goal up",
};
static_assert(kReasonTexts.size() == static_cast<std::size_t>(ExplorerReason::kNavigationUnable) + 1);

}  // namespace

const char* toString(Rejection rejection) {
  switch (rejection) {
    case Rejection::kNone:
      return "selectable";
    case Rejection::kTooSmall:
      return "too small";
    case Rejection::kUnreachable:
      return "unreachable";
    case Rejection::kTooNear:
      return "too near";
    case Rejection::kCluttered:
      return "cluttered";
    case Rejection::kBlacklisted:
      return "blacklisted";
    case Rejection::kNothingToSee:
      return "nothing to see";
    case Rejection::kSmallCorner:
      return "in a small corner not worth a trip";
    case Rejection::kNotRich:
      return "not rich";
    case Rejection::kFruitless:
      return "fruitless before";
    case Rejection::kClaimed:
      return "another robot's";
    case Rejection::kLeftOut:
      return "left out, too many others";
  }
  return "?";
}

const char* toString(ExplorerState state) {
  switch (state) {
    case ExplorerState::kIdle:
      return "IDLE";
    case ExplorerState::kSelectGoal:
      return "SELECT_GOAL";
    case ExplorerState::kNavigating:
      return "NAVIGATING";
    case ExplorerState::kEvaluate:
      return "EVALUATE";
    case ExplorerState::kDone:
      return "DONE";
  }
  return "?";
}

std::optional<double> ExplorerProgress::shareExplored() const {
  if (!whole || whole->area <= 0.0) return std::nullopt;
  return std::min(1.0, whole->explored / whole->area);
}

const char* toString(ExplorerPhase phase) { return phase == ExplorerPhase::kRich ? "RICH" : "COVERAGE"; }

const char* toString(ExplorerReason reason) {
  const auto number = static_cast<std::size_t>(reason);
  return number < kReasonTexts.size() ? kReasonTexts[number] : "?";
}

}  // namespace frontier_pilot::exploration
