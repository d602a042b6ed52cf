#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::behavior {

enum class BehaviorKind { kSpin, kBackUp, kDriveOnHeading, kWait };
const char* toString(BehaviorKind kind);

/// What to do.
struct BehaviorGoal {
  BehaviorKind kind = BehaviorKind::kSpin;
  double target = 0.0;          ///< spin: [rad], counter-clockwise; back up: [m], how far back; drive: [m]; wait: [s]
  double speed = 0.0;           ///< of a straight motion [m/s]; 0: the default
  double time_allowance = 0.0;  ///< [s]; 0: as long as it takes
  bool check_collisions = true;
};

/// The state of a behaviour, or how it ended.
enum class BehaviorOutcome {
  kIdle,
  kRunning,
  kSucceeded,
  kTimeout,
  kPoseLost,
  kCollisionAhead,
  kInvalidGoal,
  kNoProgress,
  kCanceled,
};
const char* toString(BehaviorOutcome outcome);

/// A motion along one axis of the base: a turn in place or a straight line, with its sign.
struct AxisMotion {
  enum class Axis { kTurn, kLine };
  Axis axis = Axis::kTurn;
  double amount = 0.0;  ///< [rad] counter-clockwise, or [m] forward

  /// The pose of a base that started at the origin when `share` (0...1) of the motion is done.
  Pose2 at(double share) const {
    return axis == Axis::kTurn ? Pose2(0.0, 0.0, share * amount) : Pose2(share * amount, 0.0, 0.0);
  }
};

/// What a look along a motion has met: an obstacle, or else the first other thing.
enum class SweepResult {
  kClear,
  kObstacle,
  kUnseen,     ///< a cell that no scan has seen
  kOffGrid,    ///< the costmap ends there
  kNoCostmap,  ///< there is none, or its last scan is too old
};
const char* toString(SweepResult result);

/// Looks along a motion from a pose in the odometry frame.
using LookAhead = std::function<SweepResult(const Pose2& T_odom_base, const AxisMotion& motion)>;

/// The inputs of one control cycle.
struct BehaviorInputs {
  std::optional<StampedPose2> pose;  ///< T_odom_base
  LookAhead look_ahead;              ///< empty: there is no costmap
  bool emergency_stop = false;
};

/// The result of one control cycle.
struct BehaviorOutput {
  BehaviorOutcome outcome = BehaviorOutcome::kIdle;
  std::optional<Twist2> command;  ///< to be published at once; none while no behaviour is active
  double progress = 0.0;          ///< so far: [rad] counter-clockwise, [m] towards the target or [s]
  double elapsed = 0.0;           ///< since the start [s], ROS time
  std::string message;            ///< why it has ended, once it has
};

/// Turns, drives straight or waits, and checks the motion ahead in every cycle, the first one included. One behaviour
/// at a time; whatever ends it, its last output has a zero command. A spin that has turned too far, because a cycle
/// came late, turns back once; it has succeeded then, also if the way back fails, and the message says so.
/// Requirements: docs/requirements.md, SPN-1 to SPN-5.
class TimedBehavior {
 public:
  explicit TimedBehavior(const BehaviorParameters& parameters);
  ~TimedBehavior();
  TimedBehavior(TimedBehavior&&) noexcept;
  TimedBehavior& operator=(TimedBehavior&&) noexcept;
  TimedBehavior(const TimedBehavior&) = delete;
  TimedBehavior& operator=(const TimedBehavior&) = delete;

  /// Starts a new goal; a running one must have been cancelled. The first motion comes with the next `update`.
  BehaviorOutput start(const BehaviorGoal& goal, Time now);
  /// To be called at `frequency`.
  BehaviorOutput update(const BehaviorInputs& inputs, Time now);
  /// Ends it at once. `why` goes into the message.
  BehaviorOutput cancel(const std::string& why, Time now);
  /// Ends it because the clock has jumped, so that the time that has passed is not known.
  BehaviorOutput abortByClockJump();

  /// Other speeds, accelerations and limits, also for a running behaviour, from its next cycle on.
  void setParameters(const BehaviorParameters& parameters);

  bool active() const;
  const BehaviorGoal& goal() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Why a goal is refused; nothing if it is valid. [SPN-4]
std::optional<std::string> problemOf(const BehaviorGoal& goal);

}  // namespace frontier_pilot::behavior
