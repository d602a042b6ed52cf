#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "navigation/navigator_impl.h"

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

/// A new path replaces a valid one only if it saves this share and length [m]: prevents switching back and forth
/// between similar paths.
constexpr double kWorthwhileShare = 0.1;
constexpr double kWorthwhile = 0.2;
/// A robot that only had to turn has left its goal at this many times the tolerance: within it, it may drift.
constexpr double kLeftGoal = 2.0;
constexpr int kMostDepartures = 5;       // of a robot that slips away or recovers each time that it turns at its goal
constexpr double kKeepSpacing = 0.1;     ///< of the places on a path near which obstacles are kept [m]
constexpr std::size_t kMostRounds = 5;   ///< of the ladder, with a way between them that brings the robot no nearer
constexpr double kNearer = 0.5;          ///< to the goal, along the path [m]
constexpr double kSamePlace = 0.05;      ///< between two poses [m]
constexpr double kSameYaw = 0.1;         ///< the same [rad]
constexpr double kRecoverySlack = 0.02;  ///< a recovery may come this much nearer to what the map shows than a path [m]
constexpr double kEdgeSpacing = 0.03;    ///< of the places on an outline under which the ground must have been seen [m]
constexpr double kTrackGap = 0.01;       ///< by which an outline may stand out between two poses of the track [m]

/// Places on the edge of an outline, in the base frame, its corners among them.
std::vector<Vec2> edgeOf(const Outline& outline) {
  std::vector<Vec2> places;
  const std::vector<Vec2>& corners = outline.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
    const int pieces = static_cast<int>(std::ceil(side.norm() / kEdgeSpacing));
    for (int k = 0; k < pieces; ++k) places.emplace_back(corners[i] + side * k / pieces);
  }
  return places;
}

}  // namespace

void Navigator::Impl::pursueGoal(const NavigatorInputs& inputs, Time now) {
  refreshMap(now);
  if (recovery_) return continueRecovery(now);
  if (arrived_ && distanceToGoal() > kLeftGoal * params_.goal_tolerance) leaveGoal(now);
  if (departures_ > kMostDepartures) return finish(NavResult::kAborted, NavReason::kBlocked);
  if (!ensurePath(now)) return;
  const MotionPredictor::Motion motion = predictor_.predict(*pose_, inputs.twist, now);
  if (arrived_ || distanceToGoal() <= params_.goal_tolerance) return turn(motion, now);
  lookForBetter(now);
  drive(motion, now);
}

void Navigator::Impl::refreshMap(Time now) {
  const bool due = map_changed_ && (!has_path_ || toSeconds(now - refreshed_) >= params_.map_period);
  if (!due && !obstacles_changed_) return;
  clearance_.refresh();
  refreshed_ = now;
  map_changed_ = obstacles_changed_ = false;
  if (!has_path_ || arrived_) return;
  const double along = follower_.progress();
  const std::optional<Pose2> robot = pose_ ? std::optional<Pose2>(pose_->pose) : std::nullopt;
  has_path_ = planning::isPathValid(clearance_, follower_.path(), escape_, along) &&
              outline_on_map_.canFollow(clearance_, follower_.path(), escape_, along, robot);
  if (!has_path_) keepObstacles(along);
}

/// What has made a path invalid is kept until the goal ends, or a robot that drives round a shut door turns back on its
/// detour as soon as it has forgotten the door. [NAV-1]
void Navigator::Impl::keepObstacles(double along) {
  if (!goal_) return;
  obstacles_.keepNear(follower_.path().from(along).sampled(kKeepSpacing), clearance_.requiredClearance() + kKeepSpacing,
                      clearance_.geometry());
}

bool Navigator::Impl::ensurePath(Time now) { return has_path_ || replan(now); }

bool Navigator::Impl::replan(Time now) {
  planning::PlanResult result = planner_.plan(clearance_, requestTo(goal_->T_map_goal.position()));
  if (result.found()) return usePath(std::move(result), now);
  output_.plan_changed = true;
  if (result.postponed) {  // it brakes first, and plans in the next cycle
    command({}, NavState::kDriving, NavReason::kDriving);
    return false;
  }
  const bool may_help = !obstacles_.empty() || result.status == planning::PlanStatus::kStartBlocked;
  if (may_help) {
    recover(reasonOf(result.status), now);
  } else {
    finish(NavResult::kAborted, reasonOf(result.status));
  }
  return false;
}

