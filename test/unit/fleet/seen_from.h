#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// What a robot that started at `start` knows of `world`, up to `range` [m] from there, in its own map's frame.
inline OccupancyGrid seenFrom(const OccupancyGrid& world, const Pose2& start, double range) {
  const int half = static_cast<int>(range / 0.05);
  GridGeometry geometry;
  geometry.width = geometry.height = 2 * half;
  geometry.origin = Vec2(-half, -half) * geometry.resolution;
  OccupancyGrid map(geometry, kUnknown);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Vec2 point = geometry.centre(geometry.cell(i));
    if (point.norm() < range) map[i] = world.get(world.geometry().cellAt(start * point), kUnknown);
  }
  return map;
}

}  // namespace frontier_pilot::test
