#include "waypoints/waypoint_follower.h"

namespace frontier_pilot::waypoints {
namespace {

std::string listed(const std::vector<std::size_t>& waypoints) {
  std::string text;
  for (const std::size_t waypoint : waypoints) text += (text.empty() ? "" : ", ") + std::to_string(waypoint + 1);
  return text;
}

/// A failure is no fault of the place while the arbiter does not heed the navigation.
LegEnd judged(const LegEnd& ended, const std::string& refused) {
  if (ended.kind != LegEnd::Kind::kFailed || refused.empty()) return ended;
  return {ended.leg, LegEnd::Kind::kUnable,
          ended.text + ", without the arbiter's permission to drive (" + refused + ")"};
}

}  // namespace

std::string WaypointFollower::inWords(std::size_t waypoint) const {
  return "waypoint " + std::to_string(waypoint + 1) + " of " + std::to_string(count_);
}

WaypointOutput WaypointFollower::start(std::size_t count, Time now) {
  count_ = count;
  current_ = 0;
  missed_.clear();
  under_way_ = pursued_ = false;
  up_ = now;
  outcome_ = WaypointOutcome::kRunning;
  if (count == 0) return end(WaypointOutcome::kInvalidGoal, "there are no waypoints");
  if (count > static_cast<std::size_t>(parameters_.max_waypoints)) {
    return end(WaypointOutcome::kInvalidGoal, std::to_string(count) + " waypoints are more than max_waypoints, " +
                                                  std::to_string(parameters_.max_waypoints));
  }
  return unchanged();
}

WaypointOutput WaypointFollower::unchanged() const {
  WaypointOutput output;
  output.outcome = outcome_;
  return output;
}

WaypointOutput WaypointFollower::end(WaypointOutcome outcome, const std::string& text) {
  WaypointOutput output;
  output.cancel = pursued_;
  output.outcome = outcome_ = outcome;
  output.ended = true;
  output.text = text;
  under_way_ = pursued_ = false;
  return output;
}

WaypointOutput WaypointFollower::update(const WaypointInputs& inputs, Time now) {
  if (!active()) return unchanged();
  if (inputs.emergency_stop) return end(WaypointOutcome::kEmergencyStop, "aborted: emergency stop");
  for (const LegEnd& ended : inputs.ended) {
    if (const auto output = take(judged(ended, inputs.navigation_refused))) return *output;
  }
  if (inputs.navigation_up || now < *up_) up_ = now;  // the clock may have been set back
  if (!inputs.navigation_up) {
    under_way_ = false;  // a server that comes back knows nothing of the goal
    if (now - *up_ <= fromSeconds(parameters_.navigation_timeout)) return unchanged();
    return end(WaypointOutcome::kNavigationGone, "aborted: nothing serves move_base");
  }
  if (under_way_) return unchanged();
  if (pursued_ && inputs.navigation_serves_others) {  // it would be taken from whoever has sent it meanwhile
    return end(WaypointOutcome::kReplaced,
               "aborted: another goal came before that of " + inWords(current_) + " was sent again");
  }
  under_way_ = pursued_ = true;
  WaypointOutput output = unchanged();
  output.send = Leg{++last_leg_, current_};
  return output;
}

/// What the end of a goal means for the rest; something if the waypoints end with it.
std::optional<WaypointOutput> WaypointFollower::take(const LegEnd& ended) {
  if (!pursued_ || ended.leg != last_leg_) return std::nullopt;
  under_way_ = false;
  pursued_ = ended.kind == LegEnd::Kind::kLost;  // another server may still pursue it
  switch (ended.kind) {
    case LegEnd::Kind::kLost:
      return std::nullopt;
    case LegEnd::Kind::kReplaced:
      return end(WaypointOutcome::kReplaced, "aborted: the goal of " + inWords(current_) + " ended: " + ended.text);
    case LegEnd::Kind::kUnable:
      return end(WaypointOutcome::kNavigationUnable,
                 "aborted: on the way to " + inWords(current_) + " the navigation gave the goal up: " + ended.text);
    case LegEnd::Kind::kFailed:
      if (auto output = miss(ended.text)) return output;
      break;
    case LegEnd::Kind::kReached:
      break;
  }
  if (++current_ < count_) return std::nullopt;
  if (missed_.size() == count_) return end(WaypointOutcome::kWaypointMissed, "aborted: no waypoint could be reached");
  const std::string reached = std::to_string(count_ - missed_.size()) + " of " + std::to_string(count_);
  return end(WaypointOutcome::kCompleted,
             reached + " waypoints reached" + (missed_.empty() ? "" : ", missed: " + listed(missed_)));
}

std::optional<WaypointOutput> WaypointFollower::miss(const std::string& why) {
  missed_.push_back(current_);
  if (!parameters_.stop_on_failure) return std::nullopt;
  return end(WaypointOutcome::kWaypointMissed, "aborted: " + inWords(current_) + " could not be reached: " + why);
}

}  // namespace frontier_pilot::waypoints
