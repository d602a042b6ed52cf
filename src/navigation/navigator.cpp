#include "frontier_pilot/navigation/navigator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

NavReason reasonOf(planning::PlanStatus status) {
  switch (status) {
    case planning::PlanStatus::kFound:
      return NavReason::kDriving;
    case planning::PlanStatus::kNoMap:
      return NavReason::kNoMap;
    case planning::PlanStatus::kInvalidRequest:
      return NavReason::kInvalidGoal;
    case planning::PlanStatus::kStartOutside:
      return NavReason::kStartOutside;
    case planning::PlanStatus::kStartBlocked:
      return NavReason::kStartBlocked;
    case planning::PlanStatus::kGoalOutside:
      return NavReason::kGoalOutside;
    case planning::PlanStatus::kGoalOccupied:
      return NavReason::kGoalOccupied;
    case planning::PlanStatus::kGoalUnreachable:
      return NavReason::kGoalUnreachable;
    case planning::PlanStatus::kNoPath:
      return NavReason::kNoPath;
  }
  return NavReason::kNoPath;
}

/// A new path replaces a valid one only if it saves this share and length [m]: no dithering between equals.
constexpr double kWorthwhileShare = 0.1;
constexpr double kWorthwhile = 0.2;

/// Beside a robot that is no disc: its corners swing out while it corrects its course, and along a wall that is nearer
/// it could turn neither way [m].
constexpr double kSwingRoom = 0.02;

/// The map is for a disc as wide as the lane of the robot.
planning::ClearanceParams clearanceFor(planning::ClearanceParams params, const Outline& outline) {
  params.inscribed_radius = outline.halfWidth() + (outline.isDisc() ? 0.0 : kSwingRoom);
  return params;
}

}  // namespace

Navigator::Navigator(const NavigatorParams& params) : Navigator(params, clearingLadder()) {}

Navigator::Navigator(const NavigatorParams& params, std::vector<RecoveryRung> ladder)
    : params_(params),
      outline_(params.robot.drivenOutline()),
      outline_on_map_(planning::OutlineCheck(outline_).inTightPlaces()),
      ladder_(std::move(ladder)),
      clearance_(clearanceFor(params.clearance, outline_)),
      planner_(params.planner, planning::OutlineCheck(outline_)),
      obstacles_(params.obstacles),
      follower_(params.follower, params.robot),
      predictor_(params.robot.limits),
      watchdog_(params.watchdog) {}

void Navigator::setMap(const OccupancyGrid& map, const CellRect& changed) {
  if (clearance_.setMap(map, changed)) {
    obstacles_.forget();
    obstacles_changed_ = true;
  }
  map_changed_ = true;
}

planning::PlanResult Navigator::makePlan(const planning::PlanRequest& request) {
  if (!clearance_.empty()) clearance_.refresh();
  // What has changed is still to be held against the path being followed.
  return planner_.plan(clearance_, request);
}

void Navigator::clearObstacles() { obstacles_changed_ = obstacles_.clear(clearance_) || obstacles_changed_; }

NavigatorOutput Navigator::update(const NavigatorInputs& inputs, Time now) {
  output_ = {};
  if (last_update_ && now < *last_update_) {
    poses_.clear();
    predictor_.clear();
    pose_.reset();
    scan_stamp_.reset();
    waiting_since_.reset();
    blocked_since_.reset();
    refreshed_ = planned_ = now;
    if (goal_) finish(NavResult::kAborted, NavReason::kClockJumped);
  }
  last_update_ = now;
  takeIn(inputs, now);
  takeEvents(inputs, now);
  if (!goal_) return output_;
  if (const auto missing = missingData(inputs, now)) {
    wait(*missing, now);
  } else {
    waiting_since_.reset();
    pursueGoal(inputs, now);
  }
  if (output_.command) predictor_.commanded(*output_.command, now);
  return output_;
}

