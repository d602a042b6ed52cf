#include "navigation/back_out.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::navigation {
namespace {

constexpr double kLookahead = 0.15;   ///< [m]
constexpr double kMostBearing = 0.8;  ///< of the target from straight behind [rad]
constexpr double kMostTurn = 0.8;     ///< between two places of the way; beyond it the robot turned on the spot [rad]
constexpr double kSpacing = 0.02;     ///< of different places [m]
constexpr double kCheckEvery = 0.1;   ///< a path is looked for [m]
constexpr double kPoseStep = 0.1;     ///< between two of them [s]
constexpr double kNoise = 0.003;      ///< by which the distance from the scan may shrink from pose to pose [m]
constexpr double kNearest = 0.01;     ///< that the outline with its margin may reach beyond a scan point [m]
constexpr double kPatience = 1.0;     ///< with an obstacle in the way [s]
constexpr double kProgress = 0.1;     ///< that it has to move within the time that is allowed [m]

}  // namespace

BackOut::BackOut(const RecoveryParams& params, const RobotModel& robot, double command_lifetime)
    : params_(params),
      limits_(robot.limits),
      outline_(robot.drivenOutline().padded(params.margin)),
      ahead_(command_lifetime + kPoseStep) {}

void BackOut::begin(const RecoveryInputs& in) {
  start_ = in.T_map_base.position();
  could_turn_ = in.can_turn;
  Pose2 last = in.T_map_base;
  const std::deque<Pose2> unknown;
  const std::deque<Pose2>& track = in.track != nullptr ? *in.track : unknown;
  for (auto pose = track.rbegin(); pose != track.rend(); ++pose) {
    const Vec2 before = last.inverse() * pose->position();
    if (before.x() > 0.5 * kLookahead || std::abs(angleDifference(pose->yaw, last.yaw)) > kMostTurn) break;
    way_.push_back(pose->position());
    if (before.norm() > kSpacing) last = *pose;
  }
  way_.push_back(straightBehind(last));
}

Vec2 BackOut::straightBehind(const Pose2& T_map_base) const {
  return T_map_base * Vec2(-kLookahead - params_.back_up_distance, 0.0);
}

bool BackOut::hasBackedEnough(const RecoveryInputs& in) {
  const double backed = (in.T_map_base.position() - start_).norm();
  if (in.can_turn && backed >= params_.back_up_distance) return true;
  if (could_turn_ || !in.path_exists || backed < checked_ + kCheckEvery) return false;
  checked_ = backed;
  return in.path_exists();
}

std::optional<Vec2> BackOut::target(const Pose2& T_map_base) {
  const auto distance = [&](std::size_t i) { return (way_[i] - T_map_base.position()).norm(); };
  while (next_ < way_.size() && distance(next_) < kLookahead) ++next_;
  if (next_ == way_.size()) return std::nullopt;
  const auto behind = [&]() -> std::optional<Vec2> {
    const Vec2 target = T_map_base.inverse() * way_[next_];
    const double off = std::abs(angleDifference(bearing(target), kPi));
    return off > kMostBearing ? std::nullopt : std::optional<Vec2>(target);
  };
  // After a curve so tight that it was nearly a turn on the spot, the way that the robot came lies beside it.
  const bool stands = (T_map_base.position() - start_).norm() < kSpacing;
  if (stands && !behind()) {
    way_ = {straightBehind(T_map_base)};
    next_ = 0;
  }
  return behind();
}

bool BackOut::isFree(const Twist2& command, const RecoveryInputs& in) const {
  const double now = in.scan_distance(outline_, in.T_map_base);
  const double least = std::min({0.0, now, std::max(now - kNoise, -kNearest)});
  const double braking =
      0.5 * std::abs(command.linear) / limits_.max_linear_acc;  // [s] that braking counts for, as if at this speed
  for (double t = kPoseStep; t < ahead_ + braking + 0.5 * kPoseStep; t += kPoseStep) {
    const Pose2 there = integrate(in.T_map_base, command, t);
    if (in.scan_distance(outline_, there) < least || (in.has_room && !in.has_room(there))) return false;
  }
  return true;
}

bool BackOut::isOverdue(const Vec2& position, Time now) {
  if (!anchored_ || (position - anchor_).norm() > kProgress) {
    anchor_ = position;
    anchored_ = now;
  }
  return toSeconds(now - *anchored_) > params_.time_allowance;
}

RecoveryStep BackOut::update(const RecoveryInputs& in, Time now) {
  if (way_.empty()) begin(in);
  if (isOverdue(in.T_map_base.position(), now) || hasBackedEnough(in)) return {Twist2{}, true};
  const std::optional<Vec2> behind = target(in.T_map_base);
  if (!behind) return {Twist2{}, true};
  const double speed = std::min(params_.back_up_speed, limits_.max_linear);
  const double curvature = 2.0 * behind->y() / behind->squaredNorm();
  const double rate = std::clamp(-speed * curvature, -limits_.max_angular, limits_.max_angular);
  for (const double share : kSpeedsOfRecovery) {
    const Twist2 command{-share * speed, share * rate};
    if (!isFree(command, in)) continue;
    blocked_since_.reset();
    return {command, false};
  }
  if (!blocked_since_) blocked_since_ = now;
  return {Twist2{}, toSeconds(now - *blocked_since_) > kPatience};
}

Recovery backOut(const RecoveryParams& params, const RobotModel& robot, double command_lifetime) {
  const auto core = std::make_shared<BackOut>(params, robot, command_lifetime);  // a std::function must be copyable
  return [core](const RecoveryInputs& in, Time now) { return core->update(in, now); };
}

}  // namespace frontier_pilot::navigation
