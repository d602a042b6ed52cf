#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/publisher.h>

#include <functional>
#include <vector>

#include "ros/common/node_connections.h"
#include "ros/common/tuning/tunable_fields.h"

namespace frontier_pilot {

/// Lets a node's tunable parameters be changed while it runs, by the interface of dynamic_reconfigure: rqt_reconfigure
/// and dynparam find `~parameter_descriptions`, `~parameter_updates` and `~set_parameters`. Bounds, defaults and
/// meaning come from the struct's one description. A request is taken as a whole or refused as a whole, in the thread
/// that runs the node's callbacks; either way it is logged, and the answer has the values in force. Changed values are
/// set on the parameter server too, so that a node which is started again finds them.
class ReconfigureServer {
 public:
  /// `parameters` are those in force; `apply(const P&)` hands changed ones to the node. `connections` must be destroyed
  /// before this object.
  template <class P, class Apply>
  ReconfigureServer(const P& parameters, NodeConnections& connections, Apply apply)
      : ReconfigureServer(connections, tunablesOf<P>(parameters, std::move(apply))) {}

 private:
  using Request = dynamic_reconfigure::Reconfigure::Request;
  using Response = dynamic_reconfigure::Reconfigure::Response;

  ReconfigureServer(NodeConnections& connections, Tunables tunables);
  bool handle(Request& request, Response& response);
  Problems change(const dynamic_reconfigure::Config& wanted) const;
  /// Logs each change, and sets it on the parameter server.
  void tell(const std::vector<TunableField>& before);

  Tunables tunables_;
  MasterWatch& master_;
  ros::Publisher descriptions_, updates_;
};

}  // namespace frontier_pilot
