#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <map>
#include <set>
#include <string>

namespace frontier_pilot {

/// The parameters that this node was started with, and those that were changed since, for a master that was restarted
/// and has lost them: a node that is started again there would otherwise use its defaults, for example the limits of
/// another robot.
class OwnParameters {
 public:
  /// Reads the node's private namespace, and `/use_sim_time`.
  OwnParameters();
  /// Sets what the master no longer has; returns whether there was anything to set.
  bool restore();
  /// Notes a changed parameter: its name in the private namespace ("limits/max_linear") and its value.
  void change(const std::string& name, const XmlRpc::XmlRpcValue& value) {
    changed_[name] = value;
    unsent_.insert(name);
  }
  /// Sets the changed ones at the master. One that it does not take, because it does not answer, is tried again with
  /// the next call.
  void sendChanges();

 private:
  XmlRpc::XmlRpcValue private_, use_sim_time_;  ///< invalid where there was no such parameter
  std::map<std::string, XmlRpc::XmlRpcValue> changed_;
  std::set<std::string> unsent_;
};

}  // namespace frontier_pilot
