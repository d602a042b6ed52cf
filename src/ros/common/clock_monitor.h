#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/clock_trust.h"
#include "ros/common/callback_guard.h"
#include "ros/common/hold_up_watch.h"

namespace frontier_pilot {

/// Shields a node from jumps of ROS time: after a jump the node gets no time until the clock can be trusted again, and
/// discards its stamped data. Jumps are logged and shown in the diagnostics. For the node's own thread. [FLT-1]
class ClockMonitor {
 public:
  explicit ClockMonitor(const ros::NodeHandle& node);

  /// ROS time; nothing while the clock cannot be trusted after a jump: the node should then do nothing.
  std::optional<Time> now();
  /// Whether this process has just been held up: a node that moves the robot reads what came meanwhile before it acts.
  bool isCatchingUp() const { return catching_up_; }
  /// How often this process was held up so far.
  int holdUps() const { return hold_ups_.count(); }
  /// `forget` is called when the clock has jumped, and once more when it can be trusted again.
  void onJump(std::function<void()> forget) { forget_.push_back(std::move(forget)); }
  /// Adds the number of jumps, and a warning to the summary for ten seconds after the last one, or while the clock
  /// stands still.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  Time look();

  CallbackGuard guard_;
  ClockTrust trust_;
  Instant moved_;  ///< when ROS time was last seen to change
  HoldUpWatch hold_ups_{std::chrono::milliseconds(200), std::chrono::seconds(1)};
  bool catching_up_ = false;
  std::vector<std::function<void()>> forget_;
  ros::SteadyTimer poll_;
};

/// The warning for a ROS clock that was last seen to change at `moved`; empty while it runs.
std::string standstill(const Instant& moved, const Instant& now);

/// How fast the ROS clock of this process may run.
ClockPace clockPace();

/// How far a stamp may lie in the future: ten seconds; in a simulation more, because it may run hundreds of times
/// faster than the steady clock, and a process that hung for a while sees messages far ahead of the last /clock it has
/// read.
Duration mostAhead(const ClockPace& pace);
/// Whether `stamp` lies farther ahead of `now`, on the ROS clock of this process, than mostAhead allows. False before
/// the first /clock, when it cannot be judged.
bool isAhead(Time stamp, Time now);

}  // namespace frontier_pilot
