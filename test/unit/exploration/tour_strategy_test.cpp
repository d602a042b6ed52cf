#include <algorithm>
#include <stdexcept>

#include "exploration/tour/unknown_region.h"
#include "exploration/view_gain.h"
#include "strategy_fixture.h"

namespace frontier_pilot {
namespace {

using test::Strategies;
using test::touring;

/// A corridor that goes on to the right; a niche of unknown ground on the left, nearer to the robot than the right end.
constexpr const char* kNicheBehind = R"(
  ##########################################################################
  #........................................................................?
  #........................................................................?
  #.n.....................................................................w?
  #...............................r........................................?
  #........................................................................?
  #........................................................................?
  #........................................................................?
  ##??????##################################################################
  ##??????##
  ##??????##
  ##########
)";

// [EXP-9]
TEST_F(Strategies, ATourTakesTheNicheBehindFirstBecauseComingBackIsPriced_EXP_9) {
  const auto goal = choose(kNicheBehind);
  ASSERT_TRUE(goal);
  EXPECT_LT(distanceTo(*goal, 'n'), distanceTo(*goal, 'w'));
  EXPECT_NE(goal->why.find("2 stops"), std::string::npos) << goal->why;
}

// [EXP-9]
TEST_F(Strategies, ATourNumbersTheFrontiersInTheOrderInWhichTheyAreSeen_EXP_9) {
  ASSERT_TRUE(choose(kNicheBehind));
  std::vector<int> places;
  for (const exploration::Frontier& frontier : evaluator.frontiers()) {
    if (frontier.selectable()) places.push_back(frontier.place);
  }
  std::sort(places.begin(), places.end());
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.front(), 1);
  EXPECT_EQ(places.back(), 2);
}

// [EXP-9]
TEST_F(Strategies, AStopShowsEveryFrontierThatIsNumberedForIt_EXP_9) {
  const auto goal = choose(kNicheBehind);
  ASSERT_TRUE(goal);
  const Cell from = world.map.geometry().cellAt(goal->position);
  for (const exploration::Frontier& frontier : evaluator.frontiers()) {
    if (frontier.place != 1) continue;
    EXPECT_TRUE(exploration::inSight(world.map, from, frontier.anchor));
  }
}

// [EXP-9]
TEST_F(Strategies, ATourIsKeptUnlessAnotherOneIsClearlyShorter_EXP_9) {
  const auto goal = choose(kNicheBehind);
  ASSERT_TRUE(goal);
  situation.current = Pose2(goal->position, goal->yaw);
  const auto again = chooseAgain();
  ASSERT_TRUE(again);
  EXPECT_LT((again->position - goal->position).norm(), 0.3);
}

/// A corridor that goes on to the right, with a niche of unknown ground beside the way there.
constexpr const char* kNicheOnTheWay = R"(
  ##########################################################################
  #........................................................................?
  #........................................................................?
  #........................................................................?
  #...r....................................................................?
  #........................................................................?
  #........................................................................?
  #........................................................................?
  ##############################??????######################################
                              ##??????##
                              ##??????##
                              ##########
)";

// [EXP-4] [EXP-9]
TEST_F(Strategies, WhatIsSeenOnTheWayToAnotherFrontierCostsNextToNothing_EXP_9) {
  const auto secondsToTheRightEnd = [this](const std::string& drawing) {
    EXPECT_TRUE(choose(drawing));
    std::optional<double> seconds;
    for (const exploration::Frontier& frontier : evaluator.frontiers()) {
      if (frontier.selectable() && frontier.centroid.x() > 7.0) seconds = frontier.cost;
    }
    EXPECT_TRUE(seconds);
    return seconds.value_or(0.0);
  };
  std::string without = kNicheOnTheWay;
  const std::size_t niche = without.find("??????#");
  without.replace(niche, 6, "######");
  const double direct = secondsToTheRightEnd(without);
  EXPECT_GT(direct, 5.0);
  EXPECT_LT(secondsToTheRightEnd(kNicheOnTheWay), direct + 1.0);
}

