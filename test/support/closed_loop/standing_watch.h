#pragma once

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::test {

/// How long a robot that should drive stands at one place without saying why.
class StandingWatch {
 public:
  /// `excused`: it has nothing to do, or says for whom it waits.
  void observe(const Pose2& pose, bool excused, Time now) {
    constexpr double kMoved = 0.1;   // [m]
    constexpr double kTurned = 0.2;  // [rad]
    const bool moved = (pose.position() - anchor_.position()).norm() > kMoved ||
                       std::abs(angleDifference(pose.yaw, anchor_.yaw)) > kTurned;
    if (moved || excused) {
      anchor_ = pose;
      since_ = now;
    }
    longest_ = std::max(longest_, toSeconds(now - since_));
  }
  double longest() const { return longest_; }  ///< [s]

 private:
  Pose2 anchor_;
  Time since_{};
  double longest_ = 0.0;
};

}  // namespace frontier_pilot::test
