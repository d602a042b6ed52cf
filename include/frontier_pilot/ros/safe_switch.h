#pragma once

#include <mutex>
#include <string>

#include "frontier_pilot/ros/node_connections.h"
#include "frontier_pilot/ros/session_memory.h"

namespace frontier_pilot {

/// One of a node's switches with a safe side, on which the robot does less by itself: a source of velocities that is
/// disabled, an exploration that is paused, an avoider that is at work. Where the operator has put it there it stays,
/// also if the node is started again in the same ROS session. The other side is not remembered: no robot drives off
/// because of what was said to a node that has died since. [FLT-2]
class SafeSwitch {
 public:
  /// `state` names the safe side in characters of a file name ("nav_disabled"). Keeps up with a master that is
  /// replaced; `connections` is to end before this object.
  SafeSwitch(std::string state, NodeConnections& connections);

  /// Whether an earlier process of this node was left on the safe side; said on the log.
  bool wasLeftSafe() const;
  /// The operator has switched it. What cannot be written is said on the log.
  void set(bool safe);

 private:
  void write() const;

  std::string state_;
  mutable std::mutex mutex_;  ///< guards the two that follow
  SessionMemory memory_;
  bool safe_;
};

}  // namespace frontier_pilot
