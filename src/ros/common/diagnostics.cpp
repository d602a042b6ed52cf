#include "ros/common/diagnostics.h"

#include <ros/console.h>

#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

namespace {

void makePrintable(std::string& text) { text = printable(text, bounds::kMostDiagnostic); }

}  // namespace

void Rejections::add(const std::string& reason, ros::console::Level level) {
  ++total_;
  const std::string why = printable(reason, bounds::kMostReason);
  if (by_reason_.count(why) == 0 && by_reason_.size() >= bounds::kMostReasons) forgetRarest();
  last_ = why;
  const std::uint64_t count = ++by_reason_[why];
  if (!log_interval_.admit(steadyNow())) return;
  ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME, what_ << " refused: " << why << " (" << count << " so far)");
}

/// Merges the rarest reason into "other reasons", so that the newest one can always be listed by name.
void Rejections::forgetRarest() {
  const auto rarest = std::min_element(by_reason_.begin(), by_reason_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
  for_other_reasons_ += rarest->second;
  by_reason_.erase(rarest);
}

void Rejections::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  status.add(what_ + " refused", total_);
  for (const auto& [why, count] : by_reason_) status.add(what_ + " refused: " + why, count);
  if (for_other_reasons_ > 0) status.add(what_ + " refused: for other reasons", for_other_reasons_);
}

/// The updater reads `diagnostic_period` before each update, which fails where that is too large. It has a namespace of
/// its own, where nobody sets it. [FLT-1]
NodeDiagnostics::NodeDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : updater_(node, ros::NodeHandle(private_node, "diagnostics")) {
  updater_.setHardwareID("none");
  timer_ = ros::NodeHandle(node).createSteadyTimer(ros::WallDuration(1.0),
                                                   [this](const ros::SteadyTimerEvent&) { publish(); });
}

void NodeDiagnostics::publish() {
  guard_.run("diagnostics", [this] { updater_.force_update(); });
}

void NodeDiagnostics::add(const std::string& name, Fill fill) {
  updater_.add(name, [fill = std::move(fill)](diagnostic_updater::DiagnosticStatusWrapper& status) {
    fill(status);
    makePrintable(status.message);
    for (auto& entry : status.values) {
      makePrintable(entry.key);
      makePrintable(entry.value);
    }
  });
}

}  // namespace frontier_pilot
