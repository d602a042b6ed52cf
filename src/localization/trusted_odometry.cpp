#include "frontier_pilot/localization/map_localization.h"

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::localization {
namespace {

constexpr double kAgrees = 0.7;     ///< least share of the returns on walls of the map for a scan to agree with it
constexpr double kElsewhere = 0.4;  ///< greatest share of them in a scan of another place
constexpr double kNear = 0.1;       ///< a robot that drives so little sees hardly anything new [m, rad]
constexpr std::size_t kFewestReturns = 30;  ///< fewer do not tell one place from another
constexpr std::size_t kMostReturns = 90;    ///< the most that are looked at

/// Whether `cell` or one of its neighbours is occupied.
bool isAtWall(Cell cell, const occupancy::OccupancyMap& map) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (map.hasWallAt({x, y})) return true;
    }
  }
  return false;
}

/// The share of the returns that are on walls of the map, give or take a cell; none of a scan with few returns.
std::optional<double> shareAtWalls(const surfaces::SurfacePoints& points, const Pose2& T_map_base,
                                   const occupancy::OccupancyMap& map) {
  if (points.size() < kFewestReturns) return std::nullopt;
  const std::size_t stride = (points.size() + kMostReturns - 1) / kMostReturns;
  std::size_t at_walls = 0, looked_at = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    at_walls += isAtWall(map.geometry().cellAt(T_map_base * points[i].position), map) ? 1 : 0;
    ++looked_at;
  }
  return static_cast<double>(at_walls) / static_cast<double>(looked_at);
}

}  // namespace

slam::CorrectedScan TrustedOdometry::correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                                             const occupancy::OccupancyMap& map) {
  if (const std::optional<double> share = shareAtWalls(scan.points, T_odom_base, map)) {
    const bool near = agreed_at_ && !isJump(*agreed_at_, T_odom_base, kNear, kNear);
    kidnapped_ = kidnapped_ ? *share < kAgrees : near && *share <= kElsewhere;
    agreed_at_.reset();
    if (*share >= kAgrees) agreed_at_ = T_odom_base;
  }
  if (kidnapped_) return {Pose2(), false, toString(slam::MatchVerdict::kKidnapped), false, false};
  return {Pose2(), true, "odometry taken as given"};
}

void TrustedOdometry::reset() { *this = TrustedOdometry(); }

}  // namespace frontier_pilot::localization
