#include "frontier_pilot/mapping/mapper.h"

#include <cmath>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/surfaces/surface_points.h"
#include "mapping/corrections.h"
#include "mapping/mapper_impl.h"
#include "mapping/scan_checks.h"

namespace frontier_pilot::mapping {
namespace {

MapperParameters withRobotsRadius(MapperParameters parameters) {
  // The robot covers the disc of its inscribed radius whatever its yaw.
  parameters.insertion.robot_radius = parameters.robot.drivenOutline().inscribedRadius();
  return parameters;
}

}  // namespace

Mapper::Impl::Impl(const MapperParameters& given, std::unique_ptr<slam::PoseCorrection> corrector)
    : parameters(withRobotsRadius(given)),
      map(parameters.map),
      inserter(parameters.insertion),
      correction(corrector ? std::move(corrector) : correctionFor(parameters, map)),
      localization(parameters.localize_only) {}

Mapper::Mapper(const MapperParameters& parameters, std::unique_ptr<slam::PoseCorrection> correction)
    : impl_(std::make_unique<Impl>(parameters, std::move(correction))) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

ScanVerdict Mapper::insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  const ScanVerdict verdict = impl_->decide(scan, T_odom_base, now);
  impl_->note(verdict, now);
  return verdict;
}

void Mapper::reject(ScanVerdict verdict, Time now) { impl_->note(verdict, now); }

void Mapper::Impl::note(ScanVerdict verdict, Time now) {
  counts.add(verdict);
  if (verdict == ScanVerdict::kNotMoved) return;
  if (!wasCorrected(verdict)) return health.add(now, toString(verdict));
  if (!sound) return health.add(now, last_correction);
  if (overgrown) return health.add(now, "corrected map too large, map and poses stay as they are");
  health.add(now, map.isFull() ? kMemoryUsedUp : nullptr);
}

ScanVerdict Mapper::Impl::decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now) {
  if (const auto wrong = checkStamp(scan.stamp, now)) return *wrong;
  if (!isWellFormed(scan)) return ScanVerdict::kMalformed;
  if (!T_odom_base || !isUsable(*T_odom_base)) return ScanVerdict::kNoOdometry;
  if (!hasMoved(scan, *T_odom_base)) return ScanVerdict::kNotMoved;
  if (scan.ranges.size() <= bounds::kMostMappedBeams) return take(scan, *T_odom_base);
  return take(withAtMost(bounds::kMostMappedBeams, scan), *T_odom_base);
}

ScanVerdict Mapper::Impl::take(const LaserScan2& scan, const Pose2& T_odom_base) {
  const surfaces::SurfaceScan read = surfaces::readScan(withoutErrors(*correction, scan), parameters.slam.surface);
  usable_share = static_cast<double>(read.usableBeams()) / static_cast<double>(scan.ranges.size());
  if (usable_share <= 0.0) return ScanVerdict::kAllInvalid;
  const auto is_wall = [this](Cell cell) { return map.hasWallAt(cell); };
  if (blindness.isBlind(scan, T_map_odom * T_odom_base, map.geometry(), is_wall)) return ScanVerdict::kBlind;
  return integrate(read, T_odom_base);
}

ScanVerdict Mapper::Impl::integrate(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base) {
  recent.add(scan.points, T_odom_base);
  const slam::CorrectedScan corrected = correction->correct(scan, T_odom_base, map);
  last_correction = corrected.text;
  ++correction_counts[corrected.text];
  sound = corrected.sound && corrected.fits_map;
  T_map_odom = corrected.T_map_odom;
  localization.take(corrected.fits_map || corrected.located, T_odom_base);
  ScanVerdict verdict = corrected.located ? ScanVerdict::kMisfit : ScanVerdict::kNotLocated;
  if (corrected.fits_map) {
    verdict = parameters.localize_only ? ScanVerdict::kLocalized : put(scan, T_map_odom * T_odom_base);
  }
  if (wasCorrected(verdict)) last = StampedPose2{scan.stamp, T_odom_base};
  return verdict;
}

ScanVerdict Mapper::Impl::put(const surfaces::SurfaceScan& scan, const Pose2& T_map_base) {
  const occupancy::Insertion insertion = inserter.insert(scan, T_map_base, map);
  if (lacksRoom(insertion)) ++out_of_bounds;
  if (working && insertion == occupancy::Insertion::kInserted) meanwhile.push_back({scan, T_map_base});
  return verdictOf(insertion);
}

slam::RevisionWork Mapper::takeWork() {
  slam::RevisionWork work = impl_->correction->takeWork();
  if (!work) return work;
  impl_->working = true;
  return [work, epoch = impl_->epoch] {
    slam::MapRevision revision = work();
    revision.epoch = epoch;
    return revision;
  };
}

