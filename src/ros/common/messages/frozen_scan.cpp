#include "ros/common/messages/frozen_scan.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

constexpr double kMoved = 0.05;  // [m]
constexpr double kTurned = 0.1;  // [rad]
constexpr std::size_t kScansRemembered = 64;

bool hasReturn(const LaserScan2& scan) {
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (readBeam(scan, i).kind == RangeKind::kHit) return true;
  }
  return false;
}

/// Of their bits, so that NaN equals itself.
std::size_t hashOf(const std::vector<float>& ranges) {
  const auto* bytes = reinterpret_cast<const char*>(ranges.data());
  return std::hash<std::string_view>()({bytes, ranges.size() * sizeof(float)});
}

}  // namespace

bool FrozenScanWatch::isFrozen(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base) {
  frozen_ = false;
  if (!hasReturn(scan)) return false;
  const std::size_t hash = hashOf(scan.ranges);
  const auto same = std::find_if(seen_.begin(), seen_.end(), [&](const Seen& seen) { return seen.hash == hash; });
  if (same == seen_.end()) {
    seen_.push_back({hash, T_odom_base});
    if (seen_.size() > kScansRemembered) seen_.pop_front();
    return false;
  }
  if (!same->T_odom_base) same->T_odom_base = T_odom_base;
  frozen_ = T_odom_base && isJump(*same->T_odom_base, *T_odom_base, kMoved, kTurned);
  count_ += frozen_ ? 1 : 0;
  if (frozen_ && log_interval_.admit(steadyNow())) ROS_ERROR_STREAM(kFrozenScan << ": it is not used");
  return frozen_;
}

void FrozenScanWatch::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  if (count_ > 0) status.add("scans that repeat an old one", count_);
  if (frozen_) status.mergeSummary(diagnostic_msgs::DiagnosticStatus::ERROR, kFrozenScan);
}

}  // namespace frontier_pilot
