#include <algorithm>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::grids {
namespace {

constexpr double kMostReturns = 0.05;    ///< share of the beams; a scan with more is believed
constexpr double kLeastMeeting = 0.67;   ///< share of the beams looked at that meet a wall
constexpr double kLeastDistance = 0.15;  ///< [m], nearer the scanner may lie in the wall itself
constexpr double kRangeUsed = 0.8;       ///< share of the greatest range: beyond, pose and map may be off
constexpr double kMostRange = 20.0;      ///< [m]
constexpr std::size_t kBeams = 72;       ///< that are looked at

bool meetsWall(const Vec2& from, const Vec2& unit, double range, const GridGeometry& geometry,
               const std::function<bool(Cell)>& is_wall) {
  return !visitCells(geometry, from + kLeastDistance * unit, from + range * unit,
                     [&](Cell cell) { return !is_wall(cell); });
}

}  // namespace

bool missesWalls(const LaserScan2& scan, const Pose2& T_map_base, const GridGeometry& geometry,
                 const std::function<bool(Cell)>& is_wall) {
  const double range = std::min(kRangeUsed * scan.range_max, kMostRange);
  if (scan.ranges.empty() || range <= kLeastDistance) return false;
  std::vector<std::size_t> without_return;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const RangeKind kind = readBeam(scan, beam).kind;
    if (kind != RangeKind::kHit && kind != RangeKind::kTooNear) without_return.push_back(beam);
  }
  const std::size_t returns = scan.ranges.size() - without_return.size();
  if (static_cast<double>(returns) > kMostReturns * static_cast<double>(scan.ranges.size())) return false;
  std::size_t meeting = 0, looked_at = 0;
  for (std::size_t i = 0; i < without_return.size(); i += 1 + without_return.size() / kBeams) {
    const std::size_t beam = without_return[i];
    const Pose2 T_map_sensor = T_map_base * scan.mount(beam);
    const Vec2 unit = direction(T_map_sensor.yaw + scan.angle(beam));
    meeting += meetsWall(T_map_sensor.position(), unit, range, geometry, is_wall) ? 1 : 0;
    ++looked_at;
  }
  return static_cast<double>(meeting) > kLeastMeeting * static_cast<double>(looked_at);
}

}  // namespace frontier_pilot::grids
