#pragma once

#include <string>

/// The names of all topics, services, actions and frames. They are relative, so that a second robot needs only a
/// namespace; /clock and TF are shared.
namespace frontier_pilot::names {

/// The name of a topic or frame of the robot `robot`, for a node that serves several; without a robot its own.
inline std::string ofRobot(const std::string& robot, const std::string& name) {
  return robot.empty() ? name : robot + "/" + name;
}

// Velocities (geometry_msgs/Twist)
constexpr const char* kCmdVel = "cmd_vel";
constexpr const char* kCmdVelAvoid = "cmd_vel_avoid";
constexpr const char* kCmdVelBehavior = "cmd_vel_behavior";
constexpr const char* kCmdVelPatrol = "cmd_vel_patrol";
constexpr const char* kCmdVelNav = "cmd_vel_nav";
constexpr const char* kCmdVelManual = "cmd_vel_manual";

// Nodes whose parameters are read by another node
constexpr const char* kNavigatorNode = "navigator";
constexpr const char* kObstacleAvoiderNode = "obstacle_avoider";
constexpr const char* kTeleopGuiNode = "teleop_gui";

// Sensors and the simulator's truth
constexpr const char* kScan = "scan";
constexpr const char* kOdom = "odom";
constexpr const char* kGroundTruth = "base_pose_ground_truth";
constexpr const char* kStalled = "simulator/stalled";
constexpr const char* kWorld = "simulator/world";
constexpr const char* kClock = "/clock";  // ROS' own, shared by all robots
constexpr const char* kTf = "/tf";
constexpr const char* kTfStatic = "/tf_static";

// Simulator services
constexpr const char* kResetPositions = "reset_positions";
constexpr const char* kSetPose = "simulator/set_pose";
constexpr const char* kSpawnObstacle = "simulator/spawn_obstacle";
constexpr const char* kRemoveObstacle = "simulator/remove_obstacle";
constexpr const char* kPauseSimulator = "simulator/pause";

// Arbiter
constexpr const char* kArbiterStatus = "cmd_vel_arbiter/status";
constexpr const char* kEmergencyStopState = "emergency_stop_state";
constexpr const char* kEmergencyStop = "emergency_stop";
constexpr const char* kFleetEmergencyStop = "fleet/emergency_stop";
constexpr const char* kFleetStopStatus = "fleet/stop_status";
constexpr const char* kSetEmergencyStop = "set_emergency_stop";
/// The service that enables or disables a source of the arbiter.
inline std::string setEnabled(const std::string& source) { return "set_" + source + "_enabled"; }

// Obstacle avoider
constexpr const char* kAvoiderStatus = "obstacle_avoider/status";
constexpr const char* kAvoiderUpdates = "obstacle_avoider/parameter_updates";
constexpr const char* kSetObstacleAvoidEnabled = "set_obstacle_avoid_enabled";

// Mapper
constexpr const char* kMap = "map";
constexpr const char* kMapUpdates = "map_updates";
constexpr const char* kMapMetadata = "map_metadata";
/// The topic of a map's changes in few bytes. It follows from that of the map, so that who remaps the one never listens
/// to the other of another map.
inline std::string changesOf(const std::string& map) { return map + "_changes"; }
constexpr const char* kMergedMap = "merged_map";
constexpr const char* kMergedMapUpdates = "merged_map_updates";
constexpr const char* kMergedMapMetadata = "merged_map_metadata";
constexpr const char* kDynamicMap = "dynamic_map";
constexpr const char* kSaveMap = "mapper/save_map";
constexpr const char* kSaveMergedMap = "map_merger/save_map";
constexpr const char* kLoadMap = "mapper/load_map";
constexpr const char* kLocalize = "mapper/localize";
constexpr const char* kLocalized = "mapper/localized";
constexpr const char* kMapReplaced = "mapper/replaced";
constexpr const char* kResetMap = "mapper/reset";
constexpr const char* kInitialPose = "initialpose";  // rviz' own name

// Navigator
constexpr const char* kMoveBase = "move_base";
constexpr const char* kSimpleGoal = "move_base_simple/goal";
constexpr const char* kMakePlan = "make_plan";
constexpr const char* kClearCostmaps = "clear_costmaps";
constexpr const char* kPlan = "plan";
constexpr const char* kLocalPlan = "local_plan";
constexpr const char* kLocalCostmap = "local_costmap";
constexpr const char* kGlobalCostmap = "global_costmap";
constexpr const char* kNavigatorStatus = "navigator/status";
constexpr const char* kNavigatorProgress = "navigator/progress";
constexpr const char* kCurrentGoal = "move_base/current_goal";

// Waypoint follower
constexpr const char* kFollowWaypoints = "follow_waypoints";  // action
constexpr const char* kAddWaypoint = "waypoint_follower/add";
constexpr const char* kStartWaypoints = "waypoint_follower/start";
constexpr const char* kClearWaypoints = "waypoint_follower/clear";
constexpr const char* kWaypoints = "waypoint_follower/waypoints";

// Explorer
constexpr const char* kExplorerStatus = "frontier_explorer/status";
constexpr const char* kFrontiers = "frontier_explorer/frontiers";
constexpr const char* kFrontierCells = "cells";  // namespace of the markers of cells
constexpr const char* kExplorerGoal = "frontier_explorer/goal";
constexpr const char* kExplainExplorer = "frontier_explorer/explain";
constexpr const char* kResetExplorer = "frontier_explorer/reset";
constexpr const char* kSetExplorationBounds = "frontier_explorer/set_bounds";
constexpr const char* kClearExplorationBounds = "frontier_explorer/clear_bounds";
constexpr const char* kInspect = "frontier_explorer/inspect";
constexpr const char* kClearInspections = "frontier_explorer/clear_inspections";
constexpr const char* kSetReturnToStart = "frontier_explorer/set_return_to_start";
constexpr const char* kClickedPoint = "clicked_point";  // rviz' own name
constexpr const char* kBatteryState = "battery_state";
constexpr const char* kFleetClaims = "/fleet/claims";    // shared by all robots
constexpr const char* kFleetMotions = "/fleet/motions";  // shared by all robots
constexpr const char* kSetExplorationEnabled = "set_exploration_enabled";

// Actions
constexpr const char* kGoalOfAction = "/goal";  // after the action's name
constexpr const char* kPatrol = "turtlebot3";
constexpr const char* kPatrolStatus = "turtlebot3/status";
constexpr const char* kSpin = "spin";
constexpr const char* kBackUp = "back_up";
constexpr const char* kDriveOnHeading = "drive_on_heading";
constexpr const char* kWait = "wait";
constexpr const char* kFootprint = "footprint";  // topic: the robot's outline in its base frame

// dynamic_reconfigure's own, in the private namespace of a node
constexpr const char* kParameterDescriptions = "parameter_descriptions";
constexpr const char* kParameterUpdates = "parameter_updates";
constexpr const char* kSetParameters = "set_parameters";

// Frames (REP 103, REP 105); `world` is the simulator's
constexpr const char* kWorldFrame = "world";
constexpr const char* kMapFrame = "map";
constexpr const char* kOdomFrame = "odom";
constexpr const char* kBaseFootprintFrame = "base_footprint";
constexpr const char* kBaseLinkFrame = "base_link";
constexpr const char* kBaseScanFrame = "base_scan";

}  // namespace frontier_pilot::names