/// While the wheels turn a plan has to be quick: they go on turning until it is there.
planning::PlanRequest Navigator::Impl::requestTo(const Vec2& place) const {
  return {pose_->pose.position(), place, -1.0, pose_->pose.yaw, commands_motion_};
}

bool Navigator::Impl::usePath(planning::PlanResult result, Time now) {
  escape_ = result.escape;
  goal_is_moved_ = !endsAtGoal(result.path);
  follower_.setPath(std::move(result.path));
  watchdog_.newPath(follower_.remaining());
  has_path_ = true;
  planned_ = now;
  blocked_since_.reset();
  output_.plan_changed = true;
  return true;
}

bool Navigator::Impl::endsAtGoal(const planning::Path& path) const {
  return (path.goal() - goal_->T_map_goal.position()).norm() <= params_.goal_tolerance;
}

/// Better is a way that is much shorter, or that leads to the goal where the present one ends beside it.
void Navigator::Impl::lookForBetter(Time now) {
  if (toSeconds(now - planned_) < params_.replan_period) return;
  planned_ = now;
  planning::PlanResult result = planner_.plan(clearance_, requestTo(goal_->T_map_goal.position()));
  if (!result.found()) return;
  const bool is_shorter = result.path.length() < (1.0 - kWorthwhileShare) * follower_.remaining() - kWorthwhile;
  if (is_shorter || (goal_is_moved_ && endsAtGoal(result.path))) usePath(std::move(result), now);
}

double Navigator::Impl::distanceToGoal() const {
  const Vec2 target = goal_is_moved_ ? follower_.path().goal() : goal_->T_map_goal.position();
  return (pose_->pose.position() - target).norm();
}

/// Something has moved the robot, or its pose was corrected: it has to drive there again.
void Navigator::Impl::leaveGoal(Time now) {
  ++departures_;
  arrived_ = has_path_ = false;
  blocked_since_.reset();
  watchdog_.restart(now, pose_->pose.position());
}

void Navigator::Impl::turn(const MotionPredictor::Motion& motion, Time now) {
  if (!arrived_) watchdog_.restart(now, pose_->pose.position());
  arrived_ = true;
  const double left = angleDifference(goal_->T_map_goal.yaw, motion.T_map_base.yaw);
  if (!goal_->use_yaw || std::abs(left) <= params_.yaw_tolerance)
    return finish(NavResult::kSucceeded, NavReason::kReached);
  // What is left is an angle here. A turn stays in its place, which is no oscillation.
  if (watchdog_.update(now, pose_->pose.position(), std::abs(left)) == ProgressWatchdog::Verdict::kNoProgress) {
    return recover(NavReason::kBlocked, now);
  }
  const FollowerOutput step = follower_.turn(left, followerInputs(motion, now));
  if (step.blocked) return blocked(now);
  blocked_since_.reset();
  command(step.command, NavState::kTurning, NavReason::kTurning);
}

FollowerInputs Navigator::Impl::followerInputs(const MotionPredictor::Motion& motion, Time now) const {
  const double age = std::max(0.0, toSeconds(now - std::min(pose_->stamp, *scan_stamp_)));
  return {motion.T_map_base, motion.twist, age, scan_, clearance_, neighbours_};
}

void Navigator::Impl::drive(const MotionPredictor::Motion& motion, Time now) {
  const FollowerOutput step = follower_.update(followerInputs(motion, now));
  const auto verdict = watchdog_.update(now, pose_->pose.position(), follower_.remaining());
  if (watchdog_.hasMoved()) leaveTrouble();
  if (verdict == ProgressWatchdog::Verdict::kNoProgress) return recover(NavReason::kBlocked, now);
  if (verdict == ProgressWatchdog::Verdict::kOscillating) return recover(NavReason::kOscillating, now);
  if (step.blocked) return blocked(now);
  blocked_since_.reset();
  command(step.command, NavState::kDriving, NavReason::kDriving);
}

/// The robot has moved on, so that the recoveries begin anew. Not for ever: between two shut doors it could go to and
/// fro without an end. [NAV-1]
void Navigator::Impl::leaveTrouble() {
  if (const double left = follower_.remaining(); left < nearest_ - kNearer) {
    nearest_ = left;
    rounds_ = 0;
  }
  if (rung_ == 0 || rounds_ >= kMostRounds) return;
  ++rounds_;
  rung_ = 0;
}

void Navigator::Impl::blocked(Time now) {
  if (!blocked_since_) blocked_since_ = now;
  if (toSeconds(now - *blocked_since_) > params_.blocked_patience) return recover(NavReason::kBlocked, now);
  command({}, NavState::kDriving, NavReason::kBlocked);
}

