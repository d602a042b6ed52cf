#include "ros/common/messages/frozen_scan.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

constexpr double kMoved = 0.05;  // [m]
constexpr double kTurned = 0.1;  // [rad]
constexpr std::size_t kScansRemembered = 64;
// From scan to scan odometry changes by less than this while the robot drives: [m], [rad], [m/s], [rad/s].
constexpr double kJump = 0.1, kAngleJump = 0.2, kFastest = 3.0, kFastestTurn = 6.0;
constexpr Duration kClockJump = std::chrono::seconds(1);  // back; a driver may repeat stamps, too

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

/// Forgets what was seen before odometry was reset or the clock was set back: the robot may stand where it stood.
void FrozenScanWatch::notePose(Time stamp, const Pose2& T_odom_base) {
  if (last_ && stamp != last_->stamp) {
    const double passed = std::abs(toSeconds(stamp - last_->stamp));
    const double angle = std::min(kAngleJump + kFastestTurn * passed, kPi);
    const bool jumped = isJump(last_->pose, T_odom_base, kJump + kFastest * passed, angle);
    if (jumped || last_->stamp - stamp > kClockJump) seen_.clear();
  }
  last_ = StampedPose2{stamp, T_odom_base};
}

bool FrozenScanWatch::isFrozen(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base) {
  frozen_ = false;
  if (!hasReturn(scan)) return false;
  if (T_odom_base) notePose(scan.stamp, *T_odom_base);
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
