#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::grids {
namespace {

constexpr double kMostReturns = 0.05;     ///< share of the beams; a scan with more is believed
constexpr double kSeeing = 0.25;          ///< share of the beams of a scanner that sees its surroundings
constexpr double kMomentAgo = 1.0;        ///< [m]
constexpr double kLeastView = 0.9 * kPi;  ///< [rad]; a scanner that sees less may look through one open door
constexpr double kLeastMeeting = 0.67;    ///< share of the beams looked at that meet a wall
constexpr double kLeastDistance = 0.15;   ///< [m]: what is nearer may be the cell that the scanner itself is in
constexpr double kRangeUsed = 0.8;        ///< share of the greatest range: beyond, pose and map may be off
constexpr double kMostReach = 8.0;        ///< [m]: scanners that announce more often miss dark walls beyond
constexpr std::size_t kBeams = 72;        ///< the most that are looked at

bool isReturn(const LaserScan2& scan, std::size_t beam) {
  const RangeKind kind = readBeam(scan, beam).kind;
  return kind == RangeKind::kHit || kind == RangeKind::kTooNear;
}

double shareOfReturns(const LaserScan2& scan) {
  std::size_t returns = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) returns += isReturn(scan, beam) ? 1 : 0;
  return scan.ranges.empty() ? 0.0 : static_cast<double>(returns) / static_cast<double>(scan.ranges.size());
}

bool meetsWall(const Vec2& from, const Vec2& unit, double range, const GridGeometry& geometry,
               const std::function<bool(Cell)>& is_wall) {
  return !visitCells(geometry, from + kLeastDistance * unit, from + range * unit,
                     [&](Cell cell) { return !is_wall(cell); });
}

/// Whether most of the beams without a return meet walls by the map.
bool missesWalls(const LaserScan2& scan, const Pose2& T_map_base, const GridGeometry& geometry,
                 const std::function<bool(Cell)>& is_wall) {
  const double range = std::min(kRangeUsed * scan.range_max, kMostReach);
  const double view = std::abs(scan.angle_increment) * static_cast<double>(scan.ranges.size());
  if (range <= kLeastDistance || view < kLeastView) return false;
  std::size_t meeting = 0, looked_at = 0;
  const std::size_t stride = (scan.ranges.size() + kBeams - 1) / kBeams;
  for (std::size_t beam = 0; beam < scan.ranges.size(); beam += stride) {
    if (isReturn(scan, beam)) continue;
    const Pose2 T_map_sensor = T_map_base * scan.mount(beam);
    const Vec2 unit = direction(T_map_sensor.yaw + scan.angle(beam));
    meeting += meetsWall(T_map_sensor.position(), unit, range, geometry, is_wall) ? 1 : 0;
    ++looked_at;
  }
  return static_cast<double>(meeting) > kLeastMeeting * static_cast<double>(looked_at);
}

}  // namespace

bool BlindnessCheck::isBlind(const LaserScan2& scan, const Pose2& T_map_base, const GridGeometry& geometry,
                             const std::function<bool(Cell)>& is_wall) {
  const double returns = shareOfReturns(scan);
  if (returns >= kSeeing) saw_at_ = T_map_base.position();
  const bool saw = saw_at_ && (*saw_at_ - T_map_base.position()).norm() < kMomentAgo;
  return saw && returns <= kMostReturns && missesWalls(scan, T_map_base, geometry, is_wall);
}

}  // namespace frontier_pilot::grids
