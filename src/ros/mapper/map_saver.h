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

/// Serves `mapper/save_map` on a thread of its own: a large map takes longer to be encoded, written and read back than
/// `map -> odom` may be late. The node's thread only copies the map.
class MapSaver {
 public:
  /// From here on it is served.
  void serve(NodeConnections& connections);
  /// Hands the map over if a call waits for it. For the node's thread, again and again.
  void provide(occupancy::OccupancyMap& map);
  /// Runs `job` on this thread, after what it does now; one that throws ends here.
  void run(std::function<void()> job);
  /// Lets calls that wait for the map fail, and all later ones. To be called before the connections are closed, which
  /// waits for a call that is served.
  void close();

 private:
  bool handle(SaveMap::Request& request, SaveMap::Response& response);
  map_files::MapIoResult save(const std::string& path);

  std::atomic<bool> closed_{false};
  Mailbox<std::promise<map_files::MapSnapshot>> wanted_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};  ///< the last member: everything else is there while it runs
};

}  // namespace frontier_pilot
