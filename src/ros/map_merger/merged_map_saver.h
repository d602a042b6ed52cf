#pragma once

#include <frontier_pilot/SaveMap.h>

#include "frontier_pilot/core/grid.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/service_thread.h"

namespace frontier_pilot {

/// Serves `map_merger/save_map` on a thread of its own, because writing a large map takes long. The node's thread only
/// copies the common map.
class MergedMapSaver {
 public:
  /// See ServiceThread.
  void serve(NodeConnections& connections);
  void provide(const OccupancyGrid& map) { thread_.answer(map); }
  void close() { thread_.close(); }

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);

  ServiceThread<const OccupancyGrid> thread_;
};

}  // namespace frontier_pilot
