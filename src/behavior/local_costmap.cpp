#include "behavior/local_costmap.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::behavior {
namespace {

bool isHit(RangeKind kind) { return kind == RangeKind::kHit || kind == RangeKind::kTooNear; }

}  // namespace

LocalCostmap::LocalCostmap(const LocalCostmapParameters& parameters, const Outline& footprint)
    : parameters_(parameters), footprint_(footprint) {}

void LocalCostmap::clear() {
  grid_ = OccupancyGrid();
  stamp_.reset();
}

void LocalCostmap::insert(const LaserScan2& scan, const Pose2& T_odom_base) {
  roll(T_odom_base.position());
  const Pose2 T_odom_mount = T_odom_base * scan.T_base_sensor;
  const auto T_odom_sensor = [&](std::size_t beam) {
    return scan.isMoving() ? T_odom_base * scan.mount(beam) : T_odom_mount;
  };
  clearBeams(scan, T_odom_sensor);
  // Hits are entered last, so that a beam that grazes the cell of another beam's hit does not clear it.
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const RangeReading reading = readBeam(scan, i);
    if (!isHit(reading.kind)) continue;
    const Cell cell = grid_.geometry().cellAt(T_odom_sensor(i) * Vec2(reading.distance * direction(scan.angle(i))));
    if (grid_.contains(cell)) grid_[cell] = kOccupied;
  }
  clearUnder(T_odom_base);
  stamp_ = scan.stamp;
}

void LocalCostmap::roll(const Vec2& robot) {
  const double resolution = parameters_.resolution;
  const int cells = static_cast<int>(std::ceil(parameters_.side / resolution));
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = geometry.height = cells;
  // The window moves by whole cells, so that the cells that are kept stay where they are in the odometry frame.
  const int half = cells / 2;
  geometry.origin = {resolution * (std::floor(robot.x() / resolution) - half),
                     resolution * (std::floor(robot.y() / resolution) - half)};
  if (!grid_.empty() && geometry == grid_.geometry()) return;
  OccupancyGrid rolled(geometry, kUnknown);
  if (!grid_.empty()) {
    const Vec2 shift = (geometry.origin - grid_.geometry().origin) / resolution;
    const Cell offset{static_cast<int>(std::lround(shift.x())), static_cast<int>(std::lround(shift.y()))};
    const CellRect kept = geometry.rect().intersection({-offset.x, -offset.y, grid_.width(), grid_.height()});
    for (int y = kept.y; y < kept.y + kept.height; ++y) {
      const std::int8_t* from = grid_.row(y + offset.y) + offset.x + kept.x;
      if (kept.width > 0) std::copy_n(from, kept.width, rolled.row(y) + kept.x);
    }
  }
  grid_ = std::move(rolled);
}

void LocalCostmap::clearBeams(const LaserScan2& scan, const std::function<Pose2(std::size_t)>& T_odom_sensor) {
  // No beam needs to be followed farther than the window's diagonal.
  const double longest = 1.5 * parameters_.side;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const RangeReading reading = readBeam(scan, i);
    if (reading.kind == RangeKind::kInvalid) continue;
    const double length = std::min(reading.distance, longest);
    const Pose2 from = T_odom_sensor(i);
    setFree(from.position(), from * Vec2(length * direction(scan.angle(i))));
  }
}

void LocalCostmap::setFree(const Vec2& from, const Vec2& to) {
  visitCells(grid_.geometry(), from, to, [this](Cell c) {
    if (!grid_.contains(c)) return false;
    grid_[c] = kFree;
    return true;
  });
}

void LocalCostmap::clearUnder(const Pose2& T_odom_base) {
  footprint_.cellsAt(T_odom_base, grid_.geometry(), cells_);
  for (const Cell c : cells_) {
    if (grid_.contains(c) && isUnknown(grid_[c])) grid_[c] = kFree;
  }
}

}  // namespace frontier_pilot::behavior
