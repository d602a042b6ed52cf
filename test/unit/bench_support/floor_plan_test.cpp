#include "support/floor_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"
#include "frontier_pilot/grids/distance_field.h"
#include "sim/reachable_floor.h"

namespace frontier_pilot {
namespace {

using bench::BuildingKind;
using bench::FloorPlan;

const std::vector<FloorPlan>& allPlans() {
  static const std::vector<FloorPlan> plans = [] {
    std::vector<FloorPlan> drawn;
    for (int number = 1; number <= bench::kFloorPlans; ++number) drawn.push_back(bench::floorPlan(number));
    return drawn;
  }();
  return plans;
}

/// The floor that a disc with a radius of 0.15 m reaches from the start.
Grid<std::uint8_t> reachableFloor(const FloorPlan& plan) {
  return sim::reachableFloor(plan.map, plan.map.geometry().cellAt(plan.start.position()), 3);
}

double squareMetres(std::ptrdiff_t cells) { return 0.0025 * static_cast<double>(cells); }

TEST(FloorPlans, AreTheSameWhenDrawnAgain) {
  for (const int number : {1, 4, 14, 39}) {
    const FloorPlan again = bench::floorPlan(number);
    const FloorPlan& plan = allPlans()[static_cast<std::size_t>(number - 1)];
    EXPECT_EQ(again.map.cells(), plan.map.cells()) << number;
    EXPECT_TRUE(again.start == plan.start) << number;
  }
}

TEST(FloorPlans, AreOfFourKindsEquallyOftenInBothHalves) {
  std::map<std::pair<BuildingKind, int>, int> count;
  for (const FloorPlan& plan : allPlans()) ++count[{plan.kind, plan.number % 2}];
  EXPECT_EQ(count.size(), 8U);
  for (const auto& entry : count) EXPECT_EQ(entry.second, bench::kFloorPlans / 8);
  EXPECT_THROW(bench::floorPlan(0), std::invalid_argument);
  EXPECT_THROW(bench::floorPlan(bench::kFloorPlans + 1), std::invalid_argument);
}

TEST(FloorPlans, AreClosedToTheOutside) {
  for (const FloorPlan& plan : allPlans()) {
    for (std::size_t i = 0; i < plan.map.size(); ++i) {
      if (plan.map[i] != kFree) continue;
      // Beside floor there is floor or a wall, never the edge of the picture and never something unknown.
      for (const Cell step : grids::kNeighbourSteps) {
        const Cell cell = plan.map.geometry().cell(i);
        ASSERT_NE(plan.map.get({cell.x + step.x, cell.y + step.y}, kUnknown), kUnknown) << plan.number;
      }
    }
  }
}

TEST(FloorPlans, LeaveRoomAroundTheStart) {
  for (const FloorPlan& plan : allPlans()) {
    EXPECT_GE(grids::DistanceField(sim::notFree(plan.map), 1.0).at(plan.start.position()), 0.3) << plan.number;
    for (const double value : {plan.start.x, plan.start.y}) {
      const double cells = value / plan.map.resolution();
      EXPECT_NEAR(cells, std::round(cells), 1e-6) << plan.number << ": the start is not at a cell's corner";
    }
  }
}

TEST(FloorPlans, CanBeDrivenNearlyEverywhere) {
  for (const FloorPlan& plan : allPlans()) {
    const Grid<std::uint8_t> floor = reachableFloor(plan);
    const std::vector<std::int8_t>& cells = plan.map.cells();
    const double reachable = squareMetres(std::count(floor.cells().begin(), floor.cells().end(), 1));
    EXPECT_GE(reachable, 75.0) << plan.number;
    EXPECT_LE(reachable, 2050.0) << plan.number;
    EXPECT_GE(reachable, 0.93 * squareMetres(std::count(cells.begin(), cells.end(), kFree))) << plan.number;
  }
}

TEST(FloorPlans, HaveNoRoomThatCannotBeEntered) {
  for (const FloorPlan& plan : allPlans()) {
    const Grid<std::uint8_t> floor = reachableFloor(plan);
    for (const CellRect& room : plan.rooms) {
      int open = 0;
      int reached = 0;
      for (int y = room.y; y < room.y + room.height; ++y) {
        for (int x = room.x; x < room.x + room.width; ++x) {
          open += plan.map[Cell{x, y}] == kFree ? 1 : 0;
          reached += floor[Cell{x, y}];
        }
      }
      EXPECT_GE(4 * reached, 3 * open) << plan.number << ": room at " << room.x << ", " << room.y;
      EXPECT_GT(reached, 0) << plan.number;
    }
  }
}

/// The blocks around all things that are not floor and do not touch each other.
std::vector<CellRect> islands(const OccupancyGrid& map) {
  Grid<std::uint8_t> known(map.geometry());
  std::vector<CellRect> found;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i] == kFree || known[i] != 0) continue;
    CellRect block;
    std::vector<Cell> open{map.geometry().cell(i)};
    known[i] = 1;
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      block.include(cell);
      for (const Cell step : grids::kNeighbourSteps) {
        const Cell next{cell.x + step.x, cell.y + step.y};
        if (map.get(next, kFree) == kFree || known[next] != 0) continue;
        known[next] = 1;
        open.push_back(next);
      }
    }
    found.push_back(block);
  }
  return found;
}

TEST(FloorPlans, LetOneWalkAroundABlockOfRoomsInEveryOffice) {
  for (const FloorPlan& plan : allPlans()) {
    if (plan.kind != BuildingKind::kOffice) continue;
    const std::vector<CellRect> blocks = islands(plan.map);
    // The outer wall is an island as well, the largest one. No furniture is as long as 6 m.
    const auto isBlock = [&](const CellRect& block) {
      return std::max(block.width, block.height) >= 120 && block.width < plan.map.width();
    };
    EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(), isBlock)) << plan.number;
  }
}

}  // namespace
}  // namespace frontier_pilot
