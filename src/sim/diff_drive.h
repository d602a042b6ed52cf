#pragma once

#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::sim {

/// A differential drive: follows commands within its limits, and stops when they cease. [SIM-1]
class DiffDrive {
 public:
  DiffDrive(const RobotLimits& limits, Duration watchdog) : limits_(limits), watchdog_(watchdog) {}

  /// `twist` must be finite; it holds until the next one, at most for `watchdog`.
  void command(const Twist2& twist, Time now);
  /// The velocity for the next `seconds` [s] from `now` on.
  const Twist2& update(Time now, double seconds);
  const Twist2& velocity() const { return velocity_; }
  /// A contact stopped the linear motion, which has to accelerate from zero again.
  void block() { velocity_.linear = 0.0; }
  /// A contact stopped the turn.
  void blockTurn() { velocity_.angular = 0.0; }
  /// Stands still and waits for a new command.
  void stop();

 private:
  struct Command {
    Twist2 twist;
    Time stamp;
  };

  RobotLimits limits_;
  Duration watchdog_;
  std::optional<Command> command_;
  Twist2 velocity_;
};

}  // namespace frontier_pilot::sim
