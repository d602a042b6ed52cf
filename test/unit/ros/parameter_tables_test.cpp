// The parameters of every node: the tables in docs/parameters.md and the YAML files that the package ships.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"
#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/check_robot/check_robot_adapter.h"
#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/help/usages.h"
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

const std::string kRoot = PROJECT_ROOT;

using Rows = std::vector<detail::Describer::Row>;

/// The rows of the robot and of the frames are those of many nodes: they have tables of their own.
bool isOfManyNodes(const detail::Describer::Row& row) {
  return row.name.rfind("robot/", 0) == 0 || row.name == "map_frame" || row.name == "odom_frame" ||
         row.name == "base_frame";
}

/// The table of a node, with what most people change before the rest.
std::string table(const NodeUsage& usage) {
  const Rows often = rowsNamed(usage.parameters, usage.main_parameters);
  EXPECT_EQ(often.size(), usage.main_parameters.size()) << usage.name << " lacks one of its main parameters";
  const auto is_often = [&](const std::string& name) {
    return std::find(usage.main_parameters.begin(), usage.main_parameters.end(), name) != usage.main_parameters.end();
  };
  Rows rest;
  for (const auto& row : withOneItem(usage.parameters)) {
    if (!is_often(row.name) && !isOfManyNodes(row)) rest.push_back(row);
  }
  std::string text = "\n## " + usage.name + "\n\nWhat most people change:\n\n" + tabulateRows(often);
  if (!rest.empty()) text += "\nThe rest:\n\n" + tabulateRows(rest);
  return text;
}

struct Frames {
  std::string map_frame = "map";
  std::string odom_frame;
  std::string base_frame;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("map_frame", map_frame, "", "frame of the map", FrameName::kGiven);
    v.field("odom_frame", odom_frame, "", "frame of odometry; empty: robot/odom_frame", FrameName::kMayBeEmpty);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
  }
};

std::string frameTable() {
  return "\n## Frames\n\n"
         "`map_frame` of mapper, navigator, frontier_explorer, check_robot and map_merger, `odom_frame` of mapper and "
         "behavior_server,\n`base_frame` of the first three, behavior_server and obstacle_avoider.\n\n" +
         tabulateRows(describeParameters(Frames()));
}

struct RobotGroup {
  RobotModel robot;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
  }
};

std::string robotTable() {
  return "\n## The robot\n\n"
         "Every node reads these, from the file that the launch files' argument `robot` names: see "
         "[robots](robots.md).\n"
         "`limits/...` beside `robot/...` overrides `robot/limits/...`. The defaults are a TurtleBot3 Burger's.\n"
         "The `limits/...` (↻) of the nodes that command the base may change while they run.\n\n" +
         tabulateRows(describeParameters(RobotGroup()));
}

std::string allTables() {
  return "# Parameters\n\n"
         "Each stands in its node's private namespace; `a/b` is the key `b` in the dictionary `a`. A key that is not\n"
         "here, a value of the wrong type or out of bounds stops the node at start, all of them named at once.\n"
         "A parameter with the sign ↻ may change while its node runs: see [tuning](tuning.md#while-it-runs).\n"
         "This page is made from the parameter structs; `scripts/test` fails when it is not up to date.\n" +
         robotTable() + frameTable() + table(simulatorUsage()) + table(cmdVelArbiterUsage()) +
         table(obstacleAvoiderUsage()) + table(patrolServerUsage()) + table(behaviorServerUsage()) +
         table(mapperUsage()) + table(mapMergerUsage()) + table(fleetStopUsage()) + table(navigatorUsage()) +
         table(waypointFollowerUsage()) + table(frontierExplorerUsage()) + table(teleopGuiUsage()) +
         table(checkRobotUsage());
}

TEST(ParameterTables, TheDocumentedOnesAreThoseOfTheStructs) {
  const std::string path = kRoot + "/docs/parameters.md";
  if (std::getenv("FRONTIER_PILOT_WRITE_DOCS") != nullptr) std::ofstream(path) << allTables();
  std::ifstream file(path);
  std::stringstream written;
  written << file.rdbuf();
  EXPECT_TRUE(written.str() == allTables())
      << path << " is out of date: run this test with FRONTIER_PILOT_WRITE_DOCS=1 to write it anew";
}

