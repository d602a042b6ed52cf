#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot {

double normalizeAngle(double angle) {
  if (angle >= -kPi && angle < kPi) return angle;
  const double turned = std::fmod(angle + kPi, 2.0 * kPi);
  const double positive = turned < 0.0 ? turned + 2.0 * kPi : turned;
  // Rounding can lift a tiny negative remainder to a whole turn.
  return positive >= 2.0 * kPi ? -kPi : positive - kPi;
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {-c * x - s * y, s * x - c * y, normalizeAngle(-yaw)};
}

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  return {T_a_b * T_b_c.position(), normalizeAngle(T_a_b.yaw + T_b_c.yaw)};
}

Vec2 operator*(const Pose2& T_a_b, const Vec2& p_b) { return Rotation2(T_a_b.yaw).applied(p_b, T_a_b.position()); }

Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction) {
  const Vec2 position = a.position() + fraction * (b.position() - a.position());
  return {position, normalizeAngle(a.yaw + fraction * angleDifference(b.yaw, a.yaw))};
}

bool operator==(const Pose2& a, const Pose2& b) { return a.x == b.x && a.y == b.y && a.yaw == b.yaw; }

bool operator==(const Twist2& a, const Twist2& b) { return a.linear == b.linear && a.angular == b.angular; }

Pose2 integrate(const Pose2& pose, const Twist2& twist, double seconds) {
  const double turn = twist.angular * seconds;
  const double length = twist.linear * seconds;
  // The chord of an arc is sin(h)/h times its length, and points half-way between the first and the last heading, h
  // being half the turn. For a small h the series is exact to rounding, and the quotient is not.
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-4 ? length * (1.0 - half * half / 6.0) : length * std::sin(half) / half;
  return {pose.position() + chord * direction(pose.yaw + half), normalizeAngle(pose.yaw + turn)};
}

}  // namespace frontier_pilot
