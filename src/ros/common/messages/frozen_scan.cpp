#include "ros/common/messages/frozen_scan.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <cstring>

#include "frontier_pilot/core/motion.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr double kMoved = 0.05;  // [m]
constexpr double kTurned = 0.1;  // [rad]

bool hasReturn(const LaserScan2& scan) {
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (readBeam(scan, i).kind == RangeKind::kHit) return true;
  }
  return false;
}

/// Bit by bit, so that NaN equals itself.
bool areSame(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

bool FrozenScanWatch::isFrozen(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base) {
  frozen_ = false;
  if (!areSame(scan.ranges, ranges_) || !hasReturn(scan)) {
    ranges_ = scan.ranges;
    first_seen_ = T_odom_base;
    return false;
  }
  if (!first_seen_) first_seen_ = T_odom_base;
  frozen_ = T_odom_base && isJump(*first_seen_, *T_odom_base, kMoved, kTurned);
  count_ += frozen_ ? 1 : 0;
  if (frozen_) THROTTLED_ERROR(kFrozenScan << ": it is not used");
  return frozen_;
}

void FrozenScanWatch::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  if (count_ > 0) status.add("scans that repeat the one before them", count_);
  if (frozen_) status.mergeSummary(diagnostic_msgs::DiagnosticStatus::ERROR, kFrozenScan);
}

}  // namespace frontier_pilot