// The names of what a file sets; a list of dictionaries is not looked into.
std::vector<std::string> namesIn(const ParameterMap& map, const std::string& prefix = {}) {
  std::vector<std::string> names;
  for (const auto& [key, value] : map) {
    if (const auto* group = std::get_if<ParameterMap>(&value.value)) {
      for (const std::string& name : namesIn(*group, prefix + key + "/")) names.push_back(name);
    } else {
      names.push_back(prefix + key);
    }
  }
  return names;
}

template <class P>
std::map<std::string, std::string> valuesOf(const P& parameters) {
  std::map<std::string, std::string> values;
  for (const auto& row : describeParameters(parameters)) values[row.name] = row.value;
  return values;
}

// Accepted, and a default stands in its struct alone.
template <class P>
void expectGood(const std::string& file) {
  P parameters;
  auto defaults = valuesOf(parameters);
  const ParameterMap yaml = loadYamlFile(kRoot + "/config/" + file);
  const Problems problems = loadParameters(yaml, parameters);
  auto values = valuesOf(parameters);
  for (const std::string& name : namesIn(yaml)) {
    if (defaults.count(name) == 0) continue;
    EXPECT_NE(values[name], defaults[name]) << file << " restates " << name;
  }
  for (const std::string& problem : problems) {
    // The launch files add what no shipped file can know.
    if (problem.rfind("world:", 0) != 0) ADD_FAILURE() << file << ": " << problem;
  }
}

TEST(ShippedConfigurations, AreAllAcceptedByTheNodesTheyAreFor) {
  expectGood<SimulatorNodeParameters>("simulator.yaml");
  expectGood<SimulatorNodeParameters>("robots.yaml");
  expectGood<arbiter::ArbiterParameters>("arbiter.yaml");
  expectGood<arbiter::ArbiterParameters>("arbiter_avoid_required.yaml");
  expectGood<ObstacleAvoiderNodeParameters>("avoider.yaml");
  expectGood<PatrolServerParameters>("patrol.yaml");
  expectGood<BehaviorServerParameters>("behavior.yaml");
  expectGood<MapperNodeParameters>("mapper.yaml");
  expectGood<MapMergerNodeParameters>("robots.yaml");
  expectGood<NavigatorNodeParameters>("navigator.yaml");
  expectGood<waypoints::WaypointParameters>("waypoints.yaml");
  expectGood<ExplorerNodeParameters>("explorer.yaml");
  expectGood<teleop::TeleopParameters>("teleop.yaml");
  expectGood<RobotLimits>("limits_fast.yaml");
}

// [ROB-1]
TEST(ShippedConfigurations, AreAllRobotsThatAreAcceptedByEveryNode_ROB_1) {
  for (const char* name : {"burger", "waffle", "turtlebot2", "fast"}) {
    expectGood<RobotModel>("robots/" + std::string(name) + ".yaml");
  }
}

// [ROB-1]
TEST(RobotParameters, StandOnceInTheDocumentationAndAreTakenByEveryNode_ROB_1) {
  const auto takes = [](auto parameters) {
    const Problems problems =
        loadParameters(parseYaml("{robot: {disc_radius: 0.0}, limits: {max_linear: 0.1}}"), parameters);
    return std::none_of(problems.begin(), problems.end(), [](const std::string& problem) {
      return problem.rfind("robot", 0) == 0 || problem.rfind("limits", 0) == 0;
    });
  };
  EXPECT_TRUE(takes(arbiter::ArbiterParameters()));
  EXPECT_TRUE(takes(ObstacleAvoiderNodeParameters()));
  EXPECT_TRUE(takes(PatrolServerParameters()));
  EXPECT_TRUE(takes(BehaviorServerParameters()));
  EXPECT_TRUE(takes(MapperNodeParameters()));
  EXPECT_TRUE(takes(ExplorerNodeParameters()));
  EXPECT_TRUE(takes(teleop::TeleopParameters()));
  EXPECT_TRUE(takes(SimulatorNodeParameters()));
  EXPECT_TRUE(takes(NavigatorNodeParameters()));
  EXPECT_TRUE(takes(CheckRobotParameters()));
}

// It overrides the limits of any robot, so that it has to say what the defaults say.
TEST(ShippedConfigurations, HaveTheBurgersLimitsForEveryRobot) {
  RobotLimits limits;
  limits.max_linear = limits.max_angular = 9.0;
  EXPECT_TRUE(loadParameters(loadYamlFile(kRoot + "/config/limits_burger.yaml"), limits).empty());
  EXPECT_EQ(limits.max_linear, RobotLimits().max_linear);
  EXPECT_EQ(limits.max_angular, RobotLimits().max_angular);
}

}  // namespace
}  // namespace frontier_pilot
