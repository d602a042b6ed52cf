#include "frontier_pilot/localization/map_localization.h"

#include <sstream>

namespace frontier_pilot::localization {
namespace {

std::string bytesOf(occupancy::OccupancyMap& map) {
  std::ostringstream out;
  map.write(out);
  return out.str();
}

}  // namespace

MapLocalization::MapLocalization(Use use, const slam::GraphSlamParameters& parameters, occupancy::OccupancyMap& map,
                                 const occupancy::ScanInsertionParameters& insertion,
                                 const scan_matching::PoseWithCovariance& T_map_base)
    : use_(use), localizer_(parameters.local, map.grid(), T_map_base) {
  if (use != Use::kGoOnMapping) return;
  slam_ = std::make_unique<slam::GraphSlam>(parameters, map.parameters(), insertion, bytesOf(map));
}

slam::CorrectedScan MapLocalization::correct(const LaserScan2& scan, const Pose2& T_odom_base,
                                             const occupancy::OccupancyMap& map) {
  if (!T_map_odom_) {
    const slam::MatchVerdict verdict = localizer_.update(scan, T_odom_base);
    const char* text = localizer_.isLocated() ? toString(verdict) : "looking for the robot in the known map";
    if (use_ == Use::kLocalizeOnly || !localizer_.isLocated())
      return {localizer_.T_map_odom(), slam::isMatched(verdict), text, verdict == slam::MatchVerdict::kMatched};
    T_map_odom_ = localizer_.T_map_odom();
  }
  if (!slam_) return {*T_map_odom_, true, "odometry taken as given"};
  slam::CorrectedScan corrected = slam_->correct(scan, *T_map_odom_ * T_odom_base, map);
  corrected.T_map_odom = corrected.T_map_odom * *T_map_odom_;
  return corrected;
}

std::vector<slam::KeyframePose> MapLocalization::trajectory() const {
  if (!slam_ || !T_map_odom_) return {};
  std::vector<slam::KeyframePose> trajectory = slam_->trajectory();
  for (slam::KeyframePose& keyframe : trajectory) keyframe.T_odom_base = T_map_odom_->inverse() * keyframe.T_odom_base;
  return trajectory;
}

void MapLocalization::reset() {}

}  // namespace frontier_pilot::localization
