#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

/// Halls in which two robots start, and a comparison of a place that was found with the true one.
namespace frontier_pilot::test {

inline void fill(OccupancyGrid& map, const CellRect& cells) {
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) map[Cell{x, y}] = kOccupied;
  }
}

inline OccupancyGrid emptyHall() {
  GridGeometry geometry;
  geometry.width = 400;
  geometry.height = 300;
  OccupancyGrid map(geometry, kFree);
  fill(map, {0, 0, 400, 2});
  fill(map, {0, 298, 400, 2});
  fill(map, {0, 0, 2, 300});
  fill(map, {398, 0, 2, 300});
  return map;
}

/// A hall of 20 m x 15 m with boxes of all sizes.
inline OccupancyGrid furnished(unsigned seed) {
  OccupancyGrid map = emptyHall();
  std::mt19937 random(seed);
  for (int i = 0; i < 40; ++i) {
    const int width = 4 + static_cast<int>(random() % 20);
    const int height = 4 + static_cast<int>(random() % 20);
    const int x = 10 + static_cast<int>(random() % 360U);
    const int y = 10 + static_cast<int>(random() % 260U);
    fill(map, CellRect{x, y, width, height});
  }
  return map;
}

inline const Pose2 kFirstStart(8.0, 7.0, 0.4);
inline const Pose2 kSecondStart(12.0, 8.0, -2.0);

inline void expectNear(const Pose2& found, const Pose2& truth) {
  const Pose2 error = truth.inverse() * found;
  EXPECT_LT(error.position().norm(), 0.05);
  EXPECT_LT(std::abs(error.yaw), 0.0087);
}

}  // namespace frontier_pilot::test
