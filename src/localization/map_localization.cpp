#include "frontier_pilot/localization/map_localization.h"

#include <sstream>
#include <string>

#include "frontier_pilot/slam/graph_slam.h"
#include "localization/localizer.h"

namespace frontier_pilot::localization {
namespace {

std::string bytesOf(occupancy::OccupancyMap& map) {
  std::ostringstream out;
  map.write(out);
  return out.str();
}

/// What is wrong with a scan that was to tell where the robot is.
const char* textOf(slam::MatchVerdict verdict) {
  switch (verdict) {
    case slam::MatchVerdict::kFirst:
      return "not localised: there is no map to localise on";
    case slam::MatchVerdict::kTooFew:
      return "not localised: too few returns";
    case slam::MatchVerdict::kPoor:
    case slam::MatchVerdict::kKidnapped:
    case slam::MatchVerdict::kLost:
      return "not localised: the scan fits nowhere on the map here; give a pose, or call mapper/localize";
    case slam::MatchVerdict::kAmbiguous:
      return "not localised: several places on the map here look alike; drive on, or give a pose";
    default:
      return toString(verdict);
  }
}

}  // namespace

struct MapLocalization::Impl {
  Impl(Use use_of_map, const slam::GraphSlamParameters& parameters, const OccupancyGrid& map,
       const scan_matching::PoseWithCovariance& T_map_base, const std::optional<Pose2>& T_odom_base)
      : use(use_of_map), localizer(parameters, map, T_map_base, T_odom_base) {}

  Use use;
  Localizer localizer;
  std::unique_ptr<slam::PoseCorrection> continuation;  ///< to continue mapping
  /// The pose of the odometry frame when the robot was found; none until then. `continuation` gets odometry that is
  /// transformed by it, so its local frame begins as the map frame.
  std::optional<Pose2> T_map_odom;
};

MapLocalization::MapLocalization(Use use, const slam::GraphSlamParameters& parameters, occupancy::OccupancyMap& map,
                                 const occupancy::ScanInsertionParameters& insertion,
                                 const scan_matching::PoseWithCovariance& T_map_base,
                                 const std::optional<Pose2>& T_odom_base)
    : impl_(std::make_unique<Impl>(use, parameters, map.projection(), T_map_base, T_odom_base)) {
  if (use == Use::kTrustOdometry) impl_->continuation = std::make_unique<TrustedOdometry>();
  if (use == Use::kGoOnMapping)
    impl_->continuation = std::make_unique<slam::GraphSlam>(parameters, map.parameters(), insertion, bytesOf(map));
}
MapLocalization::~MapLocalization() = default;

slam::CorrectedScan MapLocalization::correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                                             const occupancy::OccupancyMap& map) {
  std::optional<Pose2>& T_map_odom = impl_->T_map_odom;
  if (!T_map_odom) {
    Localizer& localizer = impl_->localizer;
    const slam::MatchVerdict verdict = localizer.update(scan, T_odom_base);
    const bool fits = slam::isMatched(verdict);
    // On a map that shows nothing yet the robot cannot be found, and is where it is said to be.
    const bool is_known = localizer.isLocated() || !localizer.hasSurfaces();
    if (impl_->use == Use::kLocalizeOnly || !is_known)
      return {localizer.T_map_odom(), fits, textOf(verdict), verdict == slam::MatchVerdict::kMatched, fits};
    T_map_odom = localizer.T_map_odom();
  }
  slam::CorrectedScan corrected = impl_->continuation->correct(scan, *T_map_odom * T_odom_base, map);
  corrected.T_map_odom = corrected.T_map_odom * *T_map_odom;
  return corrected;
}

Pose2 MapLocalization::withoutErrors(const Pose2& motion) const {
  return impl_->T_map_odom ? impl_->continuation->withoutErrors(motion) : impl_->localizer.withoutErrors(motion);
}

slam::RevisionWork MapLocalization::takeWork() {
  return impl_->continuation ? impl_->continuation->takeWork() : slam::RevisionWork();
}

bool MapLocalization::accept(const slam::MapRevision& revision) {
  return impl_->continuation && impl_->continuation->accept(revision);
}

bool MapLocalization::refuse(const slam::MapRevision& revision) {
  return impl_->continuation && impl_->continuation->refuse(revision);
}

void MapLocalization::abandonWork() {
  if (impl_->continuation) impl_->continuation->abandonWork();
}

std::vector<slam::KeyframePose> MapLocalization::trajectory() const {
  if (!impl_->continuation || !impl_->T_map_odom) return {};
  std::vector<slam::KeyframePose> trajectory = impl_->continuation->trajectory();
  const Pose2 T_odom_map = impl_->T_map_odom->inverse();
  for (slam::KeyframePose& keyframe : trajectory) keyframe.T_odom_base = T_odom_map * keyframe.T_odom_base;
  return trajectory;
}

std::size_t MapLocalization::keyframes() const { return impl_->continuation ? impl_->continuation->keyframes() : 0; }

void MapLocalization::reset() {}

}  // namespace frontier_pilot::localization
