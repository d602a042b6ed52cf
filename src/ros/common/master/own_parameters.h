#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

namespace frontier_pilot {

/// The parameters that this node was started with, for a master that was restarted and has lost them: a node that is
/// started again there would otherwise use its defaults, for example the limits of another robot.
class OwnParameters {
 public:
  /// Reads the node's private namespace, and `/use_sim_time`.
  OwnParameters();
  /// Sets what the master no longer has; returns whether there was anything to set.
  bool restore();

 private:
  XmlRpc::XmlRpcValue private_, use_sim_time_;  ///< invalid where there was no such parameter
};

}  // namespace frontier_pilot
