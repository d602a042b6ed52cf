#pragma once

#include <Eigen/Core>
#include <cmath>

namespace frontier_pilot {

/// A point or a direction in the plane [m].
using Vec2 = Eigen::Vector2d;

constexpr double kPi = 3.14159265358979323846;

inline double square(double x) { return x * x; }

/// The same angle in [-pi, pi) [rad]. An angle that is not finite gives one that is not finite.
double normalizeAngle(double angle);

/// The signed smallest rotation that turns `from` into `to` [rad], in [-pi, pi).
inline double angleDifference(double to, double from) { return normalizeAngle(to - from); }

/// The unit vector at `angle` [rad] from the x axis.
inline Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A rotation of the plane, whose sine and cosine are computed once for many points.
class Rotation2 {
 public:
  /// By `angle` [rad], counter-clockwise.
  explicit Rotation2(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}

  Vec2 operator*(const Vec2& v) const { return {cos_ * v.x() - sin_ * v.y(), sin_ * v.x() + cos_ * v.y()}; }
  /// `p` turned, and then moved by `translation`: what a Pose2 does.
  Vec2 applied(const Vec2& p, const Vec2& translation) const {
    return {translation.x() + cos_ * p.x() - sin_ * p.y(), translation.y() + sin_ * p.x() + cos_ * p.y()};
  }
  Eigen::Matrix2d matrix() const { return (Eigen::Matrix2d() << cos_, -sin_, sin_, cos_).finished(); }

 private:
  double cos_, sin_;
};

/// The angle of `v` from the x axis [rad].
inline double bearing(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// A rigid transform of the plane, or the pose of a frame in another one. `T_a_b` maps b's coordinates into a's.
struct Pose2 {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad], counter-clockwise

  Pose2() = default;
  Pose2(double x_, double y_, double yaw_) : x(x_), y(y_), yaw(yaw_) {}
  Pose2(const Vec2& position, double yaw_) : x(position.x()), y(position.y()), yaw(yaw_) {}

  Vec2 position() const { return {x, y}; }
  Pose2 inverse() const;
  bool isFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(yaw); }
};

/// `T_a_c = T_a_b * T_b_c`; the yaw is normalised.
Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c);

/// The point in a's frame, `p_a = T_a_b * p_b`.
Vec2 operator*(const Pose2& T_a_b, const Vec2& p_b);

bool operator==(const Pose2& a, const Pose2& b);

/// The pose at `fraction` (0 ... 1) of the way from `a` to `b`: straight, and turning the short way.
Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction);

/// A velocity of a differential drive, in the base frame.
struct Twist2 {
  double linear = 0.0;   ///< [m/s], forward
  double angular = 0.0;  ///< [rad/s], counter-clockwise

  bool isFinite() const { return std::isfinite(linear) && std::isfinite(angular); }
  bool isZero() const { return linear == 0.0 && angular == 0.0; }
};

bool operator==(const Twist2& a, const Twist2& b);
inline bool operator!=(const Twist2& a, const Twist2& b) { return !(a == b); }

/// Where a base that starts at `pose` is after it has driven with `twist` for `seconds` [s], along the exact arc.
Pose2 integrate(const Pose2& pose, const Twist2& twist, double seconds);

}  // namespace frontier_pilot
