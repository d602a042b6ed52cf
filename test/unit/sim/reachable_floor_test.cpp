#include "sim/reachable_floor.h"

#include <gtest/gtest.h>

#include <random>

#include "support/ascii_world.h"

namespace frontier_pilot::sim {
namespace {

using test::drawWorld;

// The definition, cell by cell and disc by disc.
Grid<std::uint8_t> slowly(const OccupancyGrid& truth, Cell start, int radius) {
  const auto disc = [&](Cell c, const auto& visit) {
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const Cell other{c.x + dx, c.y + dy};
        if (dx * dx + dy * dy <= radius * radius && truth.contains(other)) visit(other);
      }
    }
  };
  const auto fits = [&](Cell c) {
    bool free = truth.contains(c);
    if (free) disc(c, [&](Cell other) { free = free && truth[other] == kFree; });
    return free;
  };
  Grid<std::uint8_t> centres(truth.geometry());
  std::vector<Cell> open;
  if (fits(start)) open.push_back(start);
  while (!open.empty()) {
    const Cell c = open.back();
    open.pop_back();
    if (centres[c] != 0) continue;
    centres[c] = 1;
    for (const Cell n : {Cell{c.x + 1, c.y}, {c.x - 1, c.y}, {c.x, c.y + 1}, {c.x, c.y - 1}}) {
      if (fits(n)) open.push_back(n);
    }
  }
  Grid<std::uint8_t> floor(truth.geometry());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (centres[i] != 0) disc(truth.geometry().cell(i), [&](Cell c) { floor[c] = 1; });
  }
  return floor;
}

TEST(ReachableFloor, IsWhatADiscCovers) {
  const test::AsciiWorld world = drawWorld(R"(
      ################
      #......##......#
      #......##......#
      #...s..........#
      #......##......#
      #......##......#
      ################)");
  const Grid<std::uint8_t> narrow = reachableFloor(world.map, world.cell('s'), 1);
  EXPECT_EQ((narrow[Cell{4, 3}]), 1);
  EXPECT_EQ((narrow[Cell{12, 3}]), 0) << "the door is too narrow for the disc";
  EXPECT_EQ((narrow[Cell{1, 1}]), 0) << "a disc does not reach into a corner";
  EXPECT_EQ((narrow[Cell{2, 1}]), 1);
  EXPECT_EQ((reachableFloor(world.map, world.cell('s'), 0)[Cell{12, 3}]), 1);
}

TEST(ReachableFloor, IsTheDefinitionOnRandomWorlds) {
  std::mt19937 random(6);
  for (int i = 0; i < 40; ++i) {
    OccupancyGrid truth(GridGeometry{0.05, Vec2::Zero(), 37, 23});
    for (std::size_t c = 0; c < truth.size(); ++c)
      truth[c] = random() % 100 < 2 ? (random() % 2 ? kOccupied : kUnknown) : kFree;
    const Cell start{static_cast<int>(random() % 37), static_cast<int>(random() % 23)};
    for (int radius : {0, 1, 2, 3}) {
      ASSERT_EQ(reachableFloor(truth, start, radius).cells(), slowly(truth, start, radius).cells())
          << i << " " << radius;
    }
  }
}

}  // namespace
}  // namespace frontier_pilot::sim
