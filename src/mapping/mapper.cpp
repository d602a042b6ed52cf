#include "frontier_pilot/mapping/mapper.h"

#include <cmath>
#include <utility>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::mapping {
namespace {

bool isWellFormed(const LaserScan2& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max) && scan.T_base_sensor.isFinite();
  return finite && scan.angle_increment != 0.0 && scan.range_min >= 0.0 && scan.range_max > scan.range_min &&
         !scan.ranges.empty();
}

/// Share of the beams that tell where there is something, or nothing.
double shareOfUsable(const LaserScan2& scan) {
  std::size_t usable = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const RangeKind kind = readBeam(scan, beam).kind;
    if (kind == RangeKind::kHit || kind == RangeKind::kFree) ++usable;
  }
  return static_cast<double>(usable) / static_cast<double>(scan.ranges.size());
}

ScanVerdict verdictOf(occupancy::Insertion insertion) {
  switch (insertion) {
    case occupancy::Insertion::kInserted:
      return ScanVerdict::kInserted;
    case occupancy::Insertion::kAllInvalid:
      return ScanVerdict::kAllInvalid;
    case occupancy::Insertion::kOutOfBounds:
      break;
  }
  return ScanVerdict::kOutOfBounds;
}

scan_matching::PoseWithCovariance beliefOf(const Pose2& pose) {
  constexpr double kPosition = 0.5;  // [m]
  constexpr double kYaw = 0.25;      // [rad]
  return {pose, Eigen::Vector3d(kPosition * kPosition, kPosition * kPosition, kYaw * kYaw).asDiagonal()};
}

std::unique_ptr<slam::PoseCorrection> knownMap(const MapperParameters& parameters, occupancy::OccupancyMap& map,
                                               const scan_matching::PoseWithCovariance& T_map_base) {
  auto use = parameters.trust_odometry ? localization::MapLocalization::Use::kTrustOdometry
                                       : localization::MapLocalization::Use::kGoOnMapping;
  if (parameters.localize_only) use = localization::MapLocalization::Use::kLocalizeOnly;
  return std::make_unique<localization::MapLocalization>(use, parameters.slam, map, parameters.insertion, T_map_base);
}

std::unique_ptr<slam::PoseCorrection> correctionFor(const MapperParameters& parameters, occupancy::OccupancyMap& map) {
  if (parameters.localize_only) return knownMap(parameters, map, beliefOf(Pose2()));
  if (parameters.trust_odometry) return std::make_unique<slam::TrustOdometry>();
  return std::make_unique<slam::GraphSlam>(parameters.slam, parameters.map, parameters.insertion);
}

MapperParameters withRobotsRadius(MapperParameters parameters) {
  // Whichever way the robot has turned there, this much of it was on that floor.
  parameters.insertion.robot_radius = parameters.robot.drivenOutline().inscribedRadius();
  return parameters;
}

}  // namespace

Mapper::Mapper(const MapperParameters& parameters, std::unique_ptr<slam::PoseCorrection> correction)
    : parameters_(withRobotsRadius(parameters)),
      map_(parameters_.map),
      inserter_(parameters_.insertion, parameters_.slam.local.surface),
      correction_(correction ? std::move(correction) : correctionFor(parameters_, map_)) {}

ScanVerdict Mapper::insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  const ScanVerdict verdict = decide(scan, T_odom_base, now);
  note(verdict, now);
  return verdict;
}

void Mapper::reject(ScanVerdict verdict, Time now) { note(verdict, now); }

void Mapper::note(ScanVerdict verdict, Time now) {
  counts_.add(verdict);
  if (verdict == ScanVerdict::kNotMoved) return;
  const bool corrected = verdict == ScanVerdict::kMisfit || !isDropped(verdict);
  if (!corrected) return health_.add(now, toString(verdict));
  if (!sound_) return health_.add(now, last_correction_);
  health_.add(now, overgrown_ ? "corrected map too large, map and poses stay as they are" : nullptr);
}

ScanVerdict Mapper::decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  if (const auto wrong = checkStamp(scan.stamp, now)) return *wrong;
  if (!isWellFormed(scan)) return ScanVerdict::kMalformed;
  if (!T_odom_base || !T_odom_base->isFinite()) return ScanVerdict::kNoOdometry;
  if (!hasMoved(scan, *T_odom_base)) return ScanVerdict::kNotMoved;
  usable_share_ = shareOfUsable(scan);
  if (usable_share_ == 0.0) return ScanVerdict::kAllInvalid;
  if (scan.ranges.size() <= bounds::kMostMappedBeams) return integrate(scan, *T_odom_base);
  return integrate(withAtMost(bounds::kMostMappedBeams, scan), *T_odom_base);
}

