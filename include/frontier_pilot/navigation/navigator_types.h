#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::navigation {

/// A place to go to. `T_map_goal.yaw` matters only with `use_yaw`.
struct NavGoal {
  std::uint64_t id = 0;  ///< chosen by the caller; returned in the result
  Pose2 T_map_goal;
  bool use_yaw = false;
};

/// A round place [m], for example where another robot is.
struct Disc {
  Vec2 centre = Vec2::Zero();
  double radius = 0.0;
};

/// A round place that moves, such as another robot that drives by.
struct MovingDisc {
  Vec2 centre = Vec2::Zero();    ///< now [m]
  Vec2 velocity = Vec2::Zero();  ///< [m/s]
  double radius = 0.0;           ///< [m]
};

/// What the traffic between several robots asks of the navigator. The goal stays, and is pursued again afterwards. In
/// the map's frame. [MUL-3]
struct NavOrder {
  bool hold = false;               ///< stand still
  std::optional<Vec2> aside;       ///< drive there, and wait; without a goal the robot stays where it is
  std::string why;                 ///< in words, while one of the two is asked for
  std::vector<Disc> making_way;    ///< robots that are leaving: plans may lead through them, motions may not
  std::vector<MovingDisc> moving;  ///< robots nearby that drive: motions keep off where they are going to be
  bool empty() const { return !hold && !aside; }
};

/// Inputs of one tick. A missing input is absent; an old one is recognised by its stamp.
struct NavigatorInputs {
  std::optional<StampedPose2> pose;  ///< T_map_base
  const LaserScan2* scan = nullptr;  ///< the latest one; processed once per stamp
  bool map_alive = true;             ///< false: the map's publisher is gone, so the map may be out of date
  bool localized = true;             ///< false: the mapper says that the robot is not where its pose is
  Twist2 twist;                      ///< current one, from odometry
  std::optional<NavGoal> new_goal;   ///< an event: preempts the current goal
  bool cancel = false;               ///< an event; acts before `new_goal`
  bool map_replaced = false;         ///< an event: the goal was meant for another map; acts before `new_goal`
  NavOrder order;                    ///< holds for this tick; empty for a robot that is alone
};

enum class NavState { kIdle, kDriving, kTurning, kRecovering, kWaiting };
const char* toString(NavState state);

/// Why the navigator does what it does, or why a goal ended.
enum class NavReason {
  kNone,
  kDriving,
  kTurning,
  kReached,
  kPreempted,
  kCanceled,
  kNoMap,
  kNoPose,
  kNoScan,
  kInvalidGoal,
  kGoalOutside,
  kGoalOccupied,
  kGoalUnreachable,
  kNoPath,
  kStartOutside,
  kStartBlocked,
  kBlocked,
  kOscillating,
  kClockJumped,
  kTraffic,
  kNotLocalized,
  kInternalError,
  kMapReplaced,
};
constexpr NavReason kLastNavReason = NavReason::kMapReplaced;
/// The text of results and status, e.g. "goal occupied".
const char* toString(NavReason reason);
/// Whether any other goal would have ended in the same way: the navigator lacked something that it needs to drive at
/// all, such as a scan, or the map was replaced.
bool isNoFaultOfTheGoal(NavReason reason);
/// The same by the text of a result.
bool isNoFaultOfTheGoal(const std::string& text);

enum class NavResult { kSucceeded, kPreempted, kCanceled, kAborted };
const char* toString(NavResult result);

struct NavFinished {
  std::uint64_t id = 0;
  NavResult result = NavResult::kAborted;
  NavReason reason = NavReason::kNone;
};

struct NavigatorOutput {
  /// To be published; absent while there is no goal. Zero in every tick in which a goal ends and none follows. [NAV-1]
  std::optional<Twist2> command;
  NavState state = NavState::kIdle;
  NavReason reason = NavReason::kNone;
  std::string recovery;               ///< what the recovery in progress is doing [NAV-3]
  std::vector<NavFinished> finished;  ///< goals that ended in this tick, the oldest first
  std::string traffic;                ///< what it does for another robot, e.g. "waits for robot2"; empty: nothing
  bool aside_failed = false;          ///< there is no way to the place that the order names
  bool plan_changed = false;          ///< `Navigator::path` has been replaced or is no longer followed
};

}  // namespace frontier_pilot::navigation
