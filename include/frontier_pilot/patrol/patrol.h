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

/// How a patrol stands, or how it ended.
enum class PatrolOutcome {
  kIdle,  ///< there was none yet
  kRunning,
  kCompleted,
  kCanceled,
  kInvalidGoal,
  kNoOdometry,    ///< none, or too old
  kBadOdometry,   ///< the last message was malformed
  kOdometryJump,  ///< the robot was put somewhere else
  kBlocked,       ///< no wheels or no progress for too long
  kEmergencyStop,
  kClockJump,
};
const char* toString(PatrolOutcome outcome);

/// What a patrol knows of the world in a cycle.
struct PatrolInputs {
  std::optional<MotionSample> odometry;         ///< the latest one, however old
  std::optional<std::string> odometry_problem;  ///< why the last message was refused; nothing if it was good
  std::optional<std::string> wheels_held_by;    ///< another source than the patrol, with its name
  bool emergency_stop = false;
};

/// What comes of a cycle.
struct PatrolOutput {
  PatrolOutcome outcome = PatrolOutcome::kIdle;
  std::optional<Twist2> command;   ///< to be published at once; nothing is while no patrol is active [PAT-6]
  std::optional<int> started_leg;  ///< the leg that begins now, from 1 [PAT-3]
  std::string text;                ///< once it has ended: the result [PAT-3]
};

/// Patrols a square, a triangle or a circle by odometry. Everything that ends a patrol gives a zero command with it.
/// Requirements: docs/requirements.md, PAT-1 to PAT-6.
class Patrol {
 public:
  explicit Patrol(const PatrolParameters& parameters);
  ~Patrol();
  Patrol(const Patrol&) = delete;
  Patrol& operator=(const Patrol&) = delete;

  /// A new goal; one that is running must have been cancelled. The first command comes with the next `update`.
  PatrolOutput start(const PatrolOrder& goal, Time now);
  /// To be called at `frequency`.
  PatrolOutput update(const PatrolInputs& inputs, Time now);
  /// Ends the patrol at once. [PAT-4]
  PatrolOutput cancel();
  /// The same after the clock has jumped, whenever the patrol began.
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
  std::size_t step_ = 0;  ///< index of the next one while waiting or settling, else of the present one
  Phase phase_ = Phase::kWaiting;
  int leg_ = 0;
  Pose2 T_odom_plan_;
  std::optional<MotionSample> last_sample_;
  Time started_, last_update_, settling_since_;
  std::optional<Time> held_since_;
  Time progressed_;  ///< when the step came on for the last time
  double best_progress_ = 0.0;
};

}  // namespace frontier_pilot::patrol
