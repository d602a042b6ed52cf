#include "ros/waypoint_follower/waypoint_messages.h"

#include <frontier_pilot/FollowWaypointsAction.h>

#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot {

waypoints::LegEnd::Kind kindOf(const actionlib::TerminalState& state) {
  using State = actionlib::TerminalState;
  using Kind = waypoints::LegEnd::Kind;
  switch (state.state_) {
    case State::SUCCEEDED:
      return Kind::kReached;
    case State::PREEMPTED:
    case State::RECALLED:
      return Kind::kReplaced;
    case State::LOST:
      return Kind::kLost;
    default:
      return navigation::isNoFaultOfTheGoal(state.getText()) ? Kind::kUnable : Kind::kFailed;
  }
}

std::uint16_t codeOf(waypoints::WaypointOutcome outcome) {
  using Outcome = waypoints::WaypointOutcome;
  switch (outcome) {
    case Outcome::kCanceled:
      return FollowWaypointsResult::CANCELED;
    case Outcome::kInvalidGoal:
      return FollowWaypointsResult::INVALID_GOAL;
    case Outcome::kEmergencyStop:
      return FollowWaypointsResult::EMERGENCY_STOP;
    case Outcome::kNavigationGone:
      return FollowWaypointsResult::NAVIGATION_GONE;
    case Outcome::kReplaced:
      return FollowWaypointsResult::REPLACED;
    case Outcome::kNavigationUnable:
      return FollowWaypointsResult::NAVIGATION_UNABLE;
    case Outcome::kWaypointMissed:
      return FollowWaypointsResult::WAYPOINT_MISSED;
    default:
      return FollowWaypointsResult::NONE;
  }
}

}  // namespace frontier_pilot
