#include "frontier_pilot/navigation/navigator_types.h"

#include <algorithm>
#include <array>

namespace frontier_pilot::navigation {
namespace {

constexpr std::array kNoFaultOfTheGoal = {NavReason::kNoMap,        NavReason::kNoPose,      NavReason::kNoScan,
                                          NavReason::kNotLocalized, NavReason::kClockJumped, NavReason::kInternalError,
                                          NavReason::kMapReplaced};

}  // namespace

const char* toString(NavState state) {
  switch (state) {
    case NavState::kIdle:
      return "idle";
    case NavState::kDriving:
      return "driving";
    case NavState::kTurning:
      return "turning";
    case NavState::kRecovering:
      return "recovering";
    case NavState::kWaiting:
      return "waiting";
  }
  return "unknown";
}

const char* toString(NavReason reason) {
  switch (reason) {
    case NavReason::kNone:
      return "no goal";
    case NavReason::kDriving:
      return "on the way";
    case NavReason::kTurning:
      return "turning to the goal's direction";
    case NavReason::kReached:
      return "goal reached";
    case NavReason::kPreempted:
      return "preempted by a newer goal";
    case NavReason::kCanceled:
      return "canceled";
    case NavReason::kNoMap:
      return "no map";
    case NavReason::kNoPose:
      return "lost pose";
    case NavReason::kNoScan:
      return "no scan";
    case NavReason::kInvalidGoal:
      return "invalid goal";
    case NavReason::kGoalOutside:
      return "goal outside of the map";
    case NavReason::kGoalOccupied:
      return "goal occupied";
    case NavReason::kGoalUnreachable:
      return "goal unreachable";
    case NavReason::kNoPath:
      return "no path";
    case NavReason::kStartOutside:
      return "robot outside of the map";
    case NavReason::kStartBlocked:
      return "start blocked";
    case NavReason::kBlocked:
      return "blocked";
    case NavReason::kOscillating:
      return "oscillating";
    case NavReason::kClockJumped:
      return "the clock jumped";
    case NavReason::kTraffic:
      return "gives way to another robot";
    case NavReason::kNotLocalized:
      return "not localised";
    case NavReason::kInternalError:
      return "internal error";
    case NavReason::kMapReplaced:
      return "the map was replaced";
  }
  return "unknown";
}

bool isNoFaultOfTheGoal(NavReason reason) {
  return std::find(kNoFaultOfTheGoal.begin(), kNoFaultOfTheGoal.end(), reason) != kNoFaultOfTheGoal.end();
}

bool isNoFaultOfTheGoal(const std::string& text) {
  return std::any_of(kNoFaultOfTheGoal.begin(), kNoFaultOfTheGoal.end(),
                     [&text](NavReason reason) { return text == toString(reason); });
}

const char* toString(NavResult result) {
  switch (result) {
    case NavResult::kSucceeded:
      return "succeeded";
    case NavResult::kPreempted:
      return "preempted";
    case NavResult::kCanceled:
      return "canceled";
    case NavResult::kAborted:
      return "aborted";
  }
  return "unknown";
}

}  // namespace frontier_pilot::navigation
