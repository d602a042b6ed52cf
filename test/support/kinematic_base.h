#pragma once

#include <functional>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::test {

/// A differential drive without noise, stepped at 100 Hz, that obeys the speed and acceleration limits: enough of a
/// robot to close a control loop around.
class KinematicBase {
 public:
  explicit KinematicBase(const Pose2& pose = {}, const RobotLimits& limits = {}) : limits_(limits), pose_(pose) {}

  /// Drives for `seconds` [s] with a constant `command`.
  void run(const Twist2& command, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds * 100.0));
    for (int i = 0; i < steps; ++i) {
      twist_ = limitAcceleration(clamp(command, limits_), twist_, limits_, 0.01);
      pose_ = integrate(pose_, twist_, 0.01);
      now_ += fromSeconds(0.01);
    }
  }
  void teleport(const Pose2& pose) { pose_ = pose; }

  Time now() const { return now_; }
  const Pose2& pose() const { return pose_; }
  const Twist2& twist() const { return twist_; }
  MotionSample sample() const { return {now_, pose_, twist_}; }

 private:
  RobotLimits limits_;
  Pose2 pose_;
  Twist2 twist_;
  Time now_ = timeFromSeconds(100.0);
};

}  // namespace frontier_pilot::test
