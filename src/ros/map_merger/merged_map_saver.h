#pragma once

#include <frontier_pilot/SaveMap.h>

#include "frontier_pilot/core/grid.h"
#include "ros/common/maps/map_saves.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/service_thread.h"

namespace frontier_pilot {

/// Serves `map_merger/save_map` on threads of its own, because writing a large map takes long, and a disk may hang. The
/// node's thread only copies the common map.
class MergedMapSaver {
 public:
  /// See ServiceThread.
  void serve(NodeConnections& connections);
  void provide(const OccupancyGrid& map) { thread_.answer(map); }
  const MapSaves& saves() const { return saves_; }
  void close() { thread_.close(); }

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);

  MapSaves saves_;
  ServiceThread<const OccupancyGrid> thread_{MapSaves::kMost + 1};  ///< one for each save, and one that refuses others
};

}  // namespace frontier_pilot