ScanVerdict Mapper::integrate(const LaserScan2& scan, const Pose2& T_odom_base) {
  const slam::CorrectedScan corrected = correction_->correct(scan, T_odom_base, map_);
  last_correction_ = corrected.text;
  ++correction_counts_[corrected.text];
  sound_ = corrected.sound && corrected.fits_map;
  T_map_odom_ = corrected.T_map_odom;
  ScanVerdict verdict = ScanVerdict::kMisfit;
  if (corrected.fits_map) {
    verdict = parameters_.localize_only ? ScanVerdict::kLocalized : put(scan, T_map_odom_ * T_odom_base);
  }
  if (verdict == ScanVerdict::kMisfit || !isDropped(verdict)) last_ = Last{scan.stamp, T_odom_base};
  return verdict;
}

ScanVerdict Mapper::put(const LaserScan2& scan, const Pose2& T_map_base) {
  const ScanVerdict verdict = verdictOf(inserter_.insert(scan, T_map_base, map_));
  if (verdict == ScanVerdict::kOutOfBounds) ++out_of_bounds_;
  if (working_ && verdict == ScanVerdict::kInserted) meanwhile_.push_back({scan, T_map_base});
  return verdict;
}

slam::RevisionWork Mapper::takeWork() {
  slam::RevisionWork work = correction_->takeWork();
  if (!work) return work;
  working_ = true;
  return [work, epoch = epoch_] {
    slam::MapRevision revision = work();
    revision.epoch = epoch;
    return revision;
  };
}

bool Mapper::revise(slam::MapRevision& revision) {
  if (revision.epoch != epoch_) return false;
  if (isTooLarge(revision)) return refuse(revision);
  if (!correction_->accept(revision)) return false;
  working_ = false;
  const std::vector<Inserted> meanwhile = std::exchange(meanwhile_, {});
  T_map_odom_ = revision.T_new_old * T_map_odom_;
  revisions_.attempts = revision.counts;
  if (!revision.closures.empty()) {
    revisions_.closures += revision.closures.size();
    revisions_.last_jump = revision.T_new_old;
    revisions_.last_closures = revision.closures;
  }
  if (!revision.map) return true;
  map_.exchange(*revision.map);
  overgrown_ = false;
  ++revisions_.rendered;
  for (const Inserted& inserted : meanwhile) {
    inserter_.insert(inserted.scan, revision.T_new_old * inserted.T_map_base, map_);
  }
  return true;
}

bool Mapper::isTooLarge(const slam::MapRevision& revision) const {
  // A map that left out more than was ever refused lacks something that is mapped.
  return revision.map && (revision.left_out > out_of_bounds_ || !map_.hasRoomFor(*revision.map));
}

bool Mapper::refuse(slam::MapRevision& revision) {
  if (!correction_->refuse(revision)) return false;
  working_ = false;
  meanwhile_.clear();
  revisions_.attempts = revision.counts;
  // Nothing of it has happened.
  revision.closures.clear();
  revision.T_new_old = Pose2();
  overgrown_ = true;
  return true;
}

bool Mapper::abandonWork() {
  if (!working_) return false;
  correction_->abandonWork();
  working_ = false;
  meanwhile_.clear();
  return true;
}

void Mapper::reviseNow() {
  if (const slam::RevisionWork work = takeWork()) {
    slam::MapRevision revision = work();
    revise(revision);
  }
}

scan_matching::PoseWithCovariance Mapper::presentBelief() const {
  return beliefOf(last_ ? T_map_odom_ * last_->T_odom_base : T_map_odom_);
}

bool Mapper::load(occupancy::OccupancyMap& loaded) {
  if (!map_.exchange(loaded)) return false;
  replace(knownMap(parameters_, map_, presentBelief()));
  return true;
}

bool Mapper::resume(occupancy::OccupancyMap& map, const Pose2& T_map_odom, const Pose2& T_odom_base) {
  if (!map_.exchange(map)) return false;
  T_map_odom_ = T_map_odom;
  // Odometry that was taken for the truth since the first scan still is.
  const bool trusted = parameters_.trust_odometry && !parameters_.localize_only && T_map_odom == Pose2();
  if (!trusted) replace(knownMap(parameters_, map_, beliefOf(T_map_odom * T_odom_base)));
  return true;
}

bool Mapper::locate(const scan_matching::PoseWithCovariance& T_map_base) {
  const auto& cells = grid().cells();
  if (std::none_of(cells.begin(), cells.end(), isOccupied)) return false;
  replace(knownMap(parameters_, map_, T_map_base));
  return true;
}

void Mapper::replace(std::unique_ptr<slam::PoseCorrection> correction) {
  correction_ = std::move(correction);
  ++epoch_;
  working_ = false;
  overgrown_ = false;
  out_of_bounds_ = 0;
  meanwhile_.clear();
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
  T_map_odom_ = Pose2();
  last_.reset();
  correction_->reset();
  working_ = false;
  overgrown_ = false;
  out_of_bounds_ = 0;
  meanwhile_.clear();
  // What was known is forgotten too.
  if (epoch_ > 0) replace(correctionFor(parameters_, map_));
}

}  // namespace frontier_pilot::mapping