void Navigator::takeIn(const NavigatorInputs& inputs, Time now) {
  if (inputs.pose && inputs.pose->pose.isFinite()) {
    pose_ = inputs.pose;
    poses_.add(pose_->stamp, pose_->pose);
  }
  if (inputs.scan == nullptr || (scan_stamp_ && inputs.scan->stamp == *scan_stamp_) || !isUsable(*inputs.scan)) return;
  const auto T_map_base = poses_.at(inputs.scan->stamp);
  if (!T_map_base) return;
  scan_stamp_ = inputs.scan->stamp;
  scan_ = scanPoints(*inputs.scan, *T_map_base, outline_);
  if (clearance_.empty()) return;
  obstacles_changed_ = obstacles_.update(*inputs.scan, scan_, *T_map_base, clearance_, now) || obstacles_changed_;
}

void Navigator::takeEvents(const NavigatorInputs& inputs, Time now) {
  if (inputs.cancel && goal_) finish(NavResult::kCanceled, NavReason::kCanceled);
  if (!inputs.new_goal) return;
  if (goal_) finish(NavResult::kPreempted, NavReason::kPreempted);
  start(*inputs.new_goal, now);
}

void Navigator::start(const NavGoal& goal, Time now) {
  goal_ = goal;
  waiting_since_.reset();
  if (pose_) watchdog_.restart(now, pose_->pose.position());
  if (!goal.T_map_goal.isFinite()) finish(NavResult::kAborted, NavReason::kInvalidGoal);
}

void Navigator::finish(NavResult result, NavReason reason) {
  output_.finished.push_back({goal_->id, result, reason});
  output_.command = Twist2{};
  output_.state = NavState::kIdle;
  output_.reason = reason;
  output_.recovery.clear();
  output_.plan_changed = has_path_;
  goal_.reset();
  has_path_ = false;
  arrived_ = false;
  recovery_ = nullptr;
  rung_ = 0;
  blocked_since_.reset();
}

std::optional<NavReason> Navigator::missingData(const NavigatorInputs& inputs, Time now) const {
  const auto fresh = [&](Time stamp) { return std::abs(toSeconds(now - stamp)) <= params_.max_age; };
  if (clearance_.empty() || !inputs.map_alive) return NavReason::kNoMap;
  if (!pose_ || !fresh(pose_->stamp)) return NavReason::kNoPose;
  if (!scan_stamp_ || !fresh(*scan_stamp_)) return NavReason::kNoScan;
  return std::nullopt;
}

void Navigator::wait(NavReason reason, Time now) {
  if (!waiting_since_) waiting_since_ = now;
  if (toSeconds(now - *waiting_since_) > params_.data_patience) return finish(NavResult::kAborted, reason);
  if (pose_) watchdog_.restart(now, pose_->pose.position());
  command({}, NavState::kWaiting, reason);
}

void Navigator::command(const Twist2& twist, NavState state, NavReason reason) {
  output_.command = twist;
  output_.state = state;
  output_.reason = reason;
}

void Navigator::pursueGoal(const NavigatorInputs& inputs, Time now) {
  refreshMap(now);
  if (recovery_) return continueRecovery(now);
  if (!ensurePath(now)) return;
  const MotionPredictor::Motion motion = predictor_.predict(*pose_, inputs.twist, now);
  if (arrived_ || isAtGoal()) return turn(motion, now);
  lookForBetter(now);
  drive(motion, now);
}

void Navigator::refreshMap(Time now) {
  const bool due = map_changed_ && (!has_path_ || toSeconds(now - refreshed_) >= params_.map_period);
  if (!due && !obstacles_changed_) return;
  clearance_.refresh();
  refreshed_ = now;
  map_changed_ = obstacles_changed_ = false;
  if (!has_path_ || arrived_) return;
  const double along = follower_.progress();
  const std::optional<Pose2> robot = pose_ ? std::optional<Pose2>(pose_->pose) : std::nullopt;
  has_path_ = planning::isPathValid(clearance_, path(), escape_, along) &&
              outline_on_map_.canFollow(clearance_, path(), escape_, along, robot);
}

bool Navigator::ensurePath(Time now) { return has_path_ || replan(now); }

bool Navigator::replan(Time now) {
  planning::PlanResult result = planner_.plan(clearance_, requestFrom(*pose_));
  if (result.found()) return usePath(std::move(result), now);
  output_.plan_changed = true;
  const bool may_help = !obstacles_.empty() || result.status == planning::PlanStatus::kStartBlocked;
  if (may_help) {
    recover(reasonOf(result.status), now);
  } else {
    finish(NavResult::kAborted, reasonOf(result.status));
  }
  return false;
}

