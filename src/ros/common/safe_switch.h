#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "ros/common/node_connections.h"
#include "ros/common/session_memory.h"

namespace frontier_pilot {

/// One of a node's switches with a safe side, on which the robot does less by itself: a source of velocities that is
/// disabled, an exploration that is paused, an avoider that is at work. Whichever node offers its service next in the
/// same ROS session, after one that died, finds it as the operator has left it. Of a node that ended in order only the
/// safe side is remembered: no robot drives off because of what was said in a launch that is over. [FLT-2]
class SafeSwitch {
 public:
  /// `state` names the safe side in characters of a file name ("nav_disabled"), `service` is what switches it. Keeps up
  /// with a master that is replaced; `connections` is to end before this object.
  SafeSwitch(std::string state, const std::string& service, NodeConnections& connections);
  ~SafeSwitch();
  SafeSwitch(const SafeSwitch&) = delete;
  SafeSwitch& operator=(const SafeSwitch&) = delete;

  /// Whether an earlier process was left on the safe side, which is said on the log; nothing if the
  /// operator never used the switch.
  std::optional<bool> wasLeftSafe() const;
  /// The operator has switched it. Gives what to add to the answer: why that would not survive a restart, or nothing.
  std::string set(bool safe);

 private:
  /// Gives what went wrong, which is said on the log as well, or an empty text.
  std::string write() const;

  std::string state_;
  MemoryReport& report_;
  mutable std::mutex mutex_;  ///< guards the two that follow
  SessionMemory memory_;
  std::optional<bool> safe_;
};

}  // namespace frontier_pilot
