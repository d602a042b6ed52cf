#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::test {

/// As config/robots/waffle.yaml: the wheels' axis far ahead of the middle, so that the corners behind swing out.
inline RobotModel waffle() {
  RobotModel robot;
  robot.outline = {0.077, 0.153, -0.205, 0.153, -0.205, -0.153, 0.077, -0.153};
  robot.disc_radius = 0.0;
  robot.limits.max_linear = 0.26;
  robot.limits.max_angular = 1.82;
  robot.scanner.x = -0.064;
  return robot;
}

/// Solid, but for corridors of `width` cells of 5 cm: three metres along x, then two and a half along y, then along x
/// again, with a corner to the left and one to the right.
inline OccupancyGrid zigzag(int width) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 120, 90}, kOccupied);
  const auto clear = [&](const CellRect& cells) {
    for (int y = cells.y; y < cells.y + cells.height; ++y) {
      for (int x = cells.x; x < cells.x + cells.width; ++x) map[Cell{x, y}] = kFree;
    }
  };
  clear({5, 10, 60, width});
  clear({65 - width, 10, width, 50});
  clear({65 - width, 60 - width, 60, width});
  return map;
}

}  // namespace frontier_pilot::test
