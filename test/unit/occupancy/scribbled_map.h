#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot {

inline Cell cellAt(const occupancy::OccupancyMap& map, double x, double y) { return map.geometry().cellAt({x, y}); }

inline void hit(occupancy::OccupancyMap& map, Cell cell) {
  map.beginScan();
  map.hit(cell);
}
inline void miss(occupancy::OccupancyMap& map, Cell cell) {
  map.beginScan();
  map.miss(cell);
}

inline occupancy::OccupancyMap smallMap() {
  occupancy::OccupancyMap map;
  EXPECT_EQ(map.reserve({-1.0, -1.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
  return map;
}

/// Hits and misses at random cells of a map that grows meanwhile.
inline void scribble(occupancy::OccupancyMap& map, int scans) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-12.0, 12.0);
  for (int i = 0; i < scans; ++i) {
    const Vec2 point(place(random), place(random));
    ASSERT_EQ(map.reserve(point, point), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int k = 0; k < 20; ++k) {
      const Cell cell = map.geometry().cellAt({point.x(), point.y()});
      const Cell near{cell.x, std::max(0, cell.y - k)};
      (i + k) % 3 == 0 ? map.hit(near) : map.miss(near);
    }
  }
}

inline std::size_t knownCells(const occupancy::OccupancyMap& map) {
  std::size_t known = 0;
  for (const std::int8_t value : map.grid().cells()) known += isUnknown(value) ? 0U : 1U;
  return known;
}

}  // namespace frontier_pilot
