#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::bench {

/// The root mean squares of the errors of a pose.
class PoseErrorMeter {
 public:
  /// `error`: the estimated pose in the frame of the true one.
  void add(const Pose2& error) {
    position_ += error.position().squaredNorm();
    yaw_ += square(normalizeAngle(error.yaw));
    ++count_;
  }

  /// "6.1 mm, 0.36 deg"; "none" before the first error.
  std::string text() const {
    if (count_ == 0) return "none";
    const auto count = static_cast<double>(count_);
    char text[60];
    std::snprintf(text, sizeof text, "%.1f mm, %.2f deg", 1e3 * std::sqrt(position_ / count),
                  std::sqrt(yaw_ / count) * 180.0 / kPi);
    return text;
  }

 private:
  double position_ = 0.0;  ///< sum of the squares [m^2]
  double yaw_ = 0.0;       ///< the same of the yaw [rad^2]
  std::size_t count_ = 0;
};

}  // namespace frontier_pilot::bench
