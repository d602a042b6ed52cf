#include "frontier_pilot/mapping/scan_pairing.h"

#include <cstdint>
#include <deque>
#include <utility>

#include "mapping/odometry_buffer.h"

namespace frontier_pilot::mapping {

struct ScanPairing::Impl {
  explicit Impl(const ScanPairingParameters& given) : parameters(given), odometry(given.odometry) {}

  bool mayWait(const LaserScan2& scan, Time now) const {
    const double waited = toSeconds(now - scan.end());
    // A scan stamped more than a second ahead does not wait: the clock may have been set back.
    return waited < parameters.patience && waited > -1.0 &&
           waiting.size() <= static_cast<std::size_t>(parameters.max_waiting);
  }

  ScanPairingParameters parameters;
  OdometryBuffer odometry;
  std::deque<LaserScan2> waiting;
};

ScanPairing::ScanPairing(const ScanPairingParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
ScanPairing::~ScanPairing() = default;

void ScanPairing::addOdometry(Time stamp, const Pose2& T_odom_base) { impl_->odometry.add(stamp, T_odom_base); }

bool ScanPairing::addOdometry(Time stamp, const Pose2& T_odom_base, OdometryAnchor& anchor) {
  const std::uint64_t resets = anchor.resets();
  const std::optional<Pose2> T_smooth_base = anchor.follow(stamp, T_odom_base);
  if (!T_smooth_base) return false;
  if (anchor.resets() != resets && anchor.followsJumps()) impl_->odometry.clear();
  addOdometry(stamp, *T_smooth_base);
  return true;
}

void ScanPairing::addScan(LaserScan2 scan) { impl_->waiting.push_back(std::move(scan)); }

std::optional<PairedScan> ScanPairing::next(Time now) {
  std::deque<LaserScan2>& waiting = impl_->waiting;
  if (waiting.empty()) return std::nullopt;
  Pose2 T_odom_base;
  OdometryLookup lookup = impl_->odometry.at(waiting.front().end(), T_odom_base);
  if (lookup == OdometryLookup::kTooNew && impl_->mayWait(waiting.front(), now)) return std::nullopt;
  PairedScan paired{std::move(waiting.front()), std::nullopt};
  waiting.pop_front();
  paired.covered = placeBeams(impl_->odometry.track(), ScanReference::kMiddle, paired.scan);
  lookup = impl_->odometry.at(paired.scan.stamp, T_odom_base);
  if (lookup == OdometryLookup::kFound) paired.T_odom_base = T_odom_base;
  return paired;
}

bool ScanPairing::hasOdometry() const { return !impl_->odometry.empty(); }

void ScanPairing::clear() {
  impl_->odometry.clear();
  impl_->waiting.clear();
}

}  // namespace frontier_pilot::mapping
