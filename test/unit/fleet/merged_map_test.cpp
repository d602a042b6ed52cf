#include "frontier_pilot/fleet/merged_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/grids/cell_search.h"
#include "sized.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using fleet::FirstSource;
using fleet::MergedMap;
using fleet::SourceResult;
using test::drawWorld;
using test::sized;
using test::toAscii;

constexpr double kTurn = 37.0 * kPi / 180.0;

std::int8_t valueAt(const OccupancyGrid& map, const Vec2& point) {
  return map.get(map.geometry().cellAt(point), kUnknown);
}

/// The map of the same sources, assembled anew.
OccupancyGrid fromScratch(FirstSource first, const std::vector<OccupancyGrid>& grids, const std::vector<Pose2>& poses) {
  MergedMap merged(first);
  for (std::size_t i = 0; i < grids.size(); ++i) merged.setSource(i, grids[i], grids[i].geometry().rect(), poses[i]);
  return merged.map();
}

TEST(MergedMap, OfNothingIsEmpty) {
  MergedMap merged;
  EXPECT_TRUE(merged.map().empty());
  EXPECT_TRUE(merged.takeChanged().empty());
}

TEST(MergedMap, PassesTheMapOfItsOwnFrameOnAsItIs) {
  const OccupancyGrid own = drawWorld("#.#?\n.?..\n", 0.05, Vec2(-1.23, 4.567)).map;
  for (const FirstSource first : {FirstSource::kPrevails, FirstSource::kIsEqual}) {
    MergedMap merged(first);
    EXPECT_EQ(merged.setSource(0, own, own.geometry().rect(), {}), SourceResult::kTaken);
    EXPECT_EQ(merged.map().geometry(), own.geometry());
    EXPECT_EQ(merged.map().cells(), own.cells());
    EXPECT_EQ(merged.takeChanged(), own.geometry().rect());
    EXPECT_TRUE(merged.takeChanged().empty());
  }
}

TEST(MergedMap, PassesItsOwnMapOnAsItIsBesideAnotherThatIsRotated) {
  const OccupancyGrid own = drawWorld("#.#\n.?.\n", 0.05, Vec2(-1.23, 4.567)).map;
  const OccupancyGrid other(sized(40, 40), kOccupied);
  MergedMap merged(FirstSource::kPrevails);
  merged.setSource(1, other, other.geometry().rect(), {-2.0, 3.5, kTurn});
  merged.setSource(0, own, own.geometry().rect(), {});
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::int8_t merged_value = valueAt(merged.map(), own.geometry().centre(own.geometry().cell(i)));
    EXPECT_EQ(merged_value, isUnknown(own[i]) ? kOccupied : own[i]) << i;
  }
}

TEST(MergedMap, ARotatedSolidAreaHasNoHoles) {
  const OccupancyGrid solid(sized(60, 60), kOccupied);
  MergedMap merged;
  const Pose2 T_target_source(3.0, -2.0, kTurn);
  merged.setSource(1, solid, solid.geometry().rect(), T_target_source);
  const OccupancyGrid& map = merged.map();
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Vec2 p = T_target_source.inverse() * map.geometry().centre(map.geometry().cell(i));
    const bool inside = p.minCoeff() > 0.001 && p.maxCoeff() < 2.999;
    const bool outside = p.minCoeff() < -0.05 || p.maxCoeff() > 3.05;
    EXPECT_TRUE(isOccupied(map[i]) || !inside) << "a hole at " << p.transpose();
    EXPECT_TRUE(isUnknown(map[i]) || !outside) << "something at " << p.transpose();
  }
}

/// Whether a search over all eight neighbours gets from free cells to unknown ones.
bool freeTouchesUnknown(const OccupancyGrid& map) {
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!isFree(map[i])) continue;
    for (const Cell step : grids::kNeighbourSteps) {
      const Cell cell = map.geometry().cell(i);
      if (isUnknown(map.get({cell.x + step.x, cell.y + step.y}, kUnknown))) return true;
    }
  }
  return false;
}