void Navigator::Impl::recover(NavReason trouble, Time now) {
  if (rung_ >= ladder_.size()) return finish(NavResult::kAborted, trouble);
  const RecoveryRung& rung = ladder_[rung_++];
  trouble_ = trouble;
  if (arrived_) ++departures_;  // the way back to the goal is no progress
  has_path_ = arrived_ = false;
  blocked_since_.reset();
  watchdog_.restart(now, pose_->pose.position());
  if (rung.clears_obstacles) clearObstacles();
  if (rung.begin) recovery_ = rung.begin();
  recovery_began_ = track_.poses();
  recovery_began_.push_back(pose_->pose);
  command({}, NavState::kRecovering, trouble);
  output_.recovery = rung.name;
}

Navigator::Impl::MapFloor Navigator::Impl::floorAt(const Pose2& T_map_base) const {
  const planning::OutlineCheck corners(outline_);
  const planning::OutlineCheck::Leave leave(corners, clearance_, T_map_base);
  const double lane = std::min(clearance_.requiredClearance(), clearance_.clearance(T_map_base.position()));
  return {lane - kRecoverySlack, std::max(kRecoverySlack, leave.slackAt(T_map_base.position()))};
}

/// What neither the map nor the latest scan shows is not free, unless the robot stood on it on its way to where the
/// recovery began. The edge of the outline meets new ground first. [NAV-4]
HasRoom Navigator::Impl::staysOnSeenGround() const {
  const Outline outline = outline_.padded(params_.recovery.margin);
  return [this, outline, edge = edgeOf(outline)](const Pose2& pose) {
    const auto stood_on = [&](const Vec2& place) {
      return std::any_of(recovery_began_.rbegin(), recovery_began_.rend(),
                         [&](const Pose2& before) { return outline.distance(before.inverse() * place) < kTrackGap; });
    };
    return std::all_of(edge.begin(), edge.end(), [&](const Vec2& point) {
      const Vec2 place = pose * point;
      return !clearance_.isUnknown(clearance_.geometry().cellAt(place)) || view_.seesThrough(place, 0.0) ||
             stood_on(place);
    });
  };
}

/// For the lane and, of a robot that is no disc, the corners. Where the robot was nearer to something than a path may
/// come when the recovery began, it may stay as near, so that it gets away; and where it drove before, it may be again.
/// What it does meanwhile lowers nothing, or it would come nearer step by step. In each tick it also stays on its own
/// side of the middle between itself, where it is now, and what may move.
HasRoom Navigator::Impl::hasRoom() const {
  const planning::OutlineCheck corners(outline_);
  const NeighbourCheck neighbours(neighbours_, pose_->pose, outline_);
  return [this, corners, neighbours, stays_on_seen = staysOnSeenGround(),
          begun = floorAt(recovery_began_.back())](const Pose2& pose) {
    if (!neighbours.isOutlineOnOwnSide(pose) || !stays_on_seen(pose)) return false;
    const auto keeps = [&](const MapFloor& floor) {
      return clearance_.clearance(pose.position()) >= floor.lane && corners.fits(clearance_, pose, floor.corner_slack);
    };
    const auto was_here = [&](const Pose2& before) {
      return (before.position() - pose.position()).norm() < kSamePlace &&
             std::abs(angleDifference(before.yaw, pose.yaw)) < kSameYaw && keeps(floorAt(before));
    };
    return keeps(begun) || std::any_of(recovery_began_.begin(), recovery_began_.end(), was_here);
  };
}

void Navigator::Impl::continueRecovery(Time now) {
  const ScanDistance scan_distance = [this](const Outline& outline, const Pose2& T_map_base) {
    return scan_.distance(outline, T_map_base);
  };
  const bool can_turn = outline_on_map_.canTurnRound(clearance_, pose_->pose.position());
  const auto path_exists = [this] {
    planning::PlanRequest request = requestTo(goal_->T_map_goal.position());
    request.quick = false;  // it creeps
    return planner_.plan(clearance_, request).found();
  };
  const RecoveryStep step =
      recovery_({pose_->pose, scan_distance, &track_.poses(), can_turn, path_exists, hasRoom()}, now);
  command(step.command, NavState::kRecovering, trouble_);
  output_.recovery = ladder_[rung_ - 1].name;
  if (!step.done) return;
  recovery_ = nullptr;
  watchdog_.restart(now, pose_->pose.position());
}

}  // namespace frontier_pilot::navigation
