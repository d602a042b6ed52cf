#include "exploration/history/goal_history.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "frontier_pilot/grids/growing_grid.h"

namespace frontier_pilot {
namespace {

/// A free floor of 10 m by 10 m, and goals that end on it.
class GoalHistoryTest : public ::testing::Test {
 protected:
  GoalHistoryTest() {
    GridGeometry geometry;
    geometry.width = geometry.height = 200;
    geometry.resolution = 0.05;
    floor = OccupancyGrid(geometry, kFree);
    map.update(floor, geometry.rect());
  }
  /// Something stands where there was none, in a square around `place`: 25 cells.
  void changeAround(const Vec2& place, int margin = 2) { map.update(floor, drawAround(place, margin)); }
  CellRect drawAround(const Vec2& place, int margin) {
    const Cell cell = floor.geometry().cellAt(place);
    const CellRect block = CellRect{cell.x, cell.y, 1, 1}.grown(margin);
    for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(floor.row(y) + block.x, block.width, kOccupied);
    return block;
  }
  /// The map grows by so many cells that nobody has seen, on the left and below.
  void grow(int cells) {
    GridGeometry geometry = floor.geometry();
    geometry.origin -= Vec2(cells, cells) * geometry.resolution;
    geometry.width += cells;
    geometry.height += cells;
    floor = grids::resized(floor, geometry, Cell{cells, cells}, kUnknown);
  }

  const Vec2 goal{5.0, 5.0};
  OccupancyGrid floor;
  exploration::ObservedMap map;
  exploration::GoalHistory history{exploration::BlacklistParameters{}, 1};
};

// [EXP-5]
TEST_F(GoalHistoryTest, APlaceIsBlacklistedWhenGoalsThereHaveFailedOnceMoreThanTheyMayBeRetried_EXP_5) {
  EXPECT_FALSE(history.failed(goal, "no path", map));
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
  EXPECT_FALSE(history.failed(goal + Vec2(1.0, 0.0), "no path", map)) << "that is another place";
  EXPECT_TRUE(history.failed(goal + Vec2(0.3, 0.0), "blocked", map));
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kBlacklisted);
  ASSERT_EQ(history.blacklist().size(), 1U);
  EXPECT_EQ(history.blacklist()[0].reason, "blocked");
}

// [EXP-5]
TEST_F(GoalHistoryTest, AGoalThatTimedOutIsBlacklistedAtOnce_EXP_5) {
  history.timedOut(goal, map);
  EXPECT_EQ(history.judge(goal + Vec2(0.55, 0.0)), exploration::Rejection::kBlacklisted);
  EXPECT_EQ(history.judge(goal + Vec2(0.65, 0.0)), exploration::Rejection::kNone);
}

// [EXP-5]
TEST_F(GoalHistoryTest, AnEntryIsLiftedWhenTheMapAroundItChangesAndTheNextOneIsHarderToLift_EXP_5) {
  history.timedOut(goal, map);
  history.expire(map);
  EXPECT_EQ(history.blacklist().size(), 1U);
  changeAround(goal);
  history.expire(map);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
  history.timedOut(goal, map);
  changeAround(goal + Vec2(0.4, 0.0));
  history.expire(map);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kBlacklisted) << "25 cells are fewer than 40";
  changeAround(goal - Vec2(0.4, 0.0));
  history.expire(map);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
}

// [EXP-5]
TEST_F(GoalHistoryTest, WhatHasChangedAroundAnEntryCountsAlsoBeyondAChangeOfTheMapsSize_EXP_5) {
  for (const int cells : {1, 7, 64}) {
    history.reset();
    history.timedOut(goal, map);
    changeAround(goal + Vec2(0.3, 0.0), 1);
    grow(cells);
    changeAround(goal - Vec2(0.3, 0.0), 1);
    history.expire(map);
    EXPECT_EQ(history.blacklist().size(), 1U) << "18 cells are fewer than 20; the map grew by " << cells;
    changeAround(goal, 1);
    history.expire(map);
    EXPECT_TRUE(history.blacklist().empty()) << "the map grew by " << cells;
    std::fill(floor.cells().begin(), floor.cells().end(), kFree);
    map.update(floor, floor.geometry().rect());
  }
}

// [EXP-5]
TEST_F(GoalHistoryTest, WhatChangesTogetherWithTheSizeOfTheMapCountsToo_EXP_5) {
  history.timedOut(goal, map);
  grow(5);
  map.update(floor, floor.geometry().rect());
  history.expire(map);
  EXPECT_EQ(history.blacklist().size(), 1U) << "nothing is different there";
  grow(5);
  changeAround(goal);
  history.expire(map);
  EXPECT_TRUE(history.blacklist().empty());
}

// [EXP-5]
TEST_F(GoalHistoryTest, WhatIsBlacklistedIsRetriedOnceAndFailuresCountAnew_EXP_5) {
  history.timedOut(goal, map);
  EXPECT_TRUE(history.retryBlacklisted());
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
  EXPECT_FALSE(history.failed(goal, "no path", map));
  EXPECT_TRUE(history.failed(goal, "no path", map));
  EXPECT_FALSE(history.retryBlacklisted());
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kBlacklisted);
  history.allowRetry();
  EXPECT_TRUE(history.retryBlacklisted());
}

// [EXP-7]
TEST_F(GoalHistoryTest, WhatWasReachedInVainIsFruitlessAlsoAfterARetryOfTheBlacklist_EXP_7) {
  history.stayedUnknown(goal, map);
  EXPECT_EQ(history.judge(goal + Vec2(0.25, 0.0)), exploration::Rejection::kFruitless);
  EXPECT_EQ(history.judge(goal + Vec2(0.35, 0.0)), exploration::Rejection::kNone) << "half of the blacklist's radius";
  history.retryBlacklisted();
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kFruitless);
}

// [EXP-6]
TEST_F(GoalHistoryTest, AGoalWhoseInformationComesAndGoesForTheThirdTimeIsFruitless_EXP_6) {
  history.vanished(goal, map);
  history.vanished(goal + Vec2(0.1, 0.0), map);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
  history.vanished(goal, map);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kFruitless);
}

// [EXP-4]
TEST_F(GoalHistoryTest, ReachedGoalsCountAsVisitsOfWhatIsNear_EXP_4) {
  history.reached(goal);
  history.reached(goal + Vec2(0.5, 0.0));
  EXPECT_EQ(history.visits(goal, 0.6), 2);
  EXPECT_EQ(history.visits(goal - Vec2(0.5, 0.0), 0.6), 1);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
}

TEST_F(GoalHistoryTest, AResetForgetsEverything) {
  history.reached(goal);
  history.timedOut(goal, map);
  history.stayedUnknown(goal + Vec2(2.0, 0.0), map);
  history.retryBlacklisted();
  history.reset();
  EXPECT_EQ(history.visits(goal, 0.6), 0);
  EXPECT_EQ(history.judge(goal), exploration::Rejection::kNone);
  EXPECT_EQ(history.judge(goal + Vec2(2.0, 0.0)), exploration::Rejection::kNone);
  history.timedOut(goal, map);
  changeAround(goal);
  history.expire(map);
  EXPECT_TRUE(history.blacklist().empty()) << "it is no harder to lift than for the first time";
  EXPECT_TRUE(history.retryBlacklisted());
}

}  // namespace
}  // namespace frontier_pilot
