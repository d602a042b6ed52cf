#pragma once

#include <ros/node_handle.h>

#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/map_schedule.h"
#include "ros/common/maps/map_changes_publisher.h"

namespace frontier_pilot {

/// The topics of a map.
struct MapTopics {
  std::string map, updates, metadata;
};

/// Publishes a map that changes: changes at once, the whole map less often, and both in few bytes, as the mapper does.
/// [MUL-1]
class GridPublisher {
 public:
  GridPublisher(ros::NodeHandle& node, const MapTopics& topics, std::string frame,
                const mapping::MapScheduleParameters& schedule);
  GridPublisher(const GridPublisher&) = delete;
  GridPublisher& operator=(const GridPublisher&) = delete;

  /// `changed` are the cells that have changed since the last call. An empty map is not published.
  void publish(const OccupancyGrid& map, const CellRect& changed, Time now);

 private:
  std::string frame_;
  mapping::MapSchedule schedule_;
  GridGeometry geometry_;  ///< of the last map
  ros::Publisher map_;
  ros::Publisher updates_;
  ros::Publisher metadata_;
  MapChangesPublisher compact_;
};

}  // namespace frontier_pilot
