#include "frontier_pilot/scan_matching/surface_map.h"

namespace frontier_pilot::scan_matching {

void SurfaceMap::add(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  std::vector<Vec2> positions;
  positions.reserve(points.size());
  for (const surfaces::SurfacePoint& point : points) positions.push_back(T_map_points * point.position);
  likelihood_.add(positions);
  surfels_.add(points, T_map_points);
}

}  // namespace frontier_pilot::scan_matching