bool Mapper::revise(slam::MapRevision& revision) {
  if (revision.epoch != impl_->epoch) return false;
  if (impl_->isTooLarge(revision)) return impl_->refuse(revision);
  if (!impl_->correction->accept(revision)) return false;
  impl_->working = false;
  if (revision.map || !(revision.T_new_old == Pose2())) impl_->inserter.forgetLoneReturns();
  const std::vector<Impl::Inserted> meanwhile = std::exchange(impl_->meanwhile, {});
  impl_->T_map_odom = revision.T_new_old * impl_->T_map_odom;
  impl_->revisions.attempts = revision.counts;
  if (!revision.closures.empty()) {
    impl_->revisions.closures += revision.closures.size();
    impl_->revisions.last_jump = revision.T_new_old;
    impl_->revisions.last_closures = revision.closures;
  }
  if (!revision.map) return true;
  impl_->map.exchange(*revision.map);
  ++impl_->generation;
  impl_->overgrown = false;
  ++impl_->revisions.rendered;
  for (const Impl::Inserted& inserted : meanwhile) {
    impl_->inserter.insert(inserted.scan, revision.T_new_old * inserted.T_map_base, impl_->map);
  }
  return true;
}

bool Mapper::Impl::isTooLarge(const slam::MapRevision& revision) const {
  // If it lacks more keyframes than scans were ever refused, it lacks some that the present map contains.
  const auto lacksMemory = [&] { return revision.map->isFull() && !map.isFull(); };
  return revision.map && (revision.left_out > out_of_bounds || lacksMemory() || !map.hasRoomFor(*revision.map));
}

bool Mapper::Impl::refuse(slam::MapRevision& revision) {
  if (!correction->refuse(revision)) return false;
  working = false;
  meanwhile.clear();
  revisions.attempts = revision.counts;
  revision.closures.clear();  // none of it takes effect
  revision.T_new_old = Pose2();
  overgrown = true;
  return true;
}

bool Mapper::abandonWork() {
  if (!impl_->working) return false;
  impl_->correction->abandonWork();
  impl_->abandoned = std::exchange(impl_->working, false);
  impl_->meanwhile.clear();
  return true;
}

bool Mapper::hasAbandonedWork() const { return impl_->abandoned; }

void Mapper::reviseNow() {
  if (const slam::RevisionWork work = takeWork()) {
    slam::MapRevision revision = work();
    revise(revision);
  }
}

void Mapper::Impl::forgetEarlierPoses() {
  inserter.forgetLoneReturns();
  working = abandoned = overgrown = false;
  out_of_bounds = 0;
  meanwhile.clear();
}

std::optional<ScanVerdict> Mapper::Impl::checkStamp(Time stamp, Time now) {
  // The clock was set back: stamps may repeat.
  if (now < last_now) {
    last.reset();
    recent.clear();
  }
  last_now = now;
  if (toSeconds(now - stamp) > parameters.max_age || (last && stamp <= last->stamp)) return ScanVerdict::kStale;
  if (toSeconds(stamp - now) > parameters.max_lead) return ScanVerdict::kFuture;
  return std::nullopt;
}

bool Mapper::Impl::hasMoved(const LaserScan2& scan, const Pose2& T_odom_base) const {
  if (!last || toSeconds(scan.stamp - last->stamp) >= parameters.standing_period) return true;
  const Pose2 step = last->pose.inverse() * T_odom_base;
  return step.position().norm() >= parameters.min_travel || std::abs(step.yaw) >= parameters.min_rotation;
}

void Mapper::reset() {
  impl_->map.clear();
  ++impl_->generation;
  impl_->T_map_odom = Pose2();
  impl_->last.reset();
  impl_->recent.clear();
  impl_->correction->reset();
  impl_->forgetEarlierPoses();
  impl_->localization.reset();
  if (impl_->epoch > 0) impl_->replace(correctionFor(impl_->parameters, impl_->map));  // a known map is forgotten too
}

occupancy::OccupancyMap& Mapper::map() { return impl_->map; }
const occupancy::OccupancyMap& Mapper::map() const { return impl_->map; }
const Pose2& Mapper::T_map_odom() const { return impl_->T_map_odom; }
const ScanCounts& Mapper::counts() const { return impl_->counts; }
const RevisionReport& Mapper::revisions() const { return impl_->revisions; }
const std::map<std::string, std::uint64_t>& Mapper::correctionCounts() const { return impl_->correction_counts; }
std::uint64_t Mapper::generation() const { return impl_->generation; }
const char* Mapper::lastCorrection() const { return impl_->last_correction; }
bool Mapper::isLocalized() const { return impl_->localization.isLocalized(); }
double Mapper::usableShare() const { return impl_->usable_share; }
std::optional<ScanRemark> Mapper::remark(Time now) const { return impl_->health.worst(now); }
std::vector<slam::KeyframePose> Mapper::trajectory() const { return impl_->correction->trajectory(); }
std::size_t Mapper::keyframes() const { return impl_->correction->keyframes(); }

}  // namespace frontier_pilot::mapping
