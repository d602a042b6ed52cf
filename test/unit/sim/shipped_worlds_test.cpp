#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "frontier_pilot/sim/simulator.h"
#include "sim/reachable_floor.h"

namespace frontier_pilot::sim {
namespace {

class ShippedWorld : public ::testing::TestWithParam<const char*> {};

// [SIM-1] every world of ours can be started in, and nearly all of its floor can be reached from there
TEST_P(ShippedWorld, IsReachableFromItsStart_SIM_1) {
  const World world = loadWorld(std::string(FRONTIER_PILOT_WORLDS) + "/" + GetParam() + ".yaml");
  ASSERT_TRUE(world.start);
  EXPECT_NO_THROW(Simulator(world, SimulatorParameters{}));
  const Cell start = world.map.geometry().cellAt(world.start->position());
  const Grid<std::uint8_t> floor = reachableFloor(world.map, start, 3);
  const auto reachable = std::count(floor.cells().begin(), floor.cells().end(), 1);
  const auto free = std::count(world.map.cells().begin(), world.map.cells().end(), kFree);
  EXPECT_GT(static_cast<double>(reachable), 0.95 * static_cast<double>(free));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorld, ::testing::Values("flat", "office", "maze", "cave", "loop", "small"));

}  // namespace
}  // namespace frontier_pilot::sim
