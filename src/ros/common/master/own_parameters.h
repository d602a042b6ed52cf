#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

namespace frontier_pilot {

/// The parameters that this node was started with, for a master that comes back empty: a node that is started again
/// there would otherwise come up with defaults, such as another robot's limits.
class OwnParameters {
 public:
  /// Reads the node's private namespace, and `/use_sim_time`.
  OwnParameters();
  /// Sets again what the master no longer has; gives whether there was anything to set.
  bool restore();

 private:
  XmlRpc::XmlRpcValue private_, use_sim_time_;  ///< invalid: there was none
};

}  // namespace frontier_pilot
