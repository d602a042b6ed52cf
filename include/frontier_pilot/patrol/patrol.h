#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/patrol/parameters.h"
#include "frontier_pilot/patrol/plan.h"

namespace frontier_pilot::patrol {

class StepDriver;

/// The state of a patrol, or how it ended.
enum class PatrolOutcome {
  kIdle,  ///< no patrol yet
  kRunning,
  kCompleted,
  kCanceled,
  kInvalidGoal,
  kNoOdometry,    ///< none, or too old
  kBadOdometry,   ///< the last message was malformed
  kOdometryJump,  ///< odometry jumped by more than the robot can drive in a cycle
  kBlocked,       ///< another source held the wheels, or there was no progress, for too long
  kEmergencyStop,
  kClockJump,
};
const char* toString(PatrolOutcome outcome);

/// The inputs of one control cycle.
struct PatrolInputs {
  std::optional<MotionSample> odometry;         ///< the latest one, however old
  std::optional<std::string> odometry_problem;  ///< why the last message was refused; empty if it was not
  std::optional<std::string> wheels_held_by;    ///< the arbiter's source that holds the wheels instead of the patrol
  bool emergency_stop = false;
};

/// The result of one control cycle.
struct PatrolOutput {
  PatrolOutcome outcome = PatrolOutcome::kIdle;
  std::optional<Twist2> command;   ///< to be published at once; none while no patrol is active [PAT-6]
  std::optional<int> started_leg;  ///< the leg that begins now, counted from 1 [PAT-3]
  std::string text;                ///< the result, once the patrol has ended [PAT-3]
};

/// Patrols a square, a triangle or a circle by odometry. Whatever ends a patrol, its last output has a zero command.
/// Requirements: docs/requirements.md, PAT-1 to PAT-6.
class Patrol {
 public:
  explicit Patrol(const PatrolParameters& parameters);
  ~Patrol();
  Patrol(const Patrol&) = delete;
  Patrol& operator=(const Patrol&) = delete;

  /// Starts a new goal; a running one must have been cancelled. The first motion comes with the next `update`.
  PatrolOutput start(const PatrolOrder& goal, Time now);
  /// To be called at `frequency`.
  PatrolOutput update(const PatrolInputs& inputs, Time now);
  /// Ends the patrol at once. [PAT-4]
  PatrolOutput cancel();
  /// Ends the patrol because the clock has jumped.
  PatrolOutput abortByClockJump();
  bool active() const { return active_; }

 private:
  enum class Phase { kWaiting, kMoving, kSettling };
  struct Fault {
    PatrolOutcome outcome;
    std::string text;
  };

  PatrolOutput end(PatrolOutcome outcome, std::string text);
  std::optional<Fault> fault(const PatrolInputs& inputs, Time now) const;
  std::optional<Fault> blocked(const PatrolInputs& inputs, Time now);
  PatrolOutput advance(const MotionSample& sample, bool held, Time now);
  PatrolOutput settle(const MotionSample& sample, Time now);
  PatrolOutput beginStep(const MotionSample& sample, Time now);
  PatrolOutput drive(const MotionSample& sample, bool held, Time now);
  PatrolOutput running(const Twist2& command) const;
  std::string completeText() const;

  PatrolParameters parameters_;
  std::unique_ptr<StepDriver> driver_;
  bool active_ = false;
  PatrolOrder goal_;
  std::vector<PatrolStep> steps_;
  std::size_t step_ = 0;  ///< index of the current step; of the next one while waiting or settling
  Phase phase_ = Phase::kWaiting;
  int leg_ = 0;
  Pose2 T_odom_plan_;
  std::optional<MotionSample> last_sample_;
  Time started_, last_update_, settling_since_;
  std::optional<Time> held_since_;
  Time progressed_;  ///< when the step last made progress
  double best_progress_ = 0.0;
};

}  // namespace frontier_pilot::patrol
