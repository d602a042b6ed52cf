#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"

namespace frontier_pilot::exploration {

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
    case Rejection::kNotRich:
      return "not rich";
    case Rejection::kFruitless:
      return "fruitless before";
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

const char* toString(ExplorerPhase phase) { return phase == ExplorerPhase::kRich ? "RICH" : "COVERAGE"; }

const char* toString(ExplorerReason reason) {
  switch (reason) {
    case ExplorerReason::kNone:
      return "none";
    case ExplorerReason::kWaitingForInputs:
      return "waiting for inputs";
    case ExplorerReason::kPaused:
      return "paused";
    case ExplorerReason::kNavigationGone:
      return "navigation gone";
    case ExplorerReason::kMapGone:
      return "map gone";
    case ExplorerReason::kPoseGone:
      return "pose gone";
    case ExplorerReason::kOdometryGone:
      return "odometry gone";
    case ExplorerReason::kInputsComplete:
      return "all inputs are there";
    case ExplorerReason::kGoalSent:
      return "goal sent";
    case ExplorerReason::kGoalReached:
      return "goal reached";
    case ExplorerReason::kGoalFailed:
      return "goal failed";
    case ExplorerReason::kGoalTimedOut:
      return "goal timed out";
    case ExplorerReason::kGoalPreempted:
      return "goal preempted by another client";
    case ExplorerReason::kInformationGone:
      return "nothing left to see at the goal";
    case ExplorerReason::kBetterGoal:
      return "a better goal";
    case ExplorerReason::kRichFrontiersExhausted:
      return "no rich frontier left";
    case ExplorerReason::kBlacklistSaturated:
      return "all that is left is blacklisted, trying once more";
    case ExplorerReason::kNoReachableFrontier:
      return "no reachable frontier left";
    case ExplorerReason::kAllBlacklisted:
      return "all that is left is blacklisted";
    case ExplorerReason::kMapChanged:
      return "the map changed";
    case ExplorerReason::kReturningToStart:
      return "returning to the start";
    case ExplorerReason::kRobotOffKnownGround:
      return "no known free ground around the robot";
    case ExplorerReason::kReset:
      return "reset";
    case ExplorerReason::kClockJumpedBack:
      return "the clock jumped";
    case ExplorerReason::kTooManyFrontiers:
      return "too many frontiers: the map is noise, or larger than can be explored";
  }
  return "?";
}

}  // namespace frontier_pilot::exploration
