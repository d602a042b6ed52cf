#pragma once

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/patrol/plan.h"

namespace frontier_pilot::patrol {

/// Drives one step of a patrol with a trapezoid profile. Progress comes from odometry alone, so that whatever moves the
/// robot meanwhile is counted. [PAT-2] [PAT-5]
class StepDriver {
 public:
  explicit StepDriver(const PatrolParameters& parameters) : parameters_(parameters) {}

  /// `T_odom_plan` is where the patrol began. An error left over from the step before is made good in this one.
  void begin(const PatrolStep& step, const Pose2& T_odom_plan, const MotionSample& sample);
  /// Takes in where the robot is.
  void observe(const MotionSample& sample);
  const PatrolStep& step() const { return step_; }
  /// [m] along a line, [rad] round a corner or an arc.
  double progress() const { return progress_; }
  /// Whether the target is crossed, or nearer than the next cycle's half.
  bool reached() const;
  /// What to drive for the next cycle, `elapsed` [s] after the last one; `age` [s] of the last sample.
  Twist2 command(double elapsed, double age);
  /// Begins the profile anew, from standing: the wheels were not ours, or are to rest.
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
