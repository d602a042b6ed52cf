#include "frontier_pilot/exploration/view_gain.h"

#include <gtest/gtest.h>

#include "frontier_pilot/exploration/goal_choice.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

OccupancyGrid unknownMap(int cells) {
  GridGeometry geometry;
  geometry.width = geometry.height = cells;
  return OccupancyGrid(geometry, kUnknown);
}

// [EXP-4]
TEST(ViewGain, InTheOpenItIsTheDiscOfTheExpectedDepth_EXP_4) {
  ViewParameters view;
  view.sensor_range = 3.0;
  view.unknown_depth = 10.0;
  const ViewGain gain = viewGain(unknownMap(200), Vec2(5.0, 5.0), view);
  EXPECT_NEAR(gain.area, kPi * 9.0, 0.05) << "[EXP-4] nothing counts twice";
  EXPECT_NEAR(gain.density, 1.0, 1e-3);
  view.unknown_depth = 1.0;
  EXPECT_NEAR(viewGain(unknownMap(200), Vec2(5.0, 5.0), view).area, kPi, 0.4);
}

// [EXP-4]
TEST(ViewGain, NothingIsSeenThroughWallsNorThroughTheCornersOfTheirCells_EXP_4) {
  const auto world = test::drawWorld(R"(
    ???????????
    ????#??????
    ???#.#?????
    ??#.a.#????
    ???#.#?????
    ????#??????
    ???????????
  )");
  EXPECT_EQ(viewGain(world.map, world.point('a'), ViewParameters{}).area, 0.0);
}

// [EXP-4]
TEST(ViewGain, AWindowShowsOnlyItsSector_EXP_4) {
  auto world = test::drawWorld(R"(
    ??????????????????????
    #############?????????
    #............?????????
    #....a.......?????????
    #............?????????
    #############?????????
    ??????????????????????
  )");
  const ViewGain gain = viewGain(world.map, world.point('a'), ViewParameters{});
  EXPECT_GT(gain.area, 0.05);
  EXPECT_LT(gain.area, 0.3);
  EXPECT_LT(gain.density, 0.9);
}

// [EXP-4]
TEST(UnknownShare, IsThePlainShareOfCellsAround_EXP_4) {
  const auto world = test::drawWorld(std::string(20, '.') + std::string(20, '?'));
  EXPECT_NEAR(unknownShare(world.map, world.map.geometry().centre({19, 0}), 0.5).density, 10.0 / 21.0, 1e-9);
}

// [EXP-3]
TEST(ObstacleDensity, IsTheOccupiedShareOfTheKnownCells_EXP_3) {
  const auto world = test::drawWorld("###..??");
  EXPECT_NEAR(obstacleDensity(world.map, {3, 0}, 6), 3.0 / 5.0, 1e-9);
  EXPECT_EQ(obstacleDensity(unknownMap(9), {4, 4}, 6), 0.0);
}

TEST(InSight, NeedsFreeCellsAllTheWay) {
  const auto world = test::drawWorld("a..b#.c?.d");
  EXPECT_TRUE(inSight(world.map, world.cell('a'), world.cell('b')));
  EXPECT_FALSE(inSight(world.map, world.cell('a'), world.cell('c')));
  EXPECT_FALSE(inSight(world.map, world.cell('c'), world.cell('d')));
}

GoalCandidate candidate(double area, double distance) {
  GoalCandidate c;
  c.info.area = area;
  c.travel_distance = c.euclidean_distance = distance;
  return c;
}

// [EXP-4]
TEST(GoalScore, RisesWithInformationAndFallsWithTheRest_EXP_4) {
  const ScoreParameters p;
  const double base = goalScore(candidate(5.0, 5.0), p);
  EXPECT_GT(goalScore(candidate(6.0, 5.0), p), base);
  EXPECT_LT(goalScore(candidate(5.0, 6.0), p), base);
  GoalCandidate visited = candidate(5.0, 5.0);
  visited.visits = 1;
  EXPECT_NEAR(goalScore(visited, p), base - 0.8 * 0.5, 1e-9);
  GoalCandidate cluttered = candidate(5.0, 5.0);
  cluttered.obstacle_density = 1.0;
  EXPECT_NEAR(goalScore(cluttered, p), base - 1.2, 1e-9);
}

// [EXP-4]
TEST(GoalScore, ThePlainDefinitionsAreSelectable_EXP_4) {
  ScoreParameters p;
  p.info_by_ray_casting = p.distance_by_travel = false;
  GoalCandidate c = candidate(5.0, 50.0);
  c.info.density = 0.7;
  c.euclidean_distance = p.distance_scale;
  EXPECT_NEAR(goalScore(c, p), 0.7 - 1.0, 1e-9);
}

TEST(GoalChoice, KeepsTheCurrentGoalUnlessAnotherIsBetterByTheMargin) {
  ScoreParameters p;
  p.switch_margin = 0.5;
  std::vector<GoalCandidate> both(2);
  both[0].score = 1.0;
  both[1].score = 1.4;
  both[1].goal = Vec2(10.0, 0.0);
  EXPECT_EQ(chooseBestScore(both, std::nullopt, p), 1U);
  EXPECT_EQ(chooseBestScore(both, Vec2(0.1, 0.0), p), 0U);
  both[1].score = 1.6;
  EXPECT_EQ(chooseBestScore(both, Vec2(0.1, 0.0), p), 1U);
  EXPECT_FALSE(chooseBestScore({}, std::nullopt, p).has_value());
}

}  // namespace
}  // namespace frontier_pilot
