// The YAML files of config/ list what most people change, commented out, with the defaults.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/common/help/usages.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"
#include "ros/mapper/mapper_adapter.h"
#include "ros/navigator/navigator_adapter.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"
#include "ros/patrol_server/patrol_server_adapter.h"
#include "teleop/parameters.h"
#include "waypoints/waypoint_follower.h"

namespace frontier_pilot {
namespace {

using Row = detail::Describer::Row;

/// Set by the launch files from their arguments, after the YAML file: there they would have no effect.
const std::vector<std::string> kSetByLaunchFiles = {"autostart", "enabled", "localize_only", "map_file",
                                                    "mapper/trust_odometry"};
const std::string kTitle = "# What most people change, with its defaults:\n";

std::vector<std::string> partsOf(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream in(name);
  for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
  return parts;
}

/// The usual parameters of a node as YAML.
std::string yamlOf(const NodeUsage& usage) {
  std::vector<Row> rows = rowsNamed(usage.parameters, usage.main_parameters);
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const Row& row) {
                              return std::find(kSetByLaunchFiles.begin(), kSetByLaunchFiles.end(), row.name) !=
                                     kSetByLaunchFiles.end();
                            }),
             rows.end());
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    const auto groups = [](const Row& row) { return partsOf(row.name).size() > 1 ? partsOf(row.name)[0] : ""; };
    return groups(a) < groups(b);
  });
  std::string text;
  std::vector<std::string> open;
  for (const Row& row : rows) {
    const std::vector<std::string> parts = partsOf(row.name);
    std::size_t common = 0;
    while (common < open.size() && common + 1 < parts.size() && open[common] == parts[common]) ++common;
    open.resize(common);
    for (; open.size() + 1 < parts.size(); open.push_back(parts[open.size()])) {
      text += std::string(2 * open.size(), ' ') + parts[open.size()] + ":\n";
    }
    text += std::string(2 * open.size(), ' ') + parts.back() + ": " + row.value + "  # " +
            (row.unit.empty() ? "" : "[" + row.unit + "] ") + row.doc + "\n";
  }
  return text;
}

std::string commented(const std::string& yaml) {
  std::string text;
  std::istringstream in(yaml);
  for (std::string line; std::getline(in, line);) text += "# " + line + "\n";
  return text;
}

std::string contentsOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The list in the file is that of the node, and a node that is given it whole has its defaults.
template <class P>
void expectListed(const NodeUsage& usage, const std::string& file) {
  const std::string path = PROJECT_ROOT "/config/" + file;
  const std::string yaml = yamlOf(usage);
  const std::string text = contentsOf(path);
  const std::size_t title = text.find(kTitle);
  ASSERT_NE(title, std::string::npos) << path << " lacks the line: " << kTitle;
  const std::string wanted = text.substr(0, title) + kTitle + commented(yaml);
  if (std::getenv("FRONTIER_PILOT_WRITE_DOCS") != nullptr) std::ofstream(path) << wanted;
  EXPECT_EQ(contentsOf(path), wanted) << "run this test with FRONTIER_PILOT_WRITE_DOCS=1 to write it anew";

  P loaded;
  EXPECT_EQ(loadParameters(parseYaml(yaml), loaded), Problems());
  const std::vector<Row> values = describeParameters(loaded), defaults = describeParameters(P());
  ASSERT_EQ(values.size(), defaults.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i].value, defaults[i].value) << values[i].name;
}

TEST(UsualParameters, AreListedWithTheirDefaultsInTheConfigurationOfEachNode) {
  expectListed<ObstacleAvoiderNodeParameters>(obstacleAvoiderUsage(), "avoider.yaml");
  expectListed<PatrolServerParameters>(patrolServerUsage(), "patrol.yaml");
  expectListed<BehaviorServerParameters>(behaviorServerUsage(), "behavior.yaml");
  expectListed<MapperNodeParameters>(mapperUsage(), "mapper.yaml");
  expectListed<NavigatorNodeParameters>(navigatorUsage(), "navigator.yaml");
  expectListed<waypoints::WaypointParameters>(waypointFollowerUsage(), "waypoints.yaml");
  expectListed<ExplorerNodeParameters>(frontierExplorerUsage(), "explorer.yaml");
  expectListed<teleop::TeleopParameters>(teleopGuiUsage(), "teleop.yaml");
}

}  // namespace
}  // namespace frontier_pilot
