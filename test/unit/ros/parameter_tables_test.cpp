// The parameters of every node: the tables in docs/parameters.md and the YAML files that the package ships.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/ros/behavior_server_adapter.h"
#include "frontier_pilot/ros/cmd_vel_arbiter_adapter.h"
#include "frontier_pilot/ros/explorer_adapter.h"
#include "frontier_pilot/ros/mapper_adapter.h"
#include "frontier_pilot/ros/navigator_adapter.h"
#include "frontier_pilot/ros/obstacle_avoider_adapter.h"
#include "frontier_pilot/ros/patrol_server_adapter.h"
#include "frontier_pilot/ros/simulator_adapter.h"
#include "frontier_pilot/teleop/parameters.h"

namespace frontier_pilot {
namespace {

const std::string kRoot = PROJECT_ROOT;

template <class P>
std::string table(const std::string& node) {
  const P defaults;
  return "\n## " + node + "\n\n" + tabulateRows(describeParameters(defaults));
}

std::string allTables() {
  return "# Parameters\n\n"
         "Each stands in its node's private namespace; `a/b` is the key `b` in the dictionary `a`. A key that is not\n"
         "here, a value of the wrong type or out of bounds stops the node at start, all of them named at once.\n"
         "This page is made from the parameter structs; `scripts/test` fails when it is not up to date.\n" +
         table<SimulatorNodeParameters>("simulator") + table<ArbiterParameters>("cmd_vel_arbiter") +
         table<ObstacleAvoiderNodeParameters>("obstacle_avoider") + table<PatrolServerParameters>("patrol_server") +
         table<BehaviorServerParameters>("behavior_server") + table<MapperNodeParameters>("mapper") +
         table<NavigatorNodeParameters>("navigator") + table<ExplorerNodeParameters>("frontier_explorer") +
         table<TeleopParameters>("teleop_gui");
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
  expectGood<ArbiterParameters>("arbiter.yaml");
  expectGood<ArbiterParameters>("arbiter_avoid_required.yaml");
  expectGood<ObstacleAvoiderNodeParameters>("avoider.yaml");
  expectGood<PatrolServerParameters>("patrol.yaml");
  expectGood<BehaviorServerParameters>("behavior.yaml");
  expectGood<BehaviorServerParameters>("behavior_waffle.yaml");
  expectGood<MapperNodeParameters>("mapper.yaml");
  expectGood<NavigatorNodeParameters>("navigator.yaml");
  expectGood<ExplorerNodeParameters>("explorer.yaml");
  expectGood<TeleopParameters>("teleop.yaml");
  expectGood<RobotLimits>("limits_burger.yaml");
  expectGood<RobotLimits>("limits_fast.yaml");
}

}  // namespace
}  // namespace frontier_pilot
