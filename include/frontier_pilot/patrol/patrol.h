#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/patrol/parameters.h"

namespace frontier_pilot::patrol {

/// The shapes of a patrol; the values are those of ROBOTIS' Patrol action.
enum class PatrolShape { kSquare = 1, kTriangle = 2, kCircle = 3 };
const char* toString(PatrolShape shape);

/// A goal as it was sent, unchecked, in ROBOTIS' encoding.
struct PatrolOrder {
  double mode = 0.0;  ///< 1 square, 2 triangle, 3 circle
  double size = 0.0;  ///< side or radius [m]
  double laps = 0.0;
};

/// Why a goal is refused; nothing if it can be driven. [PAT-1]
std::optional<std::string> problemOf(const PatrolOrder& goal, const PatrolParameters& parameters);

/// How many legs a valid goal has, all laps together.
int legsOf(const PatrolOrder& goal);

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
  kObstacleAhead,  ///< something is in the way
};
const char* toString(PatrolOutcome outcome);

/// Looks along an arc that the robot is about to drive from its pose in the odometry frame: `arc.linear` [m] forward
/// and `arc.angular` [rad] to the left. Returns what is in the way, in words; nothing if it is free.
using WayAhead = std::function<std::optional<std::string>(const Pose2& T_odom_base, const Twist2& arc)>;

/// The inputs of one control cycle.
struct PatrolInputs {
  std::optional<MotionSample> odometry;         ///< the latest one, however old
  std::optional<std::string> odometry_problem;  ///< why the last message was refused; empty if it was not
  std::optional<std::string> wheels_held_by;    ///< the arbiter's source that holds the wheels instead of the patrol
  bool emergency_stop = false;
  WayAhead way_ahead;          ///< empty: nobody looks where the robot drives
  bool is_connecting = false;  ///< it is not known yet whether somebody looks: a patrol does not begin before that
};

/// The result of one control cycle.
struct PatrolOutput {
  PatrolOutcome outcome = PatrolOutcome::kIdle;
  std::optional<Twist2> command;   ///< to be published at once; none while no patrol is active [PAT-6]
  std::optional<int> started_leg;  ///< the leg that begins now, counted from 1 [PAT-3]
  std::string text;                ///< the result, once the patrol has ended [PAT-3]
};

/// Patrols a square, a triangle or a circle by odometry. Whatever ends a patrol, its last output has a zero command.
/// Requirements: docs/requirements.md, PAT-1 to PAT-7.
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
  /// Other speeds, accelerations and limits, also for a patrol that is being driven, from its next cycle on.
  void setParameters(const PatrolParameters& parameters);
  bool active() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::patrol
