#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <list>
#include <string>

#include "frontier_pilot/fleet/map_merger.h"
#include "frontier_pilot/mapping/parameters.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/map_mirror.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/threads/worker.h"
#include "ros/map_merger/grid_publisher.h"
#include "ros/map_merger/merged_map_saver.h"

namespace frontier_pilot {

struct MapMergerNodeParameters : fleet::MapMergerParameters {
  std::string map_frame = names::kMapFrame;
  double rate = 10.0;  ///< [Hz]
  mapping::MapScheduleParameters publishing;

  template <class Visitor>
  void describe(Visitor& v) {
    fleet::MapMergerParameters::describe(v);
    v.field("map_frame", map_frame, "", "frame of the common map", FrameName::kGiven);
    v.field("rate", rate, "Hz", "how often maps are put together and their places are published", between(1.0, 100.0));
    v.group("publishing", publishing, "when whole maps are sent");
  }
  void check(Problems& problems) const {
    fleet::MapMergerParameters::check(problems);
    for (const fleet::FleetRobot& robot : robots) {
      if (!robot.name.empty() && names::ofRobot(robot.name, names::kMapFrame) == map_frame)
        problems.push_back("map_frame: is the frame of the map of '" + robot.name + "' as well, '" + map_frame + "'");
    }
  }
};

/// The node `map_merger`: listens to the robots' maps, and publishes the common map, each robot's view of it, and where
/// the robots' maps lie in it. [MUL-1]
class MapMergerAdapter {
 public:
  MapMergerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  ~MapMergerAdapter() {
    ending_ = true;
    saver_.close();
  }
  MapMergerAdapter(const MapMergerAdapter&) = delete;
  MapMergerAdapter& operator=(const MapMergerAdapter&) = delete;

 private:
  /// One robot's map and view.
  struct Robot {
    Robot(ros::NodeHandle& node, const std::string& robot, const mapping::MapScheduleParameters& schedule);
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    std::string name;
    std::string frame;  ///< of its map
    MapMirror map;
    GridPublisher view;
  };

  void tick(Time now);
  void searchPlaces(Time now);
  void takeRivals();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  std::string describeMerge(std::size_t robot) const;

  MapMergerNodeParameters parameters_;
  fleet::MapMerger merger_;
  TfBridge tf_;
  std::list<Robot> robots_;
  GridPublisher common_;
  std::string topic_;  ///< of the common map, resolved
  std::string rival_;  ///< a node that publishes it as well; empty if there is none
  NodeDiagnostics diagnostics_;
  MergedMapSaver saver_;
  NodeConnections connections_;
  std::atomic<bool> ending_{false};  ///< read on the searcher's thread
  Worker<fleet::PlaceFinding> searcher_;
};

}  // namespace frontier_pilot
