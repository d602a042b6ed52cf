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

namespace frontier_pilot {

/// Keeps jumps of ROS time from a node: it gets no time until the clock can be trusted again, forgets then what is
/// stamped. Says so on the log and in the diagnostics. For the node's own thread. [FLT-1]
class ClockMonitor {
 public:
  explicit ClockMonitor(const ros::NodeHandle& node);

  /// ROS time, unless it has just jumped: then the node should do nothing.
  std::optional<Time> now();
  /// `forget` is called when the clock has jumped, and again when it can be trusted.
  void onJump(std::function<void()> forget) { forget_.push_back(std::move(forget)); }
  /// Adds the number of jumps, and a warning to the summary for ten seconds after the last one, or while the clock
  /// stands still.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  Time look();

  CallbackGuard guard_;
  ClockTrust trust_;
  Instant moved_;  ///< when ROS time was last seen to change
  std::vector<std::function<void()>> forget_;
  ros::SteadyTimer poll_;
};

/// What is to be said of a clock that was last seen to change at `moved`; empty while it runs.
std::string standstill(const Instant& moved, const Instant& now);

/// How fast the ROS clock of this process may run.
ClockPace clockPace();

/// How far a message may be dated ahead: ten seconds, and in a simulation as far as a process that hung has to catch up
/// with, since it may run hundreds of times as fast as the steady clock.
Duration mostAhead(const ClockPace& pace);
/// Whether `stamp` lies farther ahead of `now` than that on the ROS clock of this process. Before the first /clock
/// there is no telling: false.
bool isAhead(Time stamp, Time now);

}  // namespace frontier_pilot
