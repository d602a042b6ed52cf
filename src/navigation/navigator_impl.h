#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/navigation/recovery.h"
#include "frontier_pilot/planning/outline_check.h"
#include "navigation/driven_track.h"
#include "navigation/dynamic_obstacles.h"
#include "navigation/motion_predictor.h"
#include "navigation/obstacle_layer.h"
#include "navigation/path_follower.h"
#include "navigation/progress_watchdog.h"
#include "navigation/scan_points.h"

namespace frontier_pilot::navigation {

/// The navigator's state machine: inputs, events and ends of goals in navigator.cpp, the way to a goal in
/// navigator_steps.cpp, what it does for other robots in navigator_traffic.cpp.
class Navigator::Impl {
 public:
  Impl(const NavigatorParams& params, std::vector<RecoveryRung> ladder);

  void setMap(const OccupancyGrid& map, const CellRect& changed);
  NavigatorOutput update(const NavigatorInputs& inputs, Time now);
  planning::PlanResult makePlan(const planning::PlanRequest& request);
  void clearObstacles();
  void setParameters(const NavigatorParams& params, std::vector<RecoveryRung> ladder);

  std::vector<Vec2> wayAhead() const;
  bool hasGoal() const { return goal_.has_value(); }
  bool hasPath() const { return goal_ && has_path_; }
  const PathFollower& follower() const { return follower_; }
  const planning::ClearanceMap& clearanceMap() const { return clearance_; }

 private:
  /// How near a recovery may come to what the map shows.
  struct MapFloor {
    double lane = 0.0;          ///< least clearance of the robot's position [m]
    double corner_slack = 0.0;  ///< by which corners may be nearer than on a path [m]
  };

  void takeIn(const NavigatorInputs& inputs, Time now);
  bool isBlind(const LaserScan2& scan, const Pose2& T_map_base);
  void takeEvents(const NavigatorInputs& inputs, Time now);
  void start(const NavGoal& goal, Time now);
  void finish(NavResult result, NavReason reason);
  std::optional<NavReason> missingData(const NavigatorInputs& inputs, Time now) const;
  void wait(NavReason reason, Time now);
  void pursueGoal(const NavigatorInputs& inputs, Time now);
  bool ensurePath(Time now);
  bool replan(Time now);
  bool usePath(planning::PlanResult result, Time now);
  bool endsAtGoal(const planning::Path& path) const;
  void lookForBetter(Time now);
  void drive(const MotionPredictor::Motion& motion, Time now);
  void turn(const MotionPredictor::Motion& motion, Time now);
  FollowerInputs followerInputs(const MotionPredictor::Motion& motion, Time now) const;
  planning::PlanRequest requestTo(const Vec2& place) const;
  void blocked(Time now);
  void recover(NavReason trouble, Time now);
  void continueRecovery(Time now);
  void refreshMap(Time now);
  void keepObstacles(double along);
  void leaveTrouble();
  double distanceToGoal() const;
  void leaveGoal(Time now);
  MapFloor floorAt(const Pose2& T_map_base) const;
  HasRoom staysOnSeenGround() const;
  HasRoom hasRoom() const;
  bool obey(const NavigatorInputs& inputs, Time now);
  void driveAside(const Vec2& place, const NavigatorInputs& inputs, Time now);
  bool planAside(const Vec2& place, Time now);
  void resume(Time now);
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

  grids::BlindnessCheck blindness_;
  PoseHistory poses_;
  DrivenTrack track_;
  std::optional<StampedPose2> pose_;
  std::optional<Time> scan_stamp_;
  ScanPoints scan_;
  ScanView view_;  ///< of the same scan
  DynamicObstacles dynamic_;
  Neighbours neighbours_;
  bool map_changed_ = false;
  bool obstacles_changed_ = false;
  Time refreshed_;

  std::optional<NavGoal> goal_;
  bool has_path_ = false;
  bool commands_motion_ = false;  ///< the last command was not zero: the wheels turn until the next one
  bool goal_is_moved_ = false;    ///< the path ends farther from the goal than goal_tolerance
  bool arrived_ = false;          ///< at the position; only the yaw is left
  int departures_ = 0;            ///< how often the robot left the goal, or recovered there, after it had arrived
  std::size_t escape_ = 0;
  Time planned_;
  std::optional<Time> blocked_since_;
  std::optional<Time> waiting_since_;
  std::size_t rung_ = 0;
  std::size_t rounds_ = 0;  ///< of the ladder since the way to the goal was `nearest_`
  double nearest_ = std::numeric_limits<double>::infinity();  ///< the shortest way that was left on any path [m]
  Recovery recovery_;
  std::deque<Pose2> recovery_began_;  ///< the way to where the recovery began, that pose the last
  NavReason trouble_ = NavReason::kBlocked;
  bool obeying_ = false;
  std::optional<Vec2> aside_;  ///< the place that the path leads to
  bool aside_failed_ = false;
  std::optional<Time> last_update_;
  NavigatorOutput output_;
};

}  // namespace frontier_pilot::navigation
