// What the navigator does for other robots: it stands, or drives out of their way, and then goes on with its goal.
#include "navigation/navigator_impl.h"

namespace frontier_pilot::navigation {
namespace {

constexpr double kPlanPeriod = 1.0;  ///< between two searches for a way aside [s]

}  // namespace

std::vector<Vec2> Navigator::Impl::wayAhead() const {
  if (!has_path_ || !pose_ || follower_.path().empty()) return {};
  std::vector<Vec2> way = follower_.path().from(follower_.progress()).points();
  way.insert(way.begin(), pose_->pose.position());
  return way;
}

/// Whether an order determines what the robot does in this cycle. [MUL-3]
bool Navigator::Impl::obey(const NavigatorInputs& inputs, Time now) {
  // Without a goal the robot does not move by itself: it is an obstacle to the others.
  if (inputs.order.empty() || !goal_) {
    if (obeying_) resume(now);
    return false;
  }
  if (missingData(inputs, now)) return false;  // the robot waits for them
  obeying_ = true;
  waiting_since_.reset();
  recovery_ = nullptr;
  output_.traffic = inputs.order.why;
  if (inputs.order.aside) {
    driveAside(*inputs.order.aside, inputs, now);
  } else {
    command({}, NavState::kWaiting, NavReason::kTraffic);
  }
  return true;
}

void Navigator::Impl::driveAside(const Vec2& place, const NavigatorInputs& inputs, Time now) {
  if (!aside_ || (*aside_ - place).norm() > params_.goal_tolerance) {
    aside_ = place;
    has_path_ = aside_failed_ = arrived_ = false;
    planned_ = now - fromSeconds(kPlanPeriod);
    blocked_since_.reset();
  }
  refreshMap(now);
  const bool there = (pose_->pose.position() - place).norm() <= params_.goal_tolerance;
  if (!there && !has_path_) aside_failed_ = !planAside(place, now);
  output_.aside_failed = aside_failed_;
  const bool at_its_end = has_path_ && follower_.remaining() <= params_.goal_tolerance;
  if (at_its_end && !there) aside_failed_ = output_.aside_failed = true;  // the path led to a place beside it
  if (there || !has_path_ || at_its_end) return command({}, NavState::kWaiting, NavReason::kTraffic);
  const FollowerOutput step = follower_.update(followerInputs(predictor_.predict(*pose_, inputs.twist, now), now));
  if (!step.blocked) blocked_since_.reset();
  if (step.blocked && !blocked_since_) blocked_since_ = now;
  if (blocked_since_ && toSeconds(now - *blocked_since_) > params_.blocked_patience) {
    has_path_ = false;
    blocked_since_.reset();
  }
  command(step.blocked ? Twist2{} : step.command, NavState::kDriving, NavReason::kTraffic);
}

/// Whether there is a way to `place`, or none was looked for because the last search was a moment ago.
bool Navigator::Impl::planAside(const Vec2& place, Time now) {
  if (toSeconds(now - planned_) < kPlanPeriod) return !aside_failed_;
  planned_ = now;
  planning::PlanResult result = planner_.plan(clearance_, requestTo(place));
  if (result.postponed) {  // it brakes first, and plans in the next cycle
    planned_ = now - fromSeconds(kPlanPeriod);
    return true;
  }
  if (!result.found()) return false;
  escape_ = result.escape;
  follower_.setPath(std::move(result.path));
  has_path_ = output_.plan_changed = true;
  return true;
}

void Navigator::Impl::resume(Time now) {
  obeying_ = false;
  if (aside_) {
    has_path_ = false;
    output_.command = Twist2{};
    output_.plan_changed = true;
    rung_ = 0;  // it is at another place; one that only stood is where it was blocked
  }
  aside_.reset();
  blocked_since_.reset();
  if (pose_) watchdog_.restart(now, pose_->pose.position());
}

}  // namespace frontier_pilot::navigation
