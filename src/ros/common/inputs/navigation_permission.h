#pragma once

#include <frontier_pilot/ArbiterStatus.h>

#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/core/time.h"
#include "ros/common/messages/mailbox.h"

namespace frontier_pilot {

/// Whether the arbiter heeds the navigation's commands, as its status tells. While it does not, no goal is reached,
/// which is no fault of the goals. [EXP-8] [NAV-5]
class NavigationPermission {
 public:
  /// For the commands on the node's own `cmd_vel_nav`.
  NavigationPermission();
  /// `topic` is that of the navigation's commands, with its whole name.
  explicit NavigationPermission(std::string topic) : topic_(std::move(topic)) {}

  /// A status; `now` is ROS time, which the robot's motions take, and `received` steady time.
  void take(const ArbiterStatus& status, Time now, SteadyTime received);
  /// Why the arbiter does not heed it, in words; empty if it does, if that may pass in a moment, and if no arbiter
  /// tells.
  std::string refusal(Time now, SteadyTime steady) const;

 private:
  struct Refusal {
    std::string why;
    Duration passes;  ///< it counts once it has lasted so long
  };
  std::optional<Refusal> find(const ArbiterStatus& status) const;

  std::string topic_;
  Latest<Refusal> last_;
  Time since_{};  ///< when the last one began
};

}  // namespace frontier_pilot
