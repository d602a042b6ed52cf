#pragma once

#include <std_srvs/Trigger.h>

#include "frontier_pilot/mapping/mapper.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/service_thread.h"

namespace frontier_pilot {

/// Serves `mapper/localize` on a thread of its own: searching a large map takes long. The node's thread only copies map
/// and scans, and takes over the result. [MAP-5]
class MapSearcher {
 public:
  /// See ServiceThread.
  void serve(NodeConnections& connections);
  void provide(mapping::Mapper& mapper) { thread_.answer(mapper); }
  void close() { thread_.close(); }

 private:
  bool handle(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  ServiceThread<mapping::Mapper> thread_;
};

}  // namespace frontier_pilot
