#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::exploration {

/// The values of these three enums are the constants of msg/ExplorerStatus.msg. [EXP-1]
enum class ExplorerState : std::uint8_t { kIdle, kSelectGoal, kNavigating, kEvaluate, kDone };
/// RICH: a frontier is left whose view is expected to be at least a fifth new, or with a positive `rich_min_density`
/// one of at least that density. COVERAGE: only others are left.
enum class ExplorerPhase : std::uint8_t { kRich, kCoverage };
enum class ExplorerReason : std::uint8_t {
  kNone,
  kWaitingForInputs,
  kPaused,
  kNavigationGone,
  kMapGone,
  kPoseGone,
  kOdometryGone,
  kInputsComplete,
  kGoalSent,
  kGoalReached,
  kGoalFailed,
  kGoalTimedOut,
  kGoalPreempted,
  kInformationGone,
  kBetterGoal,
  kRichFrontiersExhausted,
  kBlacklistSaturated,
  kNoReachableFrontier,
  kAllBlacklisted,
  kMapChanged,
  kReturningToStart,
  kRobotOffKnownGround,
  kReset,
  kClockJumpedBack,
  kTooManyFrontiers,
  kUntilArea,
  kUntilTime,
  kUntilDistance,
  kRobotOutOfBounds,
  kBoundsChanged,
  kOthersGoal,
  kStartedAgain,
  kUntilShare,
  kUntilBattery,
  kInspecting,
  kInspectionsCleared,
  kLeftToOthers,
  kEmergencyStop,
  kNotLocalized,
  kNavigationDisabled,
  kNavigationUnable,
};
const char* toString(ExplorerState state);
const char* toString(ExplorerPhase phase);
const char* toString(ExplorerReason reason);

/// Length [m] of the path between two points in the map frame; nullopt if there is none. The caller may supply its
/// planner; by default the explorer's wavefront gives the distances.
using PlanFn = std::function<std::optional<double>(const Vec2& from, const Vec2& to)>;

/// A place that is not to be tried again until the map around it changes. [EXP-5]
struct BlacklistedPlace {
  Vec2 position = Vec2::Zero();       ///< in the map's frame [m]
  std::string reason;                 ///< given by the navigation or by the explorer
  std::uint64_t changes_then = 0;     ///< count of changes around it when it was listed
  std::uint64_t changes_to_lift = 0;  ///< number of further changes that lifts the entry
};

/// A cluster of frontier cells that a robot is going to look at. [MUL-2]
struct Claim {
  Vec2 place = Vec2::Zero();  ///< one of its cells, in the map's frame [m]
  double cost = 0.0;          ///< time until it is seen [s]
};

/// What another robot that explores the same building says of itself.
struct Teammate {
  std::string name;
  bool precedes = false;         ///< of equal claims its own count, and not this robot's
  Vec2 position = Vec2::Zero();  ///< in the map's frame [m]
  std::vector<Claim> claims;
};

/// How a goal ended, as reported by the navigation.
struct GoalEvent {
  /// kUnable: the navigation gave it up for no fault of the goal, for example without a scan. [EXP-8]
  enum class Kind { kReached, kAborted, kRejected, kPreempted, kUnable };
  std::uint32_t goal_id = 0;  ///< of the command that sent it; events of older goals are ignored
  Kind kind = Kind::kReached;
  std::string text;  ///< message of the navigation
};

/// Inputs of one tick. An absent value has never been received or is not available.
struct ExplorerInputs {
  bool enabled = true;               ///< false pauses
  bool stopped = false;              ///< the emergency stop is latched
  bool reset = false;                ///< forget blacklist, fruitless places, failures and visits; return to RICH
  bool start = false;                ///< go on after a stopping rule has ended the exploration
  bool map_available = true;         ///< the map has a publisher
  bool navigation_available = true;  ///< the move_base server is there
  std::string navigation_refused;    ///< why the arbiter does not heed its commands; empty: it does
  bool localized = true;             ///< false: the mapper says that the robot is not where its pose is
  bool others_goal = false;          ///< the move_base server pursues a goal of another client
  std::optional<StampedPose2> T_map_base;
  std::optional<Time> odometry_stamp;  ///< of the latest odometry
  std::optional<double> battery;       ///< charge as a share, may be a little above 1; nothing while it is not known
  std::vector<GoalEvent> goal_events;  ///< since the last tick
  std::vector<Teammate> others;        ///< of whom something has been heard lately; none: the robot is alone
};

/// What the navigation has to do. A new goal replaces the current one without a stop.
struct GoalCommand {
  enum class Kind { kNone, kSend, kCancel };
  Kind kind = Kind::kNone;
  std::uint32_t goal_id = 0;
  Pose2 goal;  ///< in the map's frame
};

/// How large the whole floor may be, and how long it may take to explore the rest. [EXP-12]
struct WholeEstimate {
  double area = 0.0;       ///< [m^2]
  double deviation = 0.0;  ///< of the area, one standard deviation [m^2]
  double time_left = 0.0;  ///< [s]; NaN while nothing has been explored since the exploration was started again
  double explored = 0.0;   ///< what was explored when the estimate was made [m^2]

  /// Whether `area` is an estimate, and not known exactly because nothing is left.
  bool isEstimated() const { return deviation > 0.0; }
};

struct ExplorerProgress {
  ExplorerState state = ExplorerState::kIdle;
  ExplorerPhase phase = ExplorerPhase::kRich;
  ExplorerReason reason = ExplorerReason::kWaitingForInputs;
  std::string reason_text;
  std::uint32_t frontiers_found = 0;
  std::uint32_t frontiers_selectable = 0;
  std::uint32_t frontiers_blacklisted = 0;
  std::uint32_t goals_sent = 0;
  std::uint32_t goals_reached = 0;
  std::uint32_t goals_failed = 0;
  std::uint32_t inspected = 0;           ///< poses that were to be inspected and have been
  std::uint32_t inspections_failed = 0;  ///< those that were given up
  double explored_area = 0.0;            ///< known free cells of the map within the bounds [m^2]
  double explored_before = 0.0;          ///< of that, what until/area does not count since it was started again [m^2]
  double distance_travelled = 0.0;       ///< [m]
  double exploring_time = 0.0;           ///< what until/time limits: without pauses and waiting [s]
  double exploring_distance = 0.0;       ///< what until/distance limits: driven in that time [m]
  std::optional<WholeEstimate> whole;    ///< as of the last decision for a goal; nothing until it can be told

  /// The share of the estimated whole that was explored when the estimate was made, 0 to 1; nothing until it can be
  /// told.
  std::optional<double> shareExplored() const;
};

/// A line for the log.
struct ExplorerNote {
  bool warning = false;
  std::string text;
};

struct ExplorerOutput {
  GoalCommand command;
  ExplorerProgress status;
  std::vector<ExplorerProgress> transitions;  ///< all of this tick, in order, each with its reason
  std::vector<ExplorerNote> notes;
  bool frontiers_judged = false;  ///< Explorer::frontiers() has been updated
};

}  // namespace frontier_pilot::exploration