TEST(MergedMap, ARotatedRoomWithWallsOfOneCellDoesNotLeak) {
  OccupancyGrid room(sized(40, 30), kOccupied);
  for (int y = 3; y < 27; ++y) std::fill_n(room.row(y) + 3, 34, kFree);
  for (const int y : {0, 1, 28, 29}) std::fill_n(room.row(y), 40, kUnknown);
  for (int y = 2; y < 28; ++y) {
    for (const int x : {0, 1, 38, 39}) room[Cell{x, y}] = kUnknown;
  }
  ASSERT_FALSE(freeTouchesUnknown(room));
  for (int degrees = -180; degrees < 180; ++degrees) {
    MergedMap merged;
    merged.setSource(1, room, room.geometry().rect(), {0.513, -0.271, degrees * kPi / 180.0});
    EXPECT_FALSE(freeTouchesUnknown(merged.map())) << "turned by " << degrees << " degrees\n" << toAscii(merged.map());
  }
}

TEST(MergedMap, GrowsWithItsSourcesAndKeepsWhatItHas) {
  const OccupancyGrid small(sized(10, 10), kFree);
  const OccupancyGrid far_away(sized(10, 10), kOccupied);
  MergedMap merged;
  merged.setSource(0, small, small.geometry().rect(), {});
  merged.takeChanged();
  merged.setSource(1, far_away, far_away.geometry().rect(), {-20.0, 7.0, 1.0});
  EXPECT_EQ(merged.takeChanged(), merged.map().geometry().rect());
  EXPECT_EQ(valueAt(merged.map(), {0.25, 0.25}), kFree);
  EXPECT_EQ(valueAt(merged.map(), Pose2(-20.0, 7.0, 1.0) * Vec2(0.25, 0.25)), kOccupied);
  merged.removeSource(1);
  EXPECT_EQ(merged.map().cells(), small.cells());
  EXPECT_EQ(merged.map().geometry(), small.geometry());
}

TEST(MergedMap, WhatARobotKnowsPrevailsOverWhatTheOtherDoesNotKnow) {
  const OccupancyGrid left = drawWorld("#..???\n#..???").map;
  const OccupancyGrid right = drawWorld("???..#\n????.#").map;
  MergedMap merged;
  merged.setSource(0, left, left.geometry().rect(), {});
  merged.setSource(1, right, right.geometry().rect(), {});
  EXPECT_EQ(merged.map().cells(), drawWorld("#....#\n#..?.#").map.cells()) << toAscii(merged.map());
}

TEST(MergedMap, AWallSeenFromBothSidesAFewCentimetresApartStays) {
  const OccupancyGrid from_left = drawWorld("......#???????\n......#???????\n......#???????").map;
  const OccupancyGrid from_right = drawWorld("????#.........\n????#.........\n????#.........").map;
  MergedMap merged;
  merged.setSource(0, from_left, from_left.geometry().rect(), {});
  merged.setSource(1, from_right, from_right.geometry().rect(), {});
  EXPECT_EQ(merged.map().cells(), drawWorld("....#.#.......\n....#.#.......\n....#.#.......").map.cells())
      << toAscii(merged.map());
}

const char* const kRoomWithGhost =
    "###########\n"
    "#.........#\n"
    "#.........#\n"
    "#.....G...#\n"
    "#.........#\n"
    "#.........#\n"
    "###########\n";

struct SeenRobot {
  OccupancyGrid empty, ghost;  ///< as the robot that was seen knows the room, and as the other does
};

SeenRobot seenRobot() {
  const test::AsciiWorld world = drawWorld(kRoomWithGhost);
  SeenRobot seen{world.map, world.map};
  seen.ghost[world.cell('G')] = kOccupied;
  return seen;
}

