#include "frontier_pilot/navigation/navigator.h"

#include <cmath>
#include <limits>
#include <utility>

#include "navigation/navigator_impl.h"

namespace frontier_pilot::navigation {
namespace {

/// Extra clearance beside a robot that is not a disc [m]: its corners swing out while it corrects its course, and
/// closer to a wall it could turn neither way.
constexpr double kSwingRoom = 0.02;

/// A pose that differs from the one before it by more is a correction, and no motion [m, rad]. What was tracked in
/// the map's frame has not moved with it.
constexpr double kPlacedElsewhere = 0.5;
constexpr double kTurnedElsewhere = 1.5;  // farther than a robot turns between two poses of which one is late

/// The map is for a disc as wide as the lane of the robot.
planning::ClearanceParams clearanceFor(planning::ClearanceParams params, const Outline& outline) {
  params.inscribed_radius = outline.halfWidth() + (outline.isDisc() ? 0.0 : kSwingRoom);
  return params;
}

}  // namespace

Navigator::Navigator(const NavigatorParams& params) : Navigator(params, clearingLadder()) {}
Navigator::Navigator(const NavigatorParams& params, std::vector<RecoveryRung> ladder)
    : impl_(std::make_unique<Impl>(params, std::move(ladder))) {}
Navigator::~Navigator() = default;
Navigator::Navigator(Navigator&&) noexcept = default;
Navigator& Navigator::operator=(Navigator&&) noexcept = default;

void Navigator::setMap(const OccupancyGrid& map, const CellRect& changed) { impl_->setMap(map, changed); }
NavigatorOutput Navigator::update(const NavigatorInputs& inputs, Time now) { return impl_->update(inputs, now); }
planning::PlanResult Navigator::makePlan(const planning::PlanRequest& request) { return impl_->makePlan(request); }
void Navigator::clearObstacles() { impl_->clearObstacles(); }
void Navigator::setParameters(const NavigatorParams& params, std::vector<RecoveryRung> ladder) {
  impl_->setParameters(params, std::move(ladder));
}
bool Navigator::hasGoal() const { return impl_->hasGoal(); }
bool Navigator::hasPath() const { return impl_->hasPath(); }
const planning::Path& Navigator::path() const { return impl_->follower().path(); }
std::vector<Vec2> Navigator::wayAhead() const { return impl_->wayAhead(); }
double Navigator::progress() const { return impl_->follower().progress(); }
const std::vector<Vec2>& Navigator::prediction() const { return impl_->follower().prediction(); }
const planning::ClearanceMap& Navigator::clearanceMap() const { return impl_->clearanceMap(); }

Navigator::Impl::Impl(const NavigatorParams& params, std::vector<RecoveryRung> ladder)
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

void Navigator::Impl::setMap(const OccupancyGrid& map, const CellRect& changed) {
  if (clearance_.setMap(map, changed)) {
    obstacles_.forget();
    obstacles_changed_ = true;
  }
  map_changed_ = true;
}

planning::PlanResult Navigator::Impl::makePlan(const planning::PlanRequest& request) {
  if (!clearance_.empty()) clearance_.refresh();
  // The flags of changes stay set: the path being followed still has to be checked against them.
  return planner_.plan(clearance_, request);
}

void Navigator::Impl::clearObstacles() {
  obstacles_changed_ = obstacles_.clearInView(view_, clearance_) || obstacles_changed_;
}

void Navigator::Impl::setParameters(const NavigatorParams& params, std::vector<RecoveryRung> ladder) {
  params_ = params;
  ladder_ = std::move(ladder);
  follower_.setLimits(params.robot.limits);
  predictor_.setLimits(params.robot.limits);
  if (!clearance_.setParams(params.clearance)) return;
  has_path_ = has_path_ && arrived_;  // where only the yaw is left, no path is needed
}

NavigatorOutput Navigator::Impl::update(const NavigatorInputs& inputs, Time now) {
  commands_motion_ = output_.command && !output_.command->isZero();
  output_ = {};
  if (last_update_ && now < *last_update_) {
    poses_.clear();
    track_.clear();
    dynamic_.clear();
    predictor_.clear();
    pose_.reset();
    scan_stamp_.reset();
    waiting_since_.reset();
    blocked_since_.reset();
    refreshed_ = planned_ = now;
    // The times of the marks are those of the future now: none would be old for long.
    obstacles_changed_ = obstacles_.clear(clearance_) || obstacles_changed_;
    if (goal_) finish(NavResult::kAborted, NavReason::kClockJumped);
  }
  last_update_ = now;
  takeIn(inputs, now);
  neighbours_ = {inputs.order.moving, dynamic_.at(now)};
  takeEvents(inputs, now);
  if (!obey(inputs, now) && goal_) {
    if (const auto missing = missingData(inputs, now)) {
      wait(*missing, now);
    } else {
      waiting_since_.reset();
      pursueGoal(inputs, now);
    }
  }
  if (output_.command) predictor_.commanded(*output_.command, now);
  return output_;
}

void Navigator::Impl::takeIn(const NavigatorInputs& inputs, Time now) {
  // A pose of the future would keep all true ones out of the history until its time has come.
  const bool of_the_future = inputs.pose && toSeconds(inputs.pose->stamp - now) > params_.max_age;
  if (inputs.pose && inputs.pose->pose.isFinite() && !of_the_future) {
    if (pose_ && isJump(pose_->pose, inputs.pose->pose, kPlacedElsewhere, kTurnedElsewhere)) dynamic_.clear();
    pose_ = inputs.pose;
    poses_.add(pose_->stamp, pose_->pose);
    track_.add(pose_->pose);
  }
  if (inputs.scan == nullptr || (scan_stamp_ && inputs.scan->stamp == *scan_stamp_) || !isUsable(*inputs.scan)) return;
  const auto T_map_base = poses_.at(inputs.scan->stamp);
  if (!T_map_base || isBlind(*inputs.scan, *T_map_base)) return;
  scan_stamp_ = inputs.scan->stamp;
  scan_ = scanPoints(*inputs.scan, *T_map_base, outline_);
  view_ = {*inputs.scan, *T_map_base};
  obstacles_.setMakingWay(inputs.order.making_way);
  if (clearance_.empty()) return;
  dynamic_.update(*inputs.scan, *T_map_base, clearance_);
  obstacles_changed_ = obstacles_.update(view_, scan_, clearance_, now) || obstacles_changed_;
}

/// Whether the scanner suddenly sees none of the walls that the map has all around.
bool Navigator::Impl::isBlind(const LaserScan2& scan, const Pose2& T_map_base) {
  const auto is_wall = [&](Cell cell) { return clearance_.isMapOccupiedNear(cell, 0); };
  return !clearance_.empty() && blindness_.isBlind(scan, T_map_base, clearance_.geometry(), is_wall);
}

void Navigator::Impl::takeEvents(const NavigatorInputs& inputs, Time now) {
  if (inputs.cancel && goal_) finish(NavResult::kCanceled, NavReason::kCanceled);
  if (inputs.map_replaced && goal_) finish(NavResult::kAborted, NavReason::kMapReplaced);
  if (!inputs.new_goal) return;
  if (goal_) finish(NavResult::kPreempted, NavReason::kPreempted);
  start(*inputs.new_goal, now);
}

void Navigator::Impl::start(const NavGoal& goal, Time now) {
  goal_ = goal;
  waiting_since_.reset();
  if (pose_) watchdog_.restart(now, pose_->pose.position());
  if (!goal.T_map_goal.isFinite()) finish(NavResult::kAborted, NavReason::kInvalidGoal);
}

void Navigator::Impl::finish(NavResult result, NavReason reason) {
  output_.finished.push_back({goal_->id, result, reason});
  output_.command = Twist2{};
  output_.state = NavState::kIdle;
  output_.reason = reason;
  output_.recovery.clear();
  output_.plan_changed = has_path_;
  goal_.reset();
  has_path_ = false;
  arrived_ = false;
  departures_ = 0;
  recovery_ = nullptr;
  rung_ = rounds_ = 0;
  nearest_ = std::numeric_limits<double>::infinity();
  blocked_since_.reset();
  obstacles_.releaseKept();
}

std::optional<NavReason> Navigator::Impl::missingData(const NavigatorInputs& inputs, Time now) const {
  const auto fresh = [&](Time stamp) { return std::abs(toSeconds(now - stamp)) <= params_.max_age; };
  if (clearance_.empty() || !inputs.map_alive) return NavReason::kNoMap;
  if (!pose_ || !fresh(pose_->stamp)) return NavReason::kNoPose;
  if (!inputs.localized) return NavReason::kNotLocalized;
  if (!scan_stamp_ || !fresh(*scan_stamp_)) return NavReason::kNoScan;
  return std::nullopt;
}

void Navigator::Impl::wait(NavReason reason, Time now) {
  if (!waiting_since_) waiting_since_ = now;
  if (toSeconds(now - *waiting_since_) > params_.data_patience) return finish(NavResult::kAborted, reason);
  if (pose_) watchdog_.restart(now, pose_->pose.position());
  command({}, NavState::kWaiting, reason);
}

void Navigator::Impl::command(const Twist2& twist, NavState state, NavReason reason) {
  output_.command = twist;
  output_.state = state;
  output_.reason = reason;
}

}  // namespace frontier_pilot::navigation
