#pragma once

#include <optional>
#include <string>

#include "ros/common/memory/remembered_text.h"

namespace frontier_pilot {

/// A switch of a node that has a safe side, on which the robot does less on its own: a disabled source of velocities, a
/// paused exploration, an enabled avoider. After a node has died, the next node in the same ROS session that offers the
/// switch's service finds it as the operator left it. After a regular shutdown, in another launch, and at a new master,
/// only the safe side is remembered: no robot drives off because of a switch that was set during an earlier launch.
/// [FLT-2]
class SafeSwitch {
 public:
  /// `state` names the safe side and has to be usable in a file name ("nav_disabled"); `service` is the name of the
  /// switch's service. A restart of the master is followed. `connections` must be destroyed before this object.
  SafeSwitch(std::string state, const std::string& service, NodeConnections& connections);
  ~SafeSwitch() { end(); }
  SafeSwitch(const SafeSwitch&) = delete;
  SafeSwitch& operator=(const SafeSwitch&) = delete;

  /// Whether an earlier process was left on the safe side, which is logged; nothing if the operator never used the
  /// switch.
  std::optional<bool> wasLeftSafe() const;
  /// To be called when the operator has switched it. Returns the text to append to the answer: why the setting would
  /// not survive a restart; empty if it would.
  std::string set(bool safe);
  /// To be called with the last words of a node at a regular end.
  void end() { memory_.end(safe_ == false); }

 private:
  std::string state_;
  RememberedText memory_;
  std::optional<bool> safe_;
};

}  // namespace frontier_pilot