planning::PlanRequest Navigator::requestFrom(const StampedPose2& pose) const {
  return {pose.pose.position(), goal_->T_map_goal.position(), -1.0, pose.pose.yaw};
}

bool Navigator::usePath(planning::PlanResult result, Time now) {
  escape_ = result.escape;
  goal_is_moved_ = (result.path.goal() - goal_->T_map_goal.position()).norm() > params_.goal_tolerance;
  follower_.setPath(std::move(result.path));
  watchdog_.newPath(follower_.remaining());
  has_path_ = true;
  planned_ = now;
  blocked_since_.reset();
  output_.plan_changed = true;
  return true;
}

void Navigator::lookForBetter(Time now) {
  if (toSeconds(now - planned_) < params_.replan_period) return;
  planned_ = now;
  planning::PlanResult result = planner_.plan(clearance_, requestFrom(*pose_));
  const double left = follower_.remaining();
  if (result.found() && result.path.length() < (1.0 - kWorthwhileShare) * left - kWorthwhile) {
    usePath(std::move(result), now);
  }
}

bool Navigator::isAtGoal() const {
  const Vec2 target = goal_is_moved_ ? path().goal() : goal_->T_map_goal.position();
  return (pose_->pose.position() - target).norm() <= params_.goal_tolerance;
}

void Navigator::turn(const MotionPredictor::Motion& motion, Time now) {
  arrived_ = true;
  const double left = angleDifference(goal_->T_map_goal.yaw, motion.T_map_base.yaw);
  if (!goal_->use_yaw || std::abs(left) <= params_.yaw_tolerance)
    return finish(NavResult::kSucceeded, NavReason::kReached);
  const FollowerOutput step = follower_.turn(left, followerInputs(motion, now));
  if (step.blocked) return blocked(now);
  blocked_since_.reset();
  command(step.command, NavState::kTurning, NavReason::kTurning);
}

FollowerInputs Navigator::followerInputs(const MotionPredictor::Motion& motion, Time now) const {
  const double age = std::max(0.0, toSeconds(now - std::min(pose_->stamp, *scan_stamp_)));
  return {motion.T_map_base, motion.twist, age, scan_, clearance_};
}

void Navigator::drive(const MotionPredictor::Motion& motion, Time now) {
  const FollowerOutput step = follower_.update(followerInputs(motion, now));
  const auto verdict = watchdog_.update(now, pose_->pose.position(), follower_.remaining());
  if (watchdog_.hasMoved()) rung_ = 0;
  if (verdict == ProgressWatchdog::Verdict::kNoProgress) return recover(NavReason::kBlocked, now);
  if (verdict == ProgressWatchdog::Verdict::kOscillating) return recover(NavReason::kOscillating, now);
  if (step.blocked) return blocked(now);
  blocked_since_.reset();
  command(step.command, NavState::kDriving, NavReason::kDriving);
}

void Navigator::blocked(Time now) {
  if (!blocked_since_) blocked_since_ = now;
  if (toSeconds(now - *blocked_since_) > params_.blocked_patience) return recover(NavReason::kBlocked, now);
  command({}, NavState::kDriving, NavReason::kBlocked);
}

void Navigator::recover(NavReason trouble, Time now) {
  if (rung_ >= ladder_.size()) return finish(NavResult::kAborted, trouble);
  const RecoveryRung& rung = ladder_[rung_++];
  trouble_ = trouble;
  has_path_ = false;
  blocked_since_.reset();
  watchdog_.restart(now, pose_->pose.position());
  if (rung.clears_obstacles) clearObstacles();
  if (rung.begin) recovery_ = rung.begin();
  command({}, NavState::kRecovering, trouble);
  output_.recovery = rung.name;
}

void Navigator::continueRecovery(Time now) {
  const RecoveryStep step = recovery_({pose_->pose, scan_}, now);
  command(step.command, NavState::kRecovering, trouble_);
  output_.recovery = ladder_[rung_ - 1].name;
  if (!step.done) return;
  recovery_ = nullptr;
  watchdog_.restart(now, pose_->pose.position());
}

}  // namespace frontier_pilot::navigation
