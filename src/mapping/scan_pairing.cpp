#include "frontier_pilot/mapping/scan_pairing.h"

#include <utility>

namespace frontier_pilot::mapping {

ScanPairing::ScanPairing(const ScanPairingParameters& parameters)
    : parameters_(parameters), odometry_(parameters.odometry) {}

std::optional<PairedScan> ScanPairing::next(Time now) {
  if (waiting_.empty()) return std::nullopt;
  Pose2 T_odom_base;
  const OdometryLookup lookup = odometry_.at(waiting_.front().stamp, T_odom_base);
  if (lookup == OdometryLookup::kTooNew && mayWait(waiting_.front(), now)) return std::nullopt;
  PairedScan paired{std::move(waiting_.front()), std::nullopt};
  waiting_.pop_front();
  if (lookup == OdometryLookup::kFound) paired.T_odom_base = T_odom_base;
  return paired;
}

bool ScanPairing::mayWait(const LaserScan2& scan, Time now) const {
  const double waited = toSeconds(now - scan.stamp);
  // A stamp far ahead is no reason to wait for ever: the clock may have been set back.
  return waited < parameters_.patience && waited > -1.0 &&
         waiting_.size() <= static_cast<std::size_t>(parameters_.max_waiting);
}

void ScanPairing::clear() {
  odometry_.clear();
  waiting_.clear();
}

}  // namespace frontier_pilot::mapping
