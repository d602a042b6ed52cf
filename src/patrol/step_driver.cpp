#include "patrol/step_driver.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::patrol {
namespace {

/// If its heading is off by more than this [rad], the robot turns before it drives on.
constexpr double kTurnFirst = 0.6;
/// The greatest angle to the leg at which the robot returns to it [rad].
constexpr double kMaxApproach = 0.5;

}  // namespace

PatrolParameters withinLimits(PatrolParameters parameters) {
  const RobotLimits& limits = parameters.robot.limits;
  PatrolParameters& p = parameters;
  p.linear_speed = std::min(p.linear_speed, limits.max_linear);
  p.linear_acc = std::min(p.linear_acc, limits.max_linear_acc);
  p.min_linear_speed = std::min(p.min_linear_speed, p.linear_speed);
  p.turn_speed = std::min(p.turn_speed, limits.max_angular);
  p.turn_acc = std::min(p.turn_acc, limits.max_angular_acc);
  p.min_turn_speed = std::min(p.min_turn_speed, p.turn_speed);
  return parameters;
}

double reach(const PatrolParameters& parameters, double age) {
  const PatrolParameters p = withinLimits(parameters);
  return p.linear_speed * (age + p.simulate_ahead_time) + brakingDistance(p.linear_speed, p.linear_acc);
}

void StepDriver::begin(const PatrolStep& step, const Pose2& T_odom_plan, const MotionSample& sample) {
  step_ = step;
  T_step_odom_ = (T_odom_plan * step.start).inverse();
  turned_.restart(sample.T_odom_base.yaw);
  first_heading_ = (T_step_odom_ * sample.T_odom_base).yaw;
  speed_ = 0.0;
  observe(sample);
}

void StepDriver::observe(const MotionSample& sample) {
  T_step_base_ = T_step_odom_ * sample.T_odom_base;
  twist_ = sample.twist;
  const double turned = first_heading_ + turned_.add(sample.T_odom_base.yaw);
  progress_ = step_.kind == PatrolStep::Kind::kLine ? T_step_base_.x : turned;
}

double StepDriver::measuredSpeed() const {
  return std::max(0.0, step_.kind == PatrolStep::Kind::kLine ? twist_.linear : twist_.angular);
}

bool StepDriver::reached() const {
  // Within half a cycle's travel of the target, stopping now ends nearer to it than stopping one cycle later.
  return remaining() <= 0.5 * measuredSpeed() / parameters_.frequency;
}

StepDriver::Profile StepDriver::profile() const {
  const PatrolParameters& p = parameters_;
  if (step_.kind == PatrolStep::Kind::kTurn) return {p.turn_speed, p.turn_acc, p.min_turn_speed};
  if (step_.kind == PatrolStep::Kind::kLine) return {p.linear_speed, p.linear_acc, p.min_linear_speed};
  // Progress on an arc is an angle; both the linear speed and the rate of turn have to stay within their limits.
  return {std::min(p.linear_speed / step_.radius, p.turn_speed), std::min(p.linear_acc / step_.radius, p.turn_acc),
          std::min(p.min_linear_speed / step_.radius, p.min_turn_speed)};
}

Twist2 StepDriver::command(double elapsed, double age) {
  const Profile profile = this->profile();
  const double reaction = 1.0 / parameters_.frequency + age;
  const double braking = brakingSpeed(remaining(), profile.acceleration, reaction);
  const double target = std::min({profile.speed, speed_ + profile.acceleration * elapsed, braking});
  speed_ = std::max(target, profile.min_speed);
  if (step_.kind == PatrolStep::Kind::kTurn) return {0.0, speed_};
  return follow(step_.kind == PatrolStep::Kind::kArc ? speed_ * step_.radius : speed_);
}

Twist2 StepDriver::ahead(const Twist2& command, double seconds) const {
  constexpr double kBeyond = 0.03;  // [m]: where the robot comes to stand, and where the obstacle is, are not exact
  const Profile profile = this->profile();
  const double full = profile.speed * seconds + brakingDistance(profile.speed, profile.acceleration);
  const double left = std::max(0.0, remaining());
  if (step_.kind == PatrolStep::Kind::kTurn) return {0.0, std::min(full, left)};
  const double reach = std::min(full, left + (step_.kind == PatrolStep::Kind::kArc ? kBeyond / step_.radius : kBeyond));
  if (command.linear == 0.0) return {0.0, command.angular * seconds};
  return step_.kind == PatrolStep::Kind::kLine ? Twist2{reach, 0.0} : Twist2{reach * step_.radius, reach};
}

StepDriver::Deviation StepDriver::deviation() const {
  if (step_.kind == PatrolStep::Kind::kLine) return {T_step_base_.y, T_step_base_.yaw};
  const Vec2 from_centre = T_step_base_.position() - Vec2(0.0, step_.radius);
  const double tangent = bearing(from_centre) + 0.5 * kPi;
  return {step_.radius - from_centre.norm(), angleDifference(T_step_base_.yaw, tangent)};
}

Twist2 StepDriver::follow(double speed) const {
  const PatrolParameters& p = parameters_;
  const Deviation off = deviation();
  const double wanted = std::clamp(-p.lateral_gain * off.left, -kMaxApproach, kMaxApproach);
  const double error = angleDifference(wanted, off.heading);
  const double forward = std::abs(error) > kTurnFirst ? 0.0 : speed;
  const double rate = step_.kind == PatrolStep::Kind::kArc ? forward / step_.radius : 0.0;  // [rad/s]
  return {forward, std::clamp(rate + p.heading_gain * error, -p.turn_speed, p.turn_speed)};
}

}  // namespace frontier_pilot::patrol
