#include "ros/common/callback_guard.h"

#include <ros/console.h>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

namespace {

constexpr Duration kRecentException = std::chrono::seconds(10);

}  // namespace

void CallbackGuard::add(const std::string& what, const std::string& error) noexcept try {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++total_;
  latest_ = steadyNow();
  Caught& caught = caught_[what];
  ++caught.count;
  caught.latest = printable(error, bounds::kMostReason);
  if (!caught.log_interval.admit(latest_)) return;
  ROS_ERROR_STREAM("exception in " << what << ": " << caught.latest << " (" << caught.count << " so far)");
} catch (...) {  // NOLINT(bugprone-empty-catch): without memory or a log nothing can be reported
}

std::uint64_t CallbackGuard::total() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return total_;
}

void CallbackGuard::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.add("exceptions caught", total_);
  for (const auto& [what, caught] : caught_) {
    status.add("exceptions in " + what, std::to_string(caught.count) + ", the latest: " + caught.latest);
  }
  if (total_ > 0 && steadyNow() - latest_ < kRecentException) {
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "exception caught");
  }
}

}  // namespace frontier_pilot
