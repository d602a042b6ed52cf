#include "frontier_pilot/mapping/known_map.h"

#include <sstream>

namespace frontier_pilot {
namespace {

std::string bytesOf(OccupancyMap& map) {
  std::ostringstream out;
  map.write(out);
  return out.str();
}

}  // namespace

KnownMap::KnownMap(Use use, const GraphSlamParameters& parameters, OccupancyMap& map,
                   const ScanInsertionParameters& insertion, const PoseBelief& T_map_base)
    : use_(use), localizer_(parameters.local, map.grid(), T_map_base) {
  if (use != Use::kGoOnMapping) return;
  slam_ = std::make_unique<GraphSlam>(parameters, map.parameters(), insertion, bytesOf(map));
}

CorrectedScan KnownMap::correct(const LaserScan2& scan, const Pose2& T_odom_base, const OccupancyMap& map) {
  if (!T_map_odom_) {
    const MatchVerdict verdict = localizer_.update(scan, T_odom_base);
    const char* text = localizer_.isLocated() ? toString(verdict) : "looking for the robot in the known map";
    if (use_ == Use::kLocalizeOnly || !localizer_.isLocated())
      return {localizer_.T_map_odom(), isMatched(verdict), text, verdict == MatchVerdict::kMatched};
    T_map_odom_ = localizer_.T_map_odom();
  }
  if (!slam_) return {*T_map_odom_, true, "odometry taken as given"};
  CorrectedScan corrected = slam_->correct(scan, *T_map_odom_ * T_odom_base, map);
  corrected.T_map_odom = corrected.T_map_odom * *T_map_odom_;
  return corrected;
}

std::vector<KeyframePose> KnownMap::trajectory() const {
  if (!slam_ || !T_map_odom_) return {};
  std::vector<KeyframePose> trajectory = slam_->trajectory();
  for (KeyframePose& keyframe : trajectory) keyframe.T_odom_base = T_map_odom_->inverse() * keyframe.T_odom_base;
  return trajectory;
}

void KnownMap::reset() {}

}  // namespace frontier_pilot