// [EXP-4] [EXP-9]
TEST_F(Strategies, ARobotThatDoesNotSeeAllAroundFacesWhatItGoesToSee_EXP_9) {
  exploration::ExplorerParameters parameters = touring();
  parameters.frontier.view.field_of_view = 0.4 * kPi;
  evaluator.setParameters(parameters.frontier);
  const auto goal = choose(kNicheBehind, parameters);
  ASSERT_TRUE(goal);
  ASSERT_LT(distanceTo(*goal, 'n'), distanceTo(*goal, 'w'));
  const exploration::ViewGain seen = evaluator.infoAt({goal->position, goal->yaw});
  const exploration::ViewGain behind = evaluator.infoAt({goal->position, goal->yaw + kPi});
  EXPECT_GT(seen.area, 0.02);
  EXPECT_LT(behind.area, 0.2 * seen.area);
  EXPECT_DOUBLE_EQ(goal->area, seen.area);
}

// [EXP-5]
TEST_F(Strategies, NoStopOfATourLiesNearABlacklistedGoal_EXP_5) {
  for (int k = 0; k < 4; ++k) {
    const auto goal = k == 0 ? choose(kNicheBehind) : chooseAgain();
    if (!goal) break;
    for (const exploration::BlacklistedPlace& entry : history.blacklist()) {
      EXPECT_GT((goal->position - entry.position).norm(), 0.6) << k;
    }
    history.timedOut(goal->position, evaluator.map());
  }
  EXPECT_GE(history.blacklist().size(), 2U);
}

// [EXP-3]
TEST_F(Strategies, AGoalOfATourIsNotClutteredEither_EXP_3) {
  const auto goal = choose(R"(
    ############################################################
    #...................................#..#..#..#..#..#..#..#.??
    #..........................................................??
    #..r................................#..#..#..#..#..#..#..#.??
    #..........................................................??
    #...................................#..#..#..#..#..#..#..#.??
    #..........................................................??
    ############################################################
  )");
  if (!goal) return;
  const Cell cell = world.map.geometry().cellAt(goal->position);
  EXPECT_LE(exploration::obstacleDensity(world.map, cell, 6), 0.3);
}

/// A closed room with unknown cells behind a pillar: 0.03 m^2.
constexpr const char* kSliver = R"(
  #########################
  #.......................#
  #.......................#
  #...r...................#
  #................#######.#
  #................#???...#
  #.......................#
  #.......................#
  #########################
)";

// [EXP-9] [EXP-7]
TEST_F(Strategies, SliversAreNotWorthATripButAreNamed_EXP_9_EXP_7) {
  exploration::ExplorerParameters parameters = touring();
  parameters.tour.sliver_share = 1.0;
  EXPECT_FALSE(choose(kSliver, parameters));
  for (const exploration::Frontier& frontier : evaluator.frontiers()) EXPECT_FALSE(frontier.selectable());
}

// [EXP-9]
TEST_F(Strategies, SliversThatTogetherAreMoreThanTheAllowedShareAreExplored_EXP_9) {
  exploration::ExplorerParameters parameters = touring();
  parameters.tour.sliver_share = 0.0;
  EXPECT_TRUE(choose(kSliver, parameters));
}

// [EXP-9] The cell nearest to the middle of this frontier borders a single unknown cell, the others a whole room.
TEST_F(Strategies, AFrontierIsNoSliverBecauseASmallPocketLiesInItsMiddle_EXP_9) {
  exploration::ExplorerParameters parameters = touring();
  parameters.tour.sliver_share = 1.0;
  EXPECT_TRUE(choose(R"(
    ###########################
    #.........????????????????#
    #.........????????????????#
    #.........????????????????#
    #.........................#
    #...r............?........#
    #.........................#
    #.........????????????????#
    #.........????????????????#
    #.........????????????????#
    ###########################
  )",
                     parameters));
}

