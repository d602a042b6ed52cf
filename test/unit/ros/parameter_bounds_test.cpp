// What no node may be configured with, whatever its parameters are: numbers without a greatest value, times and rates
// that size a timer, speeds that no robot has, frames that TF cannot have.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/check_robot/check_robot_adapter.h"
#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/fleet_stop/fleet_stop_adapter.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"
#include "ros/map_merger/map_merger_adapter.h"
#include "ros/mapper/mapper_adapter.h"
#include "ros/navigator/navigator_adapter.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"
#include "ros/patrol_server/patrol_server_adapter.h"
#include "ros/simulator/simulator_adapter.h"
#include "teleop/parameters.h"
#include "waypoints/waypoint_follower.h"

namespace frontier_pilot {
namespace {

using Row = detail::Describer::Row;

template <class P>
void appendRows(const std::string& node, std::vector<Row>& rows) {
  for (Row& row : describeParameters(P())) {
    row.name.insert(0, node + ": ");
    rows.push_back(row);
  }
}

std::vector<Row> rowsOfAllNodes() {
  std::vector<Row> rows;
  appendRows<SimulatorNodeParameters>("simulator", rows);
  appendRows<arbiter::ArbiterParameters>("cmd_vel_arbiter", rows);
  appendRows<ObstacleAvoiderNodeParameters>("obstacle_avoider", rows);
  appendRows<PatrolServerParameters>("patrol_server", rows);
  appendRows<BehaviorServerParameters>("behavior_server", rows);
  appendRows<MapperNodeParameters>("mapper", rows);
  appendRows<MapMergerNodeParameters>("map_merger", rows);
  appendRows<FleetStopParameters>("fleet_stop", rows);
  appendRows<NavigatorNodeParameters>("navigator", rows);
  appendRows<waypoints::WaypointParameters>("waypoint_follower", rows);
  appendRows<ExplorerNodeParameters>("frontier_explorer", rows);
  appendRows<teleop::TeleopParameters>("teleop_gui", rows);
  appendRows<CheckRobotParameters>("check_robot", rows);
  return rows;
}

/// The problems of the line `yaml` of a configuration, as one text.
template <class P>
std::string refusal(const std::string& yaml) {
  P parameters;
  std::string text;
  for (const std::string& problem : loadParameters(parseYaml(yaml), parameters)) text += problem + "\n";
  return text;
}

template <class P>
void expectRefused(const std::string& yaml, const std::string& name) {
  EXPECT_EQ(refusal<P>(yaml).rfind(name + ": ", 0), 0U) << "'" << yaml << "' gives '" << refusal<P>(yaml) << "'";
}

// [FLT-1]
TEST(ParameterBounds, EveryNumberHasAGreatestValue_FLT_1) {
  int numbers = 0;
  for (const Row& row : rowsOfAllNodes()) {
    if (row.type == "bool" || row.type == "string") continue;
    EXPECT_NE(row.bounds.find("<="), std::string::npos) << row.name << " (" << row.type << "): '" << row.bounds << "'";
    ++numbers;
  }
  EXPECT_GT(numbers, 100);
}

// [FLT-1]
TEST(ParameterBounds, NoTimerIsMadeOfWhatNoTimerKeeps_FLT_1) {
  for (const char* rate : {"1e12", "1e-300", "0.01", "2000"}) {
    expectRefused<ExplorerNodeParameters>(std::string("rate: ") + rate, "rate");
  }
  for (const char* period : {"1e-300", "1e-6", "1e300"}) {
    expectRefused<ExplorerNodeParameters>(std::string("report_period: ") + period, "report_period");
    expectRefused<MapperNodeParameters>(std::string("update_period: ") + period, "update_period");
    expectRefused<MapperNodeParameters>(std::string("autosave_period: ") + period, "autosave_period");
  }
  EXPECT_EQ(refusal<MapperNodeParameters>("autosave_period: 0.0"), "") << "never";
  expectRefused<SimulatorNodeParameters>("{world: w, speed: 1e300}", "speed");
}

// [FLT-1]
TEST(ParameterBounds, NoRobotIsFasterOrSeesFartherThanAny_FLT_1) {
  expectRefused<RobotLimits>("max_linear: 21.0", "max_linear");
  expectRefused<RobotLimits>("max_angular: 1e308", "max_angular");
  expectRefused<RobotLimits>("max_linear_acc: 1e308", "max_linear_acc");
  expectRefused<RobotLimits>("max_angular_acc: 1001", "max_angular_acc");
  expectRefused<RobotModel>("scanner: {range_max: 1e300}", "scanner/range_max");
  expectRefused<RobotModel>("watchdog: 1e300", "watchdog");
}

// [FLT-1]
TEST(ParameterBounds, NoPathLeavesMoreRoomThanARobotNeeds_FLT_1) {
  expectRefused<ExplorerNodeParameters>("frontier: {clearance_margin: 5000.0}", "frontier/clearance_margin");
  expectRefused<ExplorerNodeParameters>("frontier: {obstacle_radius_cells: 41}", "frontier/obstacle_radius_cells");
  expectRefused<ExplorerNodeParameters>("frontier: {min_distance: 1e300}", "frontier/min_distance");
}

// [FLT-1] With less a robot hardly moves, and what is computed until it stands has no end.
TEST(ParameterBounds, NoRobotIsSlowerThanAMillimetreASecond_FLT_1) {
  expectRefused<NavigatorNodeParameters>("robot: {limits: {max_angular_acc: 1e-18}}", "robot/limits/max_angular_acc");
  expectRefused<teleop::TeleopParameters>("linear_step: 1e-10", "linear_step");
  expectRefused<teleop::TeleopParameters>("angular_step: 1e-10", "angular_step");
}

// [FLT-1] Eight minutes, where half a second was meant.
TEST(ParameterBounds, NoRobotDrivesByOldData_FLT_1) {
  expectRefused<NavigatorNodeParameters>("max_age: 500", "max_age");
  expectRefused<BehaviorServerParameters>("pose_timeout: 500", "pose_timeout");
  expectRefused<BehaviorServerParameters>("costmap_timeout: 500", "costmap_timeout");
  expectRefused<PatrolServerParameters>("odometry_timeout: 500", "odometry_timeout");
  expectRefused<ObstacleAvoiderNodeParameters>("max_scan_age: 500", "max_scan_age");
  expectRefused<BehaviorServerParameters>("simulate_ahead_time: 1e6", "simulate_ahead_time");
}

// A transform from a frame to itself is none: TF would have no map -> odom. [FLT-1]
TEST(ParameterBounds, TheFramesOfMapOdometryAndRobotDiffer_FLT_1) {
  expectRefused<MapperNodeParameters>("map_frame: odom", "map_frame");
  expectRefused<MapperNodeParameters>("map_frame: base_footprint", "map_frame");
  expectRefused<MapperNodeParameters>("{map_frame: world, odom_frame: world}", "map_frame");
  expectRefused<MapperNodeParameters>("base_frame: odom", "odom_frame");
  expectRefused<ExplorerNodeParameters>("map_frame: base_footprint", "map_frame");
  expectRefused<ExplorerNodeParameters>("base_frame: map", "map_frame");
  expectRefused<NavigatorNodeParameters>("map_frame: base_footprint", "map_frame");
  expectRefused<BehaviorServerParameters>("base_frame: odom", "odom_frame");
  expectRefused<RobotModel>("base_frame: odom", "base_frame");
  EXPECT_EQ(refusal<MapperNodeParameters>("{map_frame: world, odom_frame: map, base_frame: odom}"), "");
  EXPECT_EQ(refusal<NavigatorNodeParameters>("map_frame: odom"), "") << "a map that does not correct odometry";
}

// [FLT-1]
TEST(ParameterBounds, AFrameThatTfCannotHaveIsRefused_FLT_1) {
  for (const char* frame : {"''", "/map"}) {
    const std::string yaml = std::string("map_frame: ") + frame;
    expectRefused<ExplorerNodeParameters>(yaml, "map_frame");
    expectRefused<NavigatorNodeParameters>(yaml, "map_frame");
    expectRefused<MapperNodeParameters>(yaml, "map_frame");
    expectRefused<RobotModel>(std::string("base_frame: ") + frame, "base_frame");
    expectRefused<RobotModel>(std::string("odom_frame: ") + frame, "odom_frame");
  }
  expectRefused<ExplorerNodeParameters>("base_frame: /base_link", "base_frame");
  expectRefused<NavigatorNodeParameters>("base_frame: /base_link", "base_frame");
  expectRefused<MapperNodeParameters>("base_frame: /base_link", "base_frame");
  expectRefused<MapperNodeParameters>("odom_frame: /odom", "odom_frame");
  EXPECT_EQ(refusal<ExplorerNodeParameters>("base_frame: ''"), "") << "the robot's";
}

}  // namespace
}  // namespace frontier_pilot
