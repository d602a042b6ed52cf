// Maps that are too large for the robot to be found in them. [MAP-5]

#include <gtest/gtest.h>

#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::test {
namespace {

mapping::MapperParameters parametersOf(double resolution) {
  mapping::MapperParameters parameters;
  parameters.map.resolution = resolution;
  parameters.map.max_side = 1000.0;
  return parameters;
}

/// A map with one wall in a box of `side` [m].
occupancy::OccupancyMap mapOf(double resolution, double side) {
  occupancy::OccupancyMap map(parametersOf(resolution).map);
  EXPECT_EQ(map.reserve({0.0, 0.0}, {side, side}), occupancy::MapRoom::kEnough);
  for (int certainty = 0; certainty < 10; ++certainty) {
    map.beginScan();
    map.hit({5, 5});
    map.miss({6, 5});
  }
  return map;
}

// [MAP-5] The search keeps grids of 5 cm, however large the map's own cells are.
TEST(LargeMap, IsRefusedByTheGroundThatItCoversAndNotByItsOwnCells_MAP_5) {
  for (const double resolution : {0.05, 0.1, 0.5}) {
    mapping::Mapper mapper(parametersOf(resolution));
    occupancy::OccupancyMap large = mapOf(resolution, 330.0);
    EXPECT_FALSE(mapper.load(large)) << resolution;
    occupancy::OccupancyMap small = mapOf(resolution, 250.0);
    EXPECT_TRUE(mapper.load(small)) << resolution;
  }
}

// [MAP-5]
TEST(LargeMap, IsNotSearched_MAP_5) {
  mapping::Mapper mapper(parametersOf(0.1));
  occupancy::OccupancyMap large = mapOf(0.1, 330.0);
  mapper.map().replaceBy(large);  // as if it had mapped all of that
  EXPECT_FALSE(mapper.locate(scan_matching::PoseWithCovariance{}));
  EXPECT_EQ(mapper.whyNotFound(), "the map is too large for the robot to be found in it, see docs/limits.md");
  EXPECT_EQ(describe(mapper.searchWork()().result), "refused: the map is too large to be searched, see docs/limits.md");
}

}  // namespace
}  // namespace frontier_pilot::test
