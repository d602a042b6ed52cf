#pragma once

#include <frontier_pilot/SaveMap.h>

#include <functional>
#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/service_thread.h"

namespace frontier_pilot {

/// Serves `mapper/save_map` on a thread of its own: writing and reading back a large map takes long. The node's
/// thread only encodes the map's picture and copies its cells.
class MapSaver {
 public:
  /// See ServiceThread.
  void serve(NodeConnections& connections);
  void provide(occupancy::OccupancyMap& map) { thread_.answer(map); }
  /// Queues `job` for this object's thread; an exception that it throws is caught and logged.
  void run(std::function<void()> job);
  void close() { thread_.close(); }

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);
  map_files::MapIoResult save(const std::string& path);

  ServiceThread<occupancy::OccupancyMap> thread_;
};

}  // namespace frontier_pilot
