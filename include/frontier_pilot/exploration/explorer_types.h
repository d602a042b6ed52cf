#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/exploration/blacklist.h"
#include "frontier_pilot/exploration/frontier.h"

namespace frontier_pilot::exploration {

/// The values of these three are those of msg/ExplorerStatus.msg. [EXP-1]
enum class ExplorerState : std::uint8_t { kIdle, kSelectGoal, kNavigating, kEvaluate, kDone };
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
};
const char* toString(ExplorerState state);
const char* toString(ExplorerPhase phase);
const char* toString(ExplorerReason reason);

struct ExplorerParameters {
  RobotModel robot;
  double rich_min_density = 0.0;
  double goal_timeout = 120.0;
  int max_goal_retries = 1;
  double check_period = 0.5;
  double decision_period = 2.0;
  double settle_time = 1.0;
  double done_settle_time = 3.0;
  double yield_time = 5.0;
  double vanished_share = 0.25;
  double input_timeout = 1.5;
  double report_period = 5.0;
  bool return_to_start = false;
  FrontierParameters frontier;
  BlacklistParameters blacklist;

  template <class V>
  void describe(V& v) {
    describeRobot(v, robot);
    v.field("rich_min_density", rich_min_density, "", "information density that phase RICH asks for",
            between(0.0, 1.0));
    v.field("goal_timeout", goal_timeout, "s", "a goal that takes longer is cancelled; a frontier's is blacklisted",
            timeSpan());
    v.field("max_goal_retries", max_goal_retries, "", "times a failed goal is tried again", atLeast(0));
    v.fixed({"check_period"});
    v.field("decision_period", decision_period, "s", "time between two comparisons of the present goal with the others",
            timeSpan());
    v.field("settle_time", settle_time, "s", "time to wait at a goal for the map to show what was expected",
            timeSpanOrNone());
    v.field("done_settle_time", done_settle_time, "s", "time without a goal to send after which exploration is done",
            timeSpanOrNone());
    v.fixed({"yield_time", "vanished_share"});
    v.field("input_timeout", input_timeout, "s", "greatest age of pose and odometry; beyond it they count as missing",
            timeSpan());
    v.field("report_period", report_period, "s", "time between two warnings about missing inputs", tickPeriod());
    v.field("return_to_start", return_to_start, "", "drive back to the start before DONE");
    v.group("frontier", frontier, "frontiers and their goals");
    v.group("blacklist", blacklist, "places that are not to be tried");
  }
};

/// How a goal ended, as the navigation says.
struct GoalEvent {
  enum class Kind { kReached, kAborted, kRejected, kPreempted };
  std::uint32_t goal_id = 0;  ///< of the command that sent it; events of older goals are ignored
  Kind kind = Kind::kReached;
  std::string text;  ///< what the navigation said
};

/// What the explorer is told each tick. Absent = never received or not available.
struct ExplorerInputs {
  bool enabled = true;               ///< false pauses
  bool reset = false;                ///< forget blacklist, visits and phase
  bool map_available = true;         ///< somebody publishes the map
  bool navigation_available = true;  ///< the move_base server is there
  std::optional<StampedPose2> T_map_base;
  std::optional<Time> odometry_stamp;  ///< of the latest odometry
  std::vector<GoalEvent> goal_events;  ///< since the last tick
};

/// What is to be done with the navigation. Sending a goal replaces the present one without a stop.
struct GoalCommand {
  enum class Kind { kNone, kSend, kCancel };
  Kind kind = Kind::kNone;
  std::uint32_t goal_id = 0;
  Pose2 goal;  ///< in the map's frame
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
  double explored_area = 0.0;       ///< known free cells of the map [m^2]
  double distance_travelled = 0.0;  ///< [m]
};

/// A line for the log.
struct ExplorerNote {
  bool warning = false;
  std::string text;
};

struct ExplorerOutput {
  GoalCommand command;
  ExplorerProgress status;
  std::vector<ExplorerProgress> transitions;  ///< every one of this tick, in order, each with its reason
  std::vector<ExplorerNote> notes;
  bool frontiers_judged = false;  ///< Explorer::frontiers() is news
};

}  // namespace frontier_pilot::exploration
