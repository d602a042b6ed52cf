#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/ros/diagnostics.h"
#include "frontier_pilot/ros/node_connections.h"

namespace frontier_pilot {

/// A copy of `map`, kept up to date by `map_updates`, that knows which cells changed since they were last taken.
/// What is malformed is counted and warned of, and leaves the copy as it was. A well-formed map always replaces the
/// copy, also a smaller one (a mapper that started over), which is said in the log.
class MapMirror {
 public:
  /// Begins to listen. Maps in another frame than `frame` are refused.
  void subscribe(NodeConnections& connections, const std::string& frame);

  void handleMap(const nav_msgs::OccupancyGrid& msg);
  void handleUpdate(const map_msgs::OccupancyGridUpdate& msg);

  /// Whether somebody publishes the map now.
  bool published() const { return map_subscriber_.getNumPublishers() > 0; }
  /// Whether a map has come yet.
  bool ready() const { return !map_.empty(); }
  const OccupancyGrid& map() const { return map_; }
  /// When the copy was last changed or confirmed.
  Time stamp() const { return stamp_; }
  /// The cells that may differ from what was there at the last call; all of them when the geometry is another one.
  CellRect takeChanged();
  const Rejections& rejections() const { return rejections_; }

 private:
  bool rightFrame(const std::string& frame);
  void replace(OccupancyGrid map);

  std::string frame_;
  OccupancyGrid map_;
  CellRect changed_;
  Time stamp_{};
  Rejections rejections_{"map message"};
  ros::Subscriber map_subscriber_;
};

}  // namespace frontier_pilot
