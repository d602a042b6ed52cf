#include <gtest/gtest.h>

#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

// [MAP-5] [MUL-1] The common map of several robots may be larger than the map that one of them makes.
TEST(SavedGrid, MayBeLongerThanTheMapOfOneRobot_MAP_5_MUL_1) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "merged").string();
  OccupancyGrid grid(GridGeometry{1.0, Vec2(-12.5, 0.5), 1200, 5}, kFree);
  grid[Cell{1199, 2}] = kOccupied;
  const map_files::MapIoResult saved = map_files::saveGrid(grid, path);
  ASSERT_TRUE(saved.ok()) << saved.text;
  occupancy::OccupancyMapParameters parameters;
  parameters.resolution = 1.0;
  parameters.max_side = 2000.0;
  occupancy::OccupancyMap loaded(parameters);
  const map_files::MapIoResult result = map_files::loadMap(path, loaded);
  ASSERT_TRUE(result.ok()) << result.text;
  int occupied = 0;
  for (const std::int8_t cell : loaded.grid().cells()) occupied += isOccupied(cell) ? 1 : 0;
  EXPECT_EQ(occupied, 1);
}

}  // namespace
}  // namespace frontier_pilot
