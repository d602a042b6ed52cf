#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "ros/common/callback_guard.h"

namespace frontier_pilot {

/// What a node had to refuse: counted by reason, with a warning of it at most every five seconds of steady time. A
/// reason may quote what came in: long ones are cut, and of too many the rarest count together. [FLT-1]
class Rejections {
 public:
  /// `what` is the input, for the log: "scan".
  explicit Rejections(std::string what) : what_(std::move(what)) {}

  void add(const std::string& reason);
  std::uint64_t total() const { return total_; }
  /// Adds one `what: why` line with its count for each reason.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void forgetRarest();

  std::string what_;
  std::uint64_t total_ = 0;
  std::map<std::string, std::uint64_t> by_reason_;
  std::uint64_t for_other_reasons_ = 0;
  std::optional<SteadyTime> last_warning_;
};

/// A node's /diagnostics: published every second of steady time, so that a stopped clock does not silence it.
class NodeDiagnostics {
 public:
  using Fill = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

  NodeDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// `fill` says how it stands: `status.summary(level, text)` and `status.add(key, value)`. Whatever its texts quote,
  /// they are published `printable`. [FLT-1]
  void add(const std::string& name, Fill fill);
  /// Publishes now, for a change that should not wait.
  void publish();

 private:
  CallbackGuard guard_;
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer timer_;
};

}  // namespace frontier_pilot
