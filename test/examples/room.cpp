#include "room.h"

#include <cmath>

namespace fp = frontier_pilot;

namespace examples {
namespace {

const fp::Vec2 kHalf(3.0, 2.0);  // [m]

}  // namespace

fp::LaserScan2 scanFrom(const fp::Pose2& pose, fp::Time stamp) {
  constexpr int kBeams = 360;
  fp::LaserScan2 scan;
  scan.stamp = stamp;
  scan.angle_increment = 2.0 * fp::kPi / kBeams;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  for (int i = 0; i < kBeams; ++i) {
    const fp::Vec2 beam = fp::direction(pose.yaw + scan.angle(static_cast<std::size_t>(i)));
    const double to_x = (std::copysign(kHalf.x(), beam.x()) - pose.x) / beam.x();
    const double to_y = (std::copysign(kHalf.y(), beam.y()) - pose.y) / beam.y();
    scan.ranges.push_back(static_cast<float>(std::fmin(to_x, to_y)));
  }
  return scan;
}

fp::OccupancyGrid roomMap() {
  constexpr double kWall = 0.2;  // [m]
  fp::GridGeometry geometry;
  geometry.origin = -kHalf - fp::Vec2::Constant(kWall);
  geometry.width = 128;
  geometry.height = 88;
  fp::OccupancyGrid map(geometry, fp::kFree);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const fp::Vec2 beyond = geometry.centre(geometry.cell(i)).cwiseAbs() - kHalf;
    if (beyond.maxCoeff() > 0.0) map[i] = fp::kOccupied;
  }
  return map;
}

}  // namespace examples
