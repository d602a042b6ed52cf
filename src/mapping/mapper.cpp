#include "frontier_pilot/mapping/mapper.h"

#include <cmath>
#include <utility>

namespace frontier_pilot {
namespace {

bool isWellFormed(const LaserScan2& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max) && scan.T_base_sensor.isFinite();
  return finite && scan.angle_increment != 0.0 && scan.range_min >= 0.0 && scan.range_max > scan.range_min &&
         !scan.ranges.empty();
}

ScanVerdict verdictOf(Insertion insertion) {
  switch (insertion) {
    case Insertion::kInserted:
      return ScanVerdict::kInserted;
    case Insertion::kAllInvalid:
      return ScanVerdict::kAllInvalid;
    case Insertion::kOutOfBounds:
      break;
  }
  return ScanVerdict::kOutOfBounds;
}

}  // namespace

Mapper::Mapper(const MapperParameters& parameters, std::unique_ptr<PoseCorrection> correction)
    : parameters_(parameters),
      map_(parameters.map),
      inserter_(parameters.insertion),
      correction_(correction ? std::move(correction) : std::make_unique<TrustOdometry>()) {}

ScanVerdict Mapper::insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  const ScanVerdict verdict = decide(scan, T_odom_base, now);
  counts_.add(verdict);
  return verdict;
}

ScanVerdict Mapper::decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  if (const auto wrong = checkStamp(scan.stamp, now)) return *wrong;
  if (!isWellFormed(scan)) return ScanVerdict::kMalformed;
  if (!T_odom_base || !T_odom_base->isFinite()) return ScanVerdict::kNoOdometry;
  if (!hasMoved(scan, *T_odom_base)) return ScanVerdict::kNotMoved;
  return integrate(scan, *T_odom_base);
}

ScanVerdict Mapper::integrate(const LaserScan2& scan, const Pose2& T_odom_base) {
  const Pose2 T_map_odom = correction_->correct(scan, T_odom_base, map_);
  const ScanVerdict verdict = verdictOf(inserter_.insert(scan, T_map_odom * T_odom_base, map_));
  if (verdict == ScanVerdict::kInserted) {
    T_map_odom_ = T_map_odom;
    last_ = Last{scan.stamp, T_odom_base};
  }
  return verdict;
}

std::optional<ScanVerdict> Mapper::checkStamp(Time stamp, Time now) {
  // The clock has been set back: stamps that were seen before may come again.
  if (now < now_) last_.reset();
  now_ = now;
  if (toSeconds(now - stamp) > parameters_.max_age || (last_ && stamp <= last_->stamp)) return ScanVerdict::kStale;
  if (toSeconds(stamp - now) > parameters_.max_lead) return ScanVerdict::kFuture;
  return std::nullopt;
}

bool Mapper::hasMoved(const LaserScan2& scan, const Pose2& T_odom_base) const {
  if (!last_ || toSeconds(scan.stamp - last_->stamp) >= parameters_.standing_period) return true;
  const Pose2 step = last_->T_odom_base.inverse() * T_odom_base;
  return step.position().norm() >= parameters_.min_travel || std::abs(step.yaw) >= parameters_.min_rotation;
}

void Mapper::reset() {
  map_.clear();
  correction_->reset();
  T_map_odom_ = Pose2();
  last_.reset();
}

}  // namespace frontier_pilot
