#pragma once

namespace frontier_pilot::behavior {

/// The limits of a motion along one axis, in [m] or [rad] per second and per second squared.
struct MotionLimits {
  double acceleration = 1.0;
  double min_speed = 0.1;
  double max_speed = 1.0;
};

/// The data from which the base's present speed is estimated. Odometry alone would not do: its mean over a cycle is
/// half a cycle old.
struct MotionEstimate {
  double rate = 0.0;     ///< mean speed over the last cycle, by odometry
  double command = 0.0;  ///< the last command
  double age = 0.0;      ///< of the odometry [s]

  /// The present speed, if the base follows the command with `acceleration`; `period` [s] is that of a cycle.
  double present(double acceleration, double period) const;
};

/// What to do in a cycle: stop, or go on at `speed`.
struct ProfileStep {
  bool reached = false;
  double speed = 0.0;
};

/// speed = clamp(sqrt(2 * acceleration * remaining), min, max) [SPN-1], where `remaining` is what will be left when the
/// next cycle can change the command, which is held for a whole `period` [s]. The target counts as reached when
/// stopping now ends nearer to it than stopping one cycle later, braking distance included. [SPN-4]
ProfileStep profileStep(const MotionLimits& limits, double remaining, const MotionEstimate& estimate, double period);

}  // namespace frontier_pilot::behavior