// [MUL-3]
TEST(MergedMap, ARobotThatTheOtherSawIsNoObstacleInTheCommonMapInEitherOrder) {
  const auto [empty, ghost] = seenRobot();
  for (const bool ghost_first : {true, false}) {
    MergedMap merged;
    merged.setSource(0, ghost_first ? ghost : empty, empty.geometry().rect(), {});
    merged.setSource(1, ghost_first ? empty : ghost, empty.geometry().rect(), {});
    EXPECT_EQ(merged.map().cells(), empty.cells()) << toAscii(merged.map());
  }
}

TEST(MergedMap, InItsOwnViewARobotBelievesItself) {
  const auto [empty, ghost] = seenRobot();
  MergedMap merged(FirstSource::kPrevails);
  merged.setSource(0, ghost, ghost.geometry().rect(), {});
  merged.setSource(1, empty, empty.geometry().rect(), {});
  EXPECT_EQ(merged.map().cells(), ghost.cells());
}

TEST(MergedMap, ChangesAreBoundedByTheCellsThatDiffer) {
  OccupancyGrid own(sized(100, 100), kUnknown);
  OccupancyGrid other(sized(100, 100), kFree);
  own[Cell{20, 30}] = kFree;
  MergedMap merged(FirstSource::kPrevails);
  merged.setSource(0, own, own.geometry().rect(), {});
  merged.setSource(1, other, other.geometry().rect(), {});
  merged.takeChanged();
  other[Cell{20, 30}] = kOccupied;  // the robot knows that cell itself
  other[Cell{23, 31}] = kOccupied;
  merged.setSource(1, other, {10, 10, 50, 50}, {});
  EXPECT_EQ(merged.takeChanged(), (CellRect{23, 31, 1, 1}));
}

TEST(MergedMap, ARevisionOfASourceIsFollowedAndANewPlaceLeavesNothingAtTheOldOne) {
  OccupancyGrid other(sized(50, 50), kFree);
  for (int x = 10; x < 40; ++x) other[Cell{x, 25}] = kOccupied;
  MergedMap merged;
  merged.setSource(1, other, other.geometry().rect(), {1.0, 2.0, kTurn});
  OccupancyGrid revised(sized(50, 50), kFree);
  for (int x = 10; x < 40; ++x) revised[Cell{x, 27}] = kOccupied;
  other = revised;
  merged.setSource(1, other, {0, 20, 50, 10}, {1.0, 2.0, kTurn});
  const auto anew = [&](const Pose2& pose) {
    return fromScratch(FirstSource::kIsEqual, {OccupancyGrid(), other}, {{}, pose});
  };
  EXPECT_EQ(merged.map().cells(), anew({1.0, 2.0, kTurn}).cells());
  merged.setSource(1, other, {}, {1.5, 2.0, 0.2});
  EXPECT_EQ(merged.map().cells(), anew({1.5, 2.0, 0.2}).cells());
  EXPECT_EQ(merged.map().geometry(), anew({1.5, 2.0, 0.2}).geometry());
}

TEST(MergedMap, RefusesOtherCellsAndMapsThatWouldBeTooLargeAndGoesOnWithoutThem) {
  const OccupancyGrid own(sized(10, 10), kFree);
  const OccupancyGrid coarse = drawWorld("..\n..", 0.1).map;
  MergedMap merged;
  merged.setSource(0, own, own.geometry().rect(), {});
  EXPECT_EQ(merged.setSource(1, coarse, coarse.geometry().rect(), {}), SourceResult::kOtherResolution);
  EXPECT_FALSE(merged.hasSource(1));
  EXPECT_EQ(merged.setSource(1, own, own.geometry().rect(), {0.5, 0.0, 0.0}), SourceResult::kTaken);
  EXPECT_EQ(merged.map().width(), 20);
  for (const Pose2& far_away : {Pose2(1500.0, 0.0, 0.3), Pose2(600.0, 600.0, 0.0), Pose2(0.0, 1e300, 0.0)}) {
    EXPECT_EQ(merged.setSource(1, own, own.geometry().rect(), far_away), SourceResult::kTooLarge);
    EXPECT_FALSE(merged.hasSource(1));
    EXPECT_EQ(merged.map().cells(), own.cells());
  }
}

