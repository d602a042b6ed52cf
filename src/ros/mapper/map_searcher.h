#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "frontier_pilot/mapping/mapper.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// Serves `mapper/localize` on a thread of its own, because searching a large map takes longer than `map -> odom` may
/// be late. The node's thread only copies map and scans, and takes over the result. [MAP-5]
class MapSearcher {
 public:
  /// Advertises the service and starts the thread.
  void serve(NodeConnections& connections);
  /// Does what a call waits for. To be called periodically on the node's thread.
  void provide(mapping::Mapper& mapper);
  /// Makes calls that wait for the mapper fail, and all later ones. To be called before the connections are destroyed,
  /// which waits for the call that is being served.
  void close();

 private:
  bool handle(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  /// What `question` gives on the node's thread; nothing if it was not asked within ten seconds, or threw.
  template <class Answer>
  std::optional<Answer> ask(const std::function<Answer(mapping::Mapper&)>& question);

  std::atomic<bool> closed_{false};
  Mailbox<std::function<void(mapping::Mapper&)>> wanted_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};  ///< the last member: all others exist while it runs
};

}  // namespace frontier_pilot
