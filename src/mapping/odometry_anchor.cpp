#include "frontier_pilot/mapping/odometry_anchor.h"

#include <cmath>

namespace frontier_pilot::mapping {
namespace {

// Tolerance, because messages may be stamped on arrival: two that were sent at different times may arrive together.
constexpr double kSlack = 0.5;       ///< [m]
constexpr double kSlackAngle = 0.5;  ///< [rad]
constexpr int kSure = 2;             ///< messages after the first that confirm a reset

}  // namespace

std::optional<Pose2> OdometryAnchor::follow(Time stamp, const Pose2& T_odom_base) {
  const StampedPose2 sample{stamp, T_odom_base};
  // Equal stamps give no speed, and no scan is paired with a message that repeats a stamp.
  if (last_ && stamp == last_->stamp) return T_smooth_odom_ * T_odom_base;
  // Compared first with the messages after the jump: restarted odometry counts from the origin, but soon leaves it.
  if (landing_ && isDrivable(*unconfirmed_, sample)) return confirmLater(sample);
  const bool believed = !last_ || (isDrivable(*last_, sample) && !isRestart(*last_, sample));
  if (believed) return accept(sample);
  landing_.reset();
  return confirmLater(sample);
}

bool OdometryAnchor::isDrivable(const StampedPose2& from, const StampedPose2& to) const {
  const double seconds = std::abs(toSeconds(to.stamp - from.stamp));
  return !isJump(from.pose, to.pose, kSlack + parameters_.max_speed * seconds,
                 kSlackAngle + parameters_.max_turn_rate * seconds);
}

/// Whether odometry is at its origin to the millimetre after a pause: the robot might have driven there, but not so
/// precisely.
bool OdometryAnchor::isRestart(const StampedPose2& from, const StampedPose2& to) const {
  constexpr double kSilence = 1.0;  // [s]
  constexpr double kExact = 0.001;  // [m, rad]
  return toSeconds(to.stamp - from.stamp) > kSilence && !isJump(Pose2(), to.pose, kExact, kExact) &&
         isJump(Pose2(), from.pose, kSlack, kSlackAngle);
}

std::optional<Pose2> OdometryAnchor::accept(const StampedPose2& sample) {
  landing_.reset();
  last_ = sample;
  return T_smooth_odom_ * sample.pose;
}

std::optional<Pose2> OdometryAnchor::confirmLater(const StampedPose2& sample) {
  unconfirmed_ = sample;
  if (!landing_) {
    landing_ = sample;
    followers_ = 0;
    return std::nullopt;
  }
  if (++followers_ < kSure) return std::nullopt;
  const Pose2 step = last_->pose.inverse() * landing_->pose;
  last_jump_ = {step.position().norm(), normalizeAngle(step.yaw), toSeconds(landing_->stamp - last_->stamp)};
  ++resets_;
  if (!parameters_.trusted) {
    T_smooth_odom_ = T_smooth_odom_ * last_->pose * landing_->pose.inverse();
  }
  return accept(sample);
}

void OdometryAnchor::forgetTime() {
  last_.reset();
  landing_.reset();
}

void OdometryAnchor::reset() {
  forgetTime();
  T_smooth_odom_ = Pose2();
}

}  // namespace frontier_pilot::mapping
