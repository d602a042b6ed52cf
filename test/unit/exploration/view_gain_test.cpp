#include "exploration/view_gain.h"

#include <gtest/gtest.h>

#include "exploration/goal_score.h"
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
  exploration::ViewParameters view;
  view.sensor_range = 3.0;
  view.unknown_depth = 10.0;
  const exploration::ViewGain gain = exploration::viewGain(unknownMap(200), Pose2(5.0, 5.0, 0.0), view);
  EXPECT_NEAR(gain.area, kPi * 9.0, 0.05) << "[EXP-4] nothing counts twice";
  EXPECT_NEAR(gain.density, 1.0, 1e-3);
  view.unknown_depth = 1.0;
  EXPECT_NEAR(exploration::viewGain(unknownMap(200), Pose2(5.0, 5.0, 0.0), view).area, kPi, 0.4);
}

// [EXP-4]
TEST(ViewGain, AScannerSeesOnlyWhatIsInItsFieldOfView_EXP_4) {
  exploration::ViewParameters view;
  view.sensor_range = 3.0;
  view.unknown_depth = 10.0;
  view.field_of_view = 0.5 * kPi;
  const OccupancyGrid unknown = unknownMap(200);
  EXPECT_NEAR(exploration::viewGain(unknown, {5.0, 5.0, 0.7}, view).area, 0.25 * kPi * 9.0, 0.3);
  const Pose2 at_the_edge(9.95, 5.0, 0.0);  // of the map: there is nothing to explore beyond
  EXPECT_LT(exploration::viewGain(unknown, at_the_edge, view).area, 0.1);
  view.direction = kPi;  // it looks backwards
  EXPECT_NEAR(exploration::viewGain(unknown, at_the_edge, view).area, 0.25 * kPi * 9.0, 0.3);
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
  EXPECT_EQ(exploration::viewGain(world.map, {world.point('a'), 0.0}, exploration::ViewParameters{}).area, 0.0);
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
  const exploration::ViewGain gain =
      exploration::viewGain(world.map, {world.point('a'), 0.0}, exploration::ViewParameters{});
  EXPECT_GT(gain.area, 0.05);
  EXPECT_LT(gain.area, 0.3);
  EXPECT_LT(gain.density, 0.9);
}

// [EXP-4]
TEST(UnknownShare, IsThePlainShareOfCellsAround_EXP_4) {
  const auto world = test::drawWorld(std::string(20, '.') + std::string(20, '?'));
  EXPECT_NEAR(exploration::unknownShare(world.map, world.map.geometry().centre({19, 0}), 0.5).density, 10.0 / 21.0,
              1e-9);
}

// [EXP-3]
TEST(ObstacleDensity, IsTheOccupiedShareOfTheKnownCells_EXP_3) {
  const auto world = test::drawWorld("###..??");
  EXPECT_NEAR(exploration::obstacleDensity(world.map, {3, 0}, 6), 3.0 / 5.0, 1e-9);
  EXPECT_EQ(exploration::obstacleDensity(unknownMap(9), {4, 4}, 6), 0.0);
}

TEST(InSight, NeedsFreeCellsAllTheWay) {
  const auto world = test::drawWorld("a..b#.c?.d");
  EXPECT_TRUE(exploration::inSight(world.map, world.cell('a'), world.cell('b')));
  EXPECT_FALSE(exploration::inSight(world.map, world.cell('a'), world.cell('c')));
  EXPECT_FALSE(exploration::inSight(world.map, world.cell('c'), world.cell('d')));
}

exploration::GoalCandidate candidate(double area, double distance) {
  exploration::GoalCandidate c;
  c.info.area = area;
  c.travel_distance = c.euclidean_distance = distance;
  return c;
}

// [EXP-4]
TEST(GoalScore, RisesWithInformationAndFallsWithTheRest_EXP_4) {
  const exploration::ScoreParameters p;
  const double base = exploration::goalScore(candidate(5.0, 5.0), p);
  EXPECT_GT(exploration::goalScore(candidate(6.0, 5.0), p), base);
  EXPECT_LT(exploration::goalScore(candidate(5.0, 6.0), p), base);
  exploration::GoalCandidate visited = candidate(5.0, 5.0);
  visited.visits = 1;
  EXPECT_NEAR(exploration::goalScore(visited, p), base - 0.8 * 0.5, 1e-9);
  exploration::GoalCandidate cluttered = candidate(5.0, 5.0);
  cluttered.obstacle_density = 1.0;
  EXPECT_NEAR(exploration::goalScore(cluttered, p), base - 1.2, 1e-9);
}

// [EXP-4]
TEST(GoalScore, ThePlainDefinitionsAreSelectable_EXP_4) {
  exploration::ScoreParameters p;
  p.info_by_ray_casting = p.distance_by_travel = false;
  exploration::GoalCandidate c = candidate(5.0, 50.0);
  c.info.density = 0.7;
  c.euclidean_distance = p.distance_scale;
  EXPECT_NEAR(exploration::goalScore(c, p), 0.7 - 1.0, 1e-9);
}

TEST(GoalChoice, KeepsTheCurrentGoalUnlessAnotherIsBetterByTheMargin) {
  exploration::ScoreParameters p;
  p.switch_margin = 0.5;
  std::vector<exploration::GoalCandidate> both(2);
  both[0].score = 1.0;
  both[1].score = 1.4;
  both[1].goal = Vec2(10.0, 0.0);
  EXPECT_EQ(exploration::chooseBestScore(both, std::nullopt, p), 1U);
  EXPECT_EQ(exploration::chooseBestScore(both, Vec2(0.1, 0.0), p), 0U);
  both[1].score = 1.6;
  EXPECT_EQ(exploration::chooseBestScore(both, Vec2(0.1, 0.0), p), 1U);
  EXPECT_FALSE(exploration::chooseBestScore({}, std::nullopt, p).has_value());
}

}  // namespace
}  // namespace frontier_pilot
