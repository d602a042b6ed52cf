#pragma once

#include <frontier_pilot/SaveMap.h>

#include <functional>
#include <memory>
#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/maps/map_saves.h"
#include "ros/common/maps/mapped_way.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/service_thread.h"

namespace frontier_pilot {

/// Serves `mapper/save_map` on threads of its own: writing and reading back a large map takes long, and a disk may
/// hang, that of one save or that of the copy. The node's thread only encodes the map's picture and copies its cells.
class MapSaver {
 public:
  /// See ServiceThread.
  void serve(NodeConnections& connections);
  void provide(occupancy::OccupancyMap& map) { thread_.answer(map); }
  /// Queues `job`, which may hang, for one of this object's threads; an exception that it throws is caught and logged.
  /// To be called when the one before it has ended.
  void run(std::function<void()> job);
  const MapSaves& saves() const { return saves_; }
  /// To be told where scans came into the map; it knows how much of that way was saved.
  MappedWay& way() { return *way_; }
  void close() { thread_.close(); }

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);
  map_files::MapIoResult save(const std::string& path);

  MapSaves saves_;
  const std::shared_ptr<MappedWay> way_ = std::make_shared<MappedWay>();  ///< also of a save that hangs
  /// One for each save, one that refuses others, and one for the job.
  ServiceThread<occupancy::OccupancyMap> thread_{MapSaves::kMost + 2};
};

}  // namespace frontier_pilot
