#pragma once

#include <frontier_pilot/SaveMap.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <atomic>
#include <functional>
#include <future>

#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// Serves `mapper/save_map` on a thread of its own, because encoding, writing and reading back a large map takes longer
/// than `map -> odom` may be late. The node's thread only copies the map.
class MapSaver {
 public:
  /// Advertises the service and starts the thread.
  void serve(NodeConnections& connections);
  /// Hands a copy of the map over if a call waits for it. To be called periodically on the node's thread.
  void provide(occupancy::OccupancyMap& map);
  /// Queues `job` for this object's thread; an exception that it throws is caught and logged.
  void run(std::function<void()> job);
  /// Makes calls that wait for the map fail, and all later ones. To be called before the connections are destroyed,
  /// which waits for the call that is being served.
  void close();

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);
  map_files::MapIoResult save(const std::string& path);

  std::atomic<bool> closed_{false};
  Mailbox<std::promise<map_files::MapSnapshot>> wanted_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};  ///< the last member: all others exist while it runs
};

}  // namespace frontier_pilot
