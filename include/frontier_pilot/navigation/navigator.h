#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/navigation/motion_predictor.h"
#include "frontier_pilot/navigation/navigator_types.h"
#include "frontier_pilot/navigation/obstacle_layer.h"
#include "frontier_pilot/navigation/path_follower.h"
#include "frontier_pilot/navigation/progress_watchdog.h"
#include "frontier_pilot/navigation/recovery.h"
#include "frontier_pilot/planning/global_planner.h"

namespace frontier_pilot::navigation {

struct NavigatorParams {
  RobotModel robot;
  planning::ClearanceParams clearance;
  planning::GlobalPlannerParams planner;
  FollowerParams follower;
  ObstacleLayerParams obstacles;
  WatchdogParams watchdog;
  RecoveryParams recovery;
  double goal_tolerance = 0.12;   ///< [m]
  double yaw_tolerance = 0.1;     ///< [rad]
  double max_age = 0.5;           ///< of pose and scan [s]
  double data_patience = 15.0;    ///< how long a goal waits for missing data [s]
  double blocked_patience = 2.0;  ///< how long the robot waits before a recovery [s]
  double replan_period = 5.0;     ///< how often a better path is looked for [s]
  double map_period = 0.3;        ///< map updates take effect at most this often [s]

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.group("clearance", clearance, "room that paths keep");
    v.group("planner", planner, "global planner");
    v.group("follower", follower, "local control");
    v.group("obstacles", obstacles, "obstacles that the map lacks");
    v.group("watchdog", watchdog, "progress and oscillation");
    v.group("recovery", recovery, "recoveries");
    v.field("goal_tolerance", goal_tolerance, "m", "a goal is reached at this distance", positive());
    v.field("yaw_tolerance", yaw_tolerance, "rad",
            "greatest deviation of the yaw at the goal, if its direction matters", positive());
    v.field("max_age", max_age, "s", "greatest age of pose and scan; beyond it the robot stands", timeSpan());
    v.field("data_patience", data_patience, "s", "a goal that waits for data longer is aborted", timeSpan());
    v.field("blocked_patience", blocked_patience, "s", "a blocked robot waits this long before a recovery",
            timeSpanOrNone());
    v.field("replan_period", replan_period, "s", "time between two searches for a better path", timeSpan());
    v.fixed({"map_period"});
  }
};

/// Drives the robot to goals with move_base's semantics, as a state machine: [NAV-1] every goal ends in success,
/// preemption, cancellation or an abort that says why, with zero velocity; [NAV-2] the path is re-validated on every
/// change of map or live obstacles, local control looks at the live scan; [NAV-3] a robot that is stuck climbs the
/// ladder of recoveries; old or missing data stop it, and it goes on when they are back. Poses are T_map_base,
/// velocities in the base frame. A clock that jumps backward aborts the goal.
class Navigator {
 public:
  explicit Navigator(const NavigatorParams& params = {});
  Navigator(const NavigatorParams& params, std::vector<RecoveryRung> ladder);

  /// The map, or what differs in it inside `changed`; anything may have changed if its geometry did.
  void setMap(const OccupancyGrid& map, const CellRect& changed);
  NavigatorOutput update(const NavigatorInputs& inputs, Time now);

  /// A path on the present map and live obstacles, for make_plan and the like; the state is left alone.
  planning::PlanResult makePlan(const planning::PlanRequest& request);
  /// Forgets live obstacles, as move_base's clear_costmaps.
  void clearObstacles();

  bool hasGoal() const { return goal_.has_value(); }
  /// The path being followed; empty without one.
  const planning::Path& path() const { return follower_.path(); }
  double progress() const { return follower_.progress(); }
  const std::vector<Vec2>& prediction() const { return follower_.prediction(); }
  const planning::ClearanceMap& clearanceMap() const { return clearance_; }
  const NavigatorParams& params() const { return params_; }

 private:
  void takeIn(const NavigatorInputs& inputs, Time now);
  void takeEvents(const NavigatorInputs& inputs, Time now);
  void start(const NavGoal& goal, Time now);
  void finish(NavResult result, NavReason reason);
  std::optional<NavReason> missingData(const NavigatorInputs& inputs, Time now) const;
  void wait(NavReason reason, Time now);
  void pursueGoal(const NavigatorInputs& inputs, Time now);
  bool ensurePath(Time now);
  bool replan(Time now);
  bool usePath(planning::PlanResult result, Time now);
  void lookForBetter(Time now);
  void drive(const MotionPredictor::Motion& motion, Time now);
  void turn(const MotionPredictor::Motion& motion, Time now);
  FollowerInputs followerInputs(const MotionPredictor::Motion& motion, Time now) const;
  planning::PlanRequest requestFrom(const StampedPose2& pose) const;
  void blocked(Time now);
  void recover(NavReason trouble, Time now);
  void continueRecovery(Time now);
  void refreshMap(Time now);
  bool isAtGoal() const;
  void command(const Twist2& twist, NavState state, NavReason reason);

  NavigatorParams params_;
  Outline outline_;
  planning::OutlineCheck outline_on_map_;
  std::vector<RecoveryRung> ladder_;
  planning::ClearanceMap clearance_;
  planning::GlobalPlanner planner_;
  ObstacleLayer obstacles_;
  PathFollower follower_;
  MotionPredictor predictor_;
  ProgressWatchdog watchdog_;

  PoseHistory poses_;
  std::optional<StampedPose2> pose_;
  std::optional<Time> scan_stamp_;
  ScanPoints scan_;
  bool map_changed_ = false;
  bool obstacles_changed_ = false;
  Time refreshed_;

  std::optional<NavGoal> goal_;
  bool has_path_ = false;
  bool goal_is_moved_ = false;  ///< the path ends beside the goal
  bool arrived_ = false;        ///< only the direction is left
  std::size_t escape_ = 0;
  Time planned_;
  std::optional<Time> blocked_since_;
  std::optional<Time> waiting_since_;
  std::size_t rung_ = 0;
  Recovery recovery_;
  NavReason trouble_ = NavReason::kBlocked;
  std::optional<Time> last_update_;
  NavigatorOutput output_;
};

}  // namespace frontier_pilot::navigation