// [EXP-9]
TEST_F(Strategies, GreedyTakesTheBestScoreAndNearestTheShortestWay_EXP_9) {
  exploration::ExplorerParameters parameters = touring();
  parameters.strategy = "nearest";
  const auto nearest = choose(kNicheBehind, parameters);
  ASSERT_TRUE(nearest);
  double least = 1e9;
  for (const exploration::Frontier& frontier : evaluator.frontiers()) {
    if (frontier.selectable()) least = std::min(least, frontier.distance);
  }
  EXPECT_DOUBLE_EQ(nearest->distance, least);
  parameters.strategy = "greedy";
  const auto greedy = choose(kNicheBehind, parameters);
  ASSERT_TRUE(greedy);
  const auto best = std::max_element(
      evaluator.frontiers().begin(), evaluator.frontiers().end(),
      [](const auto& a, const auto& b) { return !a.selectable() || (b.selectable() && a.score < b.score); });
  EXPECT_EQ(greedy->position, best->goal);
  EXPECT_NE(greedy->why.find(": information +"), std::string::npos) << greedy->why;
}

TEST(StrategyNames, AnUnknownOneIsRefusedWithTheNamesThatThereAre) {
  exploration::ExplorerParameters parameters;
  parameters.strategy = "boldest";
  EXPECT_THROW(exploration::makeStrategy(parameters), std::invalid_argument);
  exploration::ExplorerParameters loaded;
  EXPECT_FALSE(loadParameters(parseYaml("strategy: boldest"), loaded).empty());
  EXPECT_TRUE(loadParameters(parseYaml("strategy: nearest"), loaded).empty());
}

constexpr double kOpen = 5.0;  ///< [m^2]

// [EXP-9]
TEST(UnknownArea, BehindAFrontierEndsAtWallsAndAtTheRadius_EXP_9) {
  const test::AsciiWorld pocket = test::drawWorld(R"(
    ##########
    #...f??###
    #...#######
    ??????????
  )",
                                                  0.1);
  const test::AsciiWorld open = test::drawWorld("f" + std::string(100, '?'), 0.1);
  exploration::UnknownRegions regions(kOpen);
  exploration::ObservedMap map;
  for (int repeated = 0; repeated < 2; ++repeated) {
    map.update(pocket.map, pocket.map.geometry().rect());
    EXPECT_NEAR(regions.areaBehind(pocket.cell('f'), map), 0.02, 1e-9);
    map.update(open.map, open.map.geometry().rect());
    EXPECT_NEAR(regions.areaBehind(open.cell('f'), map), 0.25, 1e-9);
  }
}

// [EXP-9]
TEST(UnknownArea, ThatIsLargerThanAskedForIsNotMeasuredFurther_EXP_9) {
  const test::AsciiWorld open = test::drawWorld("f" + std::string(100, '?'), 0.1);
  exploration::ObservedMap map;
  map.update(open.map, open.map.geometry().rect());
  EXPECT_NEAR(exploration::UnknownRegions(0.2).areaBehind(open.cell('f'), map), 0.2, 0.011);
}

// [EXP-9]
TEST(UnknownArea, IsMeasuredAgainWhenTheMapHasChangedThere_EXP_9) {
  test::AsciiWorld open = test::drawWorld("f" + std::string(100, '?'), 0.1);
  exploration::UnknownRegions regions(kOpen);
  exploration::ObservedMap map;
  map.update(open.map, open.map.geometry().rect());
  EXPECT_NEAR(regions.areaBehind(open.cell('f'), map), 0.25, 1e-9);
  open.map[Cell{11, 0}] = kFree;
  map.update(open.map, {11, 0, 1, 1});
  EXPECT_NEAR(regions.areaBehind(open.cell('f'), map), 0.1, 1e-9);
}

}  // namespace
}  // namespace frontier_pilot
