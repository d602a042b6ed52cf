#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/patrol/parameters.h"
#include "patrol/plan.h"

namespace frontier_pilot::patrol {

/// Drives one step of a patrol with a trapezoidal speed profile. Progress is measured by odometry alone, so that
/// motions commanded by other sources count as well. [PAT-2] [PAT-5]
class StepDriver {
 public:
  explicit StepDriver(const PatrolParameters& parameters) : parameters_(parameters) {}
  void setParameters(const PatrolParameters& parameters) { parameters_ = parameters; }

  /// `T_odom_plan` is where the patrol began. An error that the previous step left is corrected in this one.
  void begin(const PatrolStep& step, const Pose2& T_odom_plan, const MotionSample& sample);
  /// Updates the robot's pose and velocity. To be called with every sample.
  void observe(const MotionSample& sample);
  const PatrolStep& step() const { return step_; }
  /// [m] along a line, [rad] in a turn or on an arc.
  double progress() const { return progress_; }
  /// Whether the target is passed, or nearer than half of what the robot drives in a cycle.
  bool reached() const;
  /// The command for the next cycle, `elapsed` [s] after the last one; `age` [s] is that of the last sample.
  Twist2 command(double elapsed, double age);
  /// The arc that the robot drives in `seconds` at full speed and then until it stands, at most to 0.03 m beyond the
  /// end of a line or an arc, and to the end of a turn: [m] and [rad]. Where `command` only turns it towards the leg,
  /// that turn.
  Twist2 ahead(const Twist2& command, double seconds) const;
  /// Restarts the speed profile from standstill, because another source holds the wheels.
  void rest() { speed_ = 0.0; }

 private:
  struct Deviation {
    double left = 0.0;     ///< beside the leg [m], positive on its left
    double heading = 0.0;  ///< off the leg's direction [rad]
  };
  struct Profile {
    double speed, acceleration, min_speed;
  };

  double remaining() const { return step_.amount - progress_; }
  double measuredSpeed() const;
  Profile profile() const;
  Deviation deviation() const;
  Twist2 follow(double speed) const;

  PatrolParameters parameters_;
  PatrolStep step_;
  Pose2 T_step_odom_;
  Pose2 T_step_base_;
  Twist2 twist_;
  TurnCounter turned_;
  double first_heading_ = 0.0;
  double progress_ = 0.0;
  double speed_ = 0.0;
};

}  // namespace frontier_pilot::patrol
