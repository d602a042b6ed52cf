#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "ros/common/memory/session_memory.h"

namespace frontier_pilot {

/// The parameters that this node was started with, and those that were changed since, for a master that was restarted
/// and has lost them: a node that is started again there would otherwise use its defaults, for example the limits of
/// another robot. They are kept beyond the death of the node, too, in a file in memory, for the process that is started
/// in its place. Safe to use from several threads.
class OwnParameters {
 public:
  /// Reads the node's private namespace, and `/use_sim_time`.
  OwnParameters();
  /// Forgets the values at an end in order, but not that there was a process.
  ~OwnParameters();
  OwnParameters(const OwnParameters&) = delete;
  OwnParameters& operator=(const OwnParameters&) = delete;

  /// Keeps them for the ROS session with these names from now on.
  void enter(const std::vector<std::string>& sessions);
  /// Sets the private namespace if the master no longer has it, and `/use_sim_time`; returns whether there was anything
  /// to set. A namespace that it has in part is that of a new launch.
  bool restore();
  /// Notes a changed parameter: its name in the private namespace ("limits/max_linear") and its value.
  void change(const std::string& name, const XmlRpc::XmlRpcValue& value);
  /// Sets the changed ones at the master. One that it does not take, because it does not answer, is tried again with
  /// the next call.
  void sendChanges();

 private:
  /// Values of which one has control characters, or which take more than 60,000 bytes, are not kept.
  void keep();

  XmlRpc::XmlRpcValue private_, use_sim_time_;  ///< invalid where there was no such parameter
  std::set<std::string> unsent_;                ///< names of changed ones in the private namespace
  SessionMemory memory_;
  std::mutex mutex_;  ///< guards all that precede
};

/// Those of this process, which end with the last that holds them: several would write the same file.
std::shared_ptr<OwnParameters> sharedParameters();

/// Looks for the process that died and in whose place this one was started. If the master that it knew has been
/// replaced, and roslaunch started both, the parameters that the new master lacks are set as that process had them; by
/// hand, a node may have been started again to have the defaults. To be called before the node reads
/// any parameter, and before ROS is started, which reads `/use_sim_time`. If there is something to set, it waits for a
/// master. [FLT-2]
void followThePredecessor(bool is_of_roslaunch);
/// Whether `followThePredecessor` has found one, or one of this session whose end was in order.
bool replacesAProcess();

}  // namespace frontier_pilot