/// A grid of noise that is correlated enough to have free areas, walls and unknown space.
OccupancyGrid noise(std::mt19937& random, int width, int height) {
  OccupancyGrid grid(sized(width, height, Vec2(0.05 * static_cast<double>(random() % 40), -0.4)), kFree);
  for (int blot = 0; blot < 60; ++blot) {
    const Cell at{static_cast<int>(random() % static_cast<unsigned>(width)),
                  static_cast<int>(random() % static_cast<unsigned>(height))};
    const std::int8_t value = std::vector<std::int8_t>{kUnknown, kOccupied, 30, 70}[random() % 4];
    const CellRect blotted =
        CellRect{at.x, at.y, static_cast<int>(random() % 9), static_cast<int>(random() % 9)}.intersection(
            grid.geometry().rect());
    for (int y = blotted.y; y < blotted.y + blotted.height; ++y)
      std::fill_n(grid.row(y) + blotted.x, blotted.width, value);
  }
  return grid;
}

// Whatever happens to the sources, and in whatever order, the map is that of its sources; and what it says has changed
// is enough for a copy to follow.
TEST(MergedMap, UpdatedStepByStepItIsTheMapAssembledFromScratch) {
  std::mt19937 random(7);
  const auto uniform = [&](double most) {
    return most * (2.0 * static_cast<double>(random() % 10001) / 10000.0 - 1.0);
  };
  for (const FirstSource first : {FirstSource::kIsEqual, FirstSource::kPrevails}) {
    std::vector<OccupancyGrid> grids = {noise(random, 60, 50), noise(random, 45, 70), noise(random, 50, 50)};
    std::vector<Pose2> poses = {{}, {0.7, -0.3, kTurn}, {-0.5, 0.6, -2.0}};
    MergedMap merged(first);
    for (const std::size_t i : {2U, 0U, 1U}) merged.setSource(i, grids[i], grids[i].geometry().rect(), poses[i]);
    OccupancyGrid copy = merged.map();
    merged.takeChanged();
    for (int step = 0; step < 200; ++step) {
      const std::size_t i = random() % 3;
      CellRect changed = grids[i].geometry().rect();
      if (random() % 10 == 0) {
        grids[i] = noise(random, 40 + static_cast<int>(random() % 40), 40 + static_cast<int>(random() % 40));
      } else if (random() % 10 == 0 && i != 0) {
        poses[i] = {uniform(1.0), uniform(1.0), uniform(kPi)};
      } else {
        const OccupancyGrid fresh = noise(random, grids[i].width(), grids[i].height());
        changed = CellRect{static_cast<int>(random() % 30), static_cast<int>(random() % 30), 10, 7};
        for (int y = changed.y; y < changed.y + changed.height; ++y)
          std::copy_n(fresh.row(y) + changed.x, changed.width, grids[i].row(y) + changed.x);
      }
      ASSERT_EQ(merged.setSource(i, grids[i], changed, poses[i]), SourceResult::kTaken);
      const OccupancyGrid whole = fromScratch(first, grids, poses);
      ASSERT_EQ(merged.map().geometry(), whole.geometry()) << "step " << step;
      ASSERT_TRUE(merged.map().cells() == whole.cells()) << "step " << step;
      const CellRect told = merged.takeChanged();
      if (copy.geometry() != whole.geometry()) {
        ASSERT_EQ(told, whole.geometry().rect());
      } else {
        ASSERT_EQ(difference(copy, whole).intersection(told), difference(copy, whole)) << "step " << step;
      }
      copy = whole;
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
