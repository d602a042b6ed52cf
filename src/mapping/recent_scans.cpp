#include "mapping/recent_scans.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::mapping {
namespace {

constexpr std::size_t kMost = 7;  // besides the latest
constexpr double kApart = 0.5;    // [m] between two scans that are kept: odometry drifts by a few centimetres over all
constexpr double kTurned = 0.8;   // [rad]: or they differ by this much
constexpr double kJump = 3.0;     // [m]: the way between two scans that belong together is shorter

}  // namespace

void RecentScans::add(const surfaces::SurfacePoints& points, const Pose2& T_odom_base) {
  const bool moved =
      has_latest_ && (kept_.empty() || isJump(kept_.back().T_odom_base, latest_.T_odom_base, kApart, kTurned));
  if (has_latest_ && isJump(latest_.T_odom_base, T_odom_base, kJump, kPi)) {
    clear();
  } else if (moved) {
    kept_.push_back(std::move(latest_));
  }
  if (kept_.size() > kMost) kept_.pop_front();
  latest_ = {points, T_odom_base};
  has_latest_ = true;
}

void RecentScans::clear() {
  kept_.clear();
  has_latest_ = false;
}

std::vector<localization::RecentScan> RecentScans::scans() const {
  if (!has_latest_) return {};
  const Pose2 T_last_odom = latest_.T_odom_base.inverse();
  std::vector<localization::RecentScan> scans;
  for (const Entry& entry : kept_) scans.push_back({entry.points, T_last_odom * entry.T_odom_base});
  scans.push_back({latest_.points, Pose2()});
  return scans;
}

std::function<RobotSearch()> RecentScans::searchOn(const OccupancyGrid& map, std::uint64_t generation,
                                                   const slam::GraphSlamParameters& parameters,
                                                   const std::function<bool()>& stop) const {
  return [map, generation, parameters, stop, scans = scans(), T_odom_base = latest_.T_odom_base] {
    return RobotSearch{localization::searchWholeMap(map, scans, parameters, stop), T_odom_base, generation};
  };
}

}  // namespace frontier_pilot::mapping
