#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "frontier_pilot/core/time.h"
#include "ros/common/callback_guard.h"
#include "ros/common/inputs/start_grace.h"
#include "ros/common/log_interval.h"

namespace frontier_pilot {

/// Inputs that a node has refused: counted by reason, with a warning at most every five seconds of steady time. A
/// reason may quote the input: long ones are cut, and when there are too many the rarest are counted together. [FLT-1]
class Rejections {
 public:
  /// `what` is the input, for the log: "scan".
  explicit Rejections(std::string what, const StartGrace& grace = StartGrace())
      : what_(std::move(what)), grace_(grace) {}

  void add(const std::string& reason) { add(reason, ros::console::levels::Warn); }
  /// The same for an input that only lacks another one, which comes later when the node has just started.
  void addWaiting(const std::string& reason) { add(reason, grace_.level(steadyNow())); }
  std::uint64_t total() const { return total_; }
  /// The reason of the last one; empty if nothing was refused.
  const std::string& last() const { return last_; }
  /// Adds the total, and a line `what refused: reason` with its count for each reason.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void add(const std::string& reason, ros::console::Level level);
  void forgetRarest();

  std::string what_;
  StartGrace grace_;
  std::uint64_t total_ = 0;
  std::string last_;
  std::map<std::string, std::uint64_t> by_reason_;
  std::uint64_t for_other_reasons_ = 0;
  LogInterval log_interval_;
};

/// A node's /diagnostics: published every second of steady time, so that a stopped clock does not silence it.
class NodeDiagnostics {
 public:
  using Fill = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

  NodeDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// `fill` fills in a status: `status.summary(level, text)` and `status.add(key, value)`. Its texts may quote input:
  /// control characters are escaped before they are published (`printable`). [FLT-1]
  void add(const std::string& name, Fill fill);
  /// Publishes at once, for a change that should not wait for the next second.
  void publish();

 private:
  CallbackGuard guard_;
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer timer_;
};

}  // namespace frontier_pilot
