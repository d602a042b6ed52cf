#include <frontier_pilot/MapChanges.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/help/usages.h"
#include "ros/common/names.h"
#include "ros/map_merger/map_merger_adapter.h"

namespace frontier_pilot {

NodeUsage mapMergerUsage() {
  NodeUsage usage;
  usage.name = "map_merger";
  usage.purpose =
      "Puts the maps of several robots together: one map in a common frame, where each robot's map lies in it, and\n"
      "for each robot a map in its own frame in which it also sees what the others know.";
  const auto ofEach = [](const char* name) { return names::ofRobot("ROBOT", name); };
  usage.reads = {port<nav_msgs::OccupancyGrid>(ofEach(names::kMap)),
                 port<map_msgs::OccupancyGridUpdate>(ofEach(names::kMapUpdates)),
                 port<MapChanges>(names::changesOf(ofEach(names::kMap))), port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.publishes = {port<nav_msgs::OccupancyGrid>(names::kMap),
                     port<map_msgs::OccupancyGridUpdate>(names::kMapUpdates),
                     port<MapChanges>(names::changesOf(names::kMap)),
                     port<nav_msgs::MapMetaData>(names::kMapMetadata),
                     port<nav_msgs::OccupancyGrid>(ofEach(names::kMergedMap)),
                     port<map_msgs::OccupancyGridUpdate>(ofEach(names::kMergedMapUpdates)),
                     port<MapChanges>(names::changesOf(ofEach(names::kMergedMap))),
                     port<nav_msgs::MapMetaData>(ofEach(names::kMergedMapMetadata)),
                     port<tf2_msgs::TFMessage>(names::kTf)};
  usage.services = {servicePort<SaveMap>(names::kSaveMergedMap)};
  usage.main_parameters = {"known_starts", "max_contradicted"};
  usage.parameters = describeParameters(MapMergerNodeParameters());
  usage.example = "rosrun frontier_pilot map_merger _robots:=\"[{name: robot1, x: 0.0}, {name: robot2, x: 1.5}]\"";
  return usage;
}

}  // namespace frontier_pilot
