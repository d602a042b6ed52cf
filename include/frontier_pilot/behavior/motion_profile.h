#pragma once

#include "frontier_pilot/core/time.h"

namespace frontier_pilot::behavior {

/// How a motion along one axis is driven: [m] or [rad] throughout.
struct MotionLimits {
  double acceleration = 1.0;
  double min_speed = 0.1;
  double max_speed = 1.0;
};

/// How fast the base is, from what it did since the last cycle and what it was told: odometry alone is half a cycle
/// old.
struct MotionEstimate {
  double rate = 0.0;     ///< mean over the last cycle, by odometry
  double command = 0.0;  ///< the last one
  double age = 0.0;      ///< of the odometry [s]

  /// The rate at present, if the base follows the command with `acceleration`; `period` [s] is a cycle.
  double present(double acceleration, double period) const;
};

/// What to do in a cycle: stop, or go on with `speed`.
struct ProfileStep {
  bool reached = false;
  double speed = 0.0;
};

/// speed = clamp(sqrt(2 * acceleration * remaining), min, max) [SPN-1], where `remaining` is what will be left when the
/// next cycle can correct it: a command is held for a whole `period` [s]. The target counts as reached when stopping
/// now ends nearer to it than after one more cycle, coasting included. [SPN-4]
ProfileStep profileStep(const MotionLimits& limits, double remaining, const MotionEstimate& estimate, double period);

}  // namespace frontier_pilot::behavior
