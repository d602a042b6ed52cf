#pragma once

#include <deque>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot::navigation {

/// Predicts where the base is now from a measured pose that is some time old: it is assumed to have followed its
/// commands within its limits. Without this a controller steers from where the robot was, and brakes too late.
class MotionPredictor {
 public:
  struct Motion {
    Pose2 T_map_base;
    Twist2 twist;
  };

  explicit MotionPredictor(const RobotLimits& limits) : limits_(limits) {}

  void setLimits(const RobotLimits& limits) { limits_ = limits; }
  /// Records that the base is sent `command` at `now`.
  void commanded(const Twist2& command, Time now);
  void clear() { commands_.clear(); }
  /// The motion at `now` of a base that was at `pose` and had `twist` then. Without commands it keeps `twist`.
  Motion predict(const StampedPose2& pose, const Twist2& twist, Time now) const;

 private:
  struct Command {
    Time since;
    Twist2 twist;
  };
  const Twist2* commandAt(Time time) const;

  RobotLimits limits_;
  std::deque<Command> commands_;  ///< of the last second, the oldest first
};

}  // namespace frontier_pilot::navigation
