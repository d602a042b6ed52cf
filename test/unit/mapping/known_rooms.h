#pragma once

#include <gtest/gtest.h>

#include "frontier_pilot/mapping/mapper.h"
#include "support/ascii_world.h"

namespace frontier_pilot::test {

/// A map of `world`, drawn with cells of 0.2 m, in the mapper's cells; it begins where the world does.
inline occupancy::OccupancyMap knownMapOf(const AsciiWorld& world) {
  occupancy::OccupancyMap map(mapping::MapperParameters{}.map);
  EXPECT_EQ(map.reserve({0.0, 0.0}, 0.2 * Vec2(world.map.width(), world.map.height())), occupancy::MapRoom::kEnough);
  for (int certainty = 0; certainty < 10; ++certainty) {
    map.beginScan();
    for (int y = 0; y < 4 * world.map.height(); ++y) {
      for (int x = 0; x < 4 * world.map.width(); ++x) {
        const Cell cell = map.geometry().cellAt({0.05 * (x + 0.5), 0.05 * (y + 0.5)});
        world.map[Cell{x / 4, y / 4}] == kOccupied ? map.hit(cell) : map.miss(cell);
      }
    }
  }
  return map;
}

}  // namespace frontier_pilot::test
