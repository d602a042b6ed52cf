#include "frontier_pilot/mapping/surface_map.h"

namespace frontier_pilot {

void SurfaceMap::add(const SurfacePoints& points, const Pose2& T_map_points) {
  std::vector<Vec2> positions;
  positions.reserve(points.size());
  for (const SurfacePoint& point : points) positions.push_back(T_map_points * point.position);
  likelihood_.add(positions);
  surfels_.add(points, T_map_points);
}

}  // namespace frontier_pilot
