#include "exploration/frontier_evaluator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "exploration/view_gain.h"
#include "frontier_pilot/core/robot_model.h"
#include "narrow_door.h"
#include "support/ascii_world.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

exploration::FrontierParameters smallWorld() {
  exploration::FrontierParameters p;
  p.view.sensor_range = 1.5;
  return p;
}

class FrontierJudgement : public ::testing::Test {
 protected:
  const exploration::Frontier& judge(const std::string& drawing,
                                     exploration::FrontierParameters parameters = smallWorld()) {
    world = test::drawWorld(drawing);
    evaluator.emplace(parameters, robot.drivenOutline());
    evaluator->setPlan(plan);
    evaluator->setMap(world.map, world.map.geometry().rect());
    const exploration::FrontierEvaluator::Context context{world.point('r'), world.point('r'), &history, 0.0};
    if (!evaluator->evaluate(context)) evaluator->evaluateTightWays(context);
    const auto& all = evaluator->frontiers();
    largest = *std::max_element(
        all.begin(), all.end(),
        [](const exploration::Frontier& a, const exploration::Frontier& b) { return a.cell_count < b.cell_count; });
    return largest;
  }

  test::AsciiWorld world;
  exploration::GoalHistory history{exploration::BlacklistParameters{}, 1};
  exploration::PlanFn plan;
  RobotModel robot;
  std::optional<exploration::FrontierEvaluator> evaluator;
  exploration::Frontier largest;
};

constexpr const char* kRoom = R"(
  ##############################????
  #.............................????
  #.............................????
  #.............................????
  #.............................????
  #....r........................????
  #.............................????
  #.............................????
  #.............................????
  #.............................????
  ##############################????
)";

// [EXP-2]
TEST_F(FrontierJudgement, TheGoalIsAReachableFreeCellThatSeesTheFrontier_EXP_2) {
  const exploration::Frontier& f = judge(kRoom);
  ASSERT_EQ(f.rejection, exploration::Rejection::kNone);
  const Cell goal = world.map.geometry().cellAt(f.goal);
  EXPECT_TRUE(isFree(world.map[goal]));
  EXPECT_TRUE(exploration::inSight(world.map, goal, f.anchor)) << "[EXP-2]";
  EXPECT_NEAR(f.heading, 0.0, 0.5);
}

// [EXP-2]
TEST_F(FrontierJudgement, ACentroidInAWallStillGivesAGoalOnFreeGround_EXP_2) {
  const exploration::Frontier& f = judge(R"(
    ????????????????????????????????
    ?..............................?
    ?..............................?
    ?..............................?
    ?..............................?
    ?..........##########..........?
    ?..........##########..........?
    ?..........##########..........?
    ?..........##########..........?
    ?..........##########..........?
    ?..........##########..........?
    ?..............................?
    ?..............................?
    ?..............................?
    ?.r............................?
    ????????????????????????????????
  )");
  EXPECT_TRUE(isOccupied(world.map.get(world.map.geometry().cellAt(f.centroid), kUnknown)));
  ASSERT_NE(f.rejection, exploration::Rejection::kUnreachable);
  EXPECT_TRUE(isFree(world.map[world.map.geometry().cellAt(f.goal)])) << "[EXP-2]";
}

// [EXP-3]
TEST_F(FrontierJudgement, BehindAWallItIsUnreachable_EXP_3) {
  EXPECT_EQ(judge(R"(
    ##############################????
    #.............#...............????
    #.............#...............????
    #.............#...............????
    #....r........#...............????
    #.............#...............????
    #.............#...............????
    ##############################????
  )")
                .rejection,
            exploration::Rejection::kUnreachable);
}

// [EXP-3]
TEST_F(FrontierJudgement, WhatIsNearerThanTheLeastDistanceFromEverywhereIsTooNear_EXP_3) {
  exploration::FrontierParameters parameters = smallWorld();
  parameters.goal_search_radius = 0.3;
  EXPECT_EQ(judge(R"(
    ############????
    #...........????
    #...........????
    #......r....????
    #...........????
    #...........????
    ############????
  )",
                  parameters)
                .rejection,
            exploration::Rejection::kTooNear);
}

// [EXP-3]
TEST_F(FrontierJudgement, WhatIsNearIsLookedAtFromElsewhere_EXP_3) {
  const exploration::Frontier& f = judge(R"(
    ##############################????
    #.............................????
    #.............................????
    #.............................????
    #.........................r...????
    #.............................????
    #.............................????
    #.............................????
    ##############################????
  )");
  EXPECT_EQ(f.rejection, exploration::Rejection::kNone);
  EXPECT_GE(f.distance, 0.45) << "[EXP-3]";
}

// [EXP-3]
TEST_F(FrontierJudgement, InClutterItIsRejectedForTheObstacleDensity_EXP_3) {
  exploration::FrontierParameters parameters = smallWorld();
  parameters.max_obstacle_density = 0.05;
  parameters.goal_search_radius = 0.15;
  EXPECT_EQ(judge(R"(
    ##############################
    #............................?
    #............................?
    #....r.......................?
    #............................?
    #............................?
    ##############################
  )",
                  parameters)
                .rejection,
            exploration::Rejection::kCluttered);
}

// [EXP-3]
TEST_F(FrontierJudgement, NearABlacklistedGoalItIsBlacklisted_EXP_3) {
  const Vec2 goal = judge(kRoom).goal;
  exploration::ObservedMap observed;
  observed.update(world.map, world.map.geometry().rect());
  history.timedOut(goal + Vec2(0.55, 0.0), observed);
  EXPECT_EQ(judge(kRoom).rejection, exploration::Rejection::kBlacklisted) << "[EXP-3] within 0.60 m";
  history.reset();
  history.timedOut(goal + Vec2(0.65, 0.0), observed);
  EXPECT_EQ(judge(kRoom).rejection, exploration::Rejection::kNone);
}

TEST_F(FrontierJudgement, AFewCellsAreTooSmall) {
  exploration::FrontierParameters parameters = smallWorld();
  parameters.min_frontier_cells = 20;
  EXPECT_EQ(judge(kRoom, parameters).rejection, exploration::Rejection::kTooSmall);
}

TEST_F(FrontierJudgement, AFrontierThroughTheCornersOfADiagonalWallHasNothingToSee) {
  const exploration::Frontier& f = judge(R"(
    #########################
    #.......................#
    #.......................#
    #.......................#
    #.......................#
    #.....................#??
    #....................#???
    #...................#????
    #....r.............#?????
    #.................#??????
    #................#???????
    #...............#????????
    #################????????
  )");
  EXPECT_EQ(f.rejection, exploration::Rejection::kNothingToSee);
}

TEST_F(FrontierJudgement, APlannerOfTheCallersIsAskedForTheDistance) {
  plan = [](const Vec2&, const Vec2&) { return std::optional<double>(77.0); };
  EXPECT_EQ(judge(kRoom).distance, 77.0);
  plan = [](const Vec2&, const Vec2&) { return std::optional<double>(); };
  EXPECT_EQ(judge(kRoom).rejection, exploration::Rejection::kUnreachable);
}

TEST_F(FrontierJudgement, AWayThroughAGapThatIsNotYetSeenCountsOnlyWhenNothingElseIsLeft) {
  // Towards the right the sides of the gap are unknown; another frontier lies to the left, on open ground.
  const char* both = R"(
    ?#############################???????????????
    ?.............................???..........??
    ?.............................???..........??
    ?.............................???..........??
    ?.............................???..........??
    ?..........................................??
    ?..................r.......................??
    ?..........................................??
    ?.............................???..........??
    ?.............................???..........??
    ?.............................???..........??
    ?.............................???..........??
    ?#############################???????????????
  )";
  judge(both);
  bool right = false;
  for (const exploration::Frontier& f : evaluator->frontiers()) right = right || (f.selectable() && f.goal.x() > 1.6);
  EXPECT_FALSE(right);
}

// [ROB-1]
TEST_F(FrontierJudgement, WaysAreAsWideAsTheRobotNeedsThem_ROB_1) {
  EXPECT_EQ(robot.drivenOutline().halfWidth() + exploration::FrontierParameters().clearance_margin, 0.15)
      << "what it was before a Burger's size was known";
  EXPECT_EQ(judge(test::kNarrowDoor).rejection, exploration::Rejection::kNone);
  robot = test::shippedRobot("waffle");
  EXPECT_EQ(judge(test::kNarrowDoor).rejection, exploration::Rejection::kUnreachable)
      << "a Waffle is 0.306 m wide, and the door 0.25 m";
}

TEST(FrontierParameters, NameWhatTheRadiusIsCalledNow) {
  exploration::FrontierParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("inscribed_radius: 0.2"), parameters),
            (Problems{"inscribed_radius: is called clearance_margin (on top of half the robot's width) now"}));
}

/// What a look through a door from the side shows of the room behind: a strip that is too narrow to be entered.
TEST_F(FrontierJudgement, AStripSeenThroughADoorHasAGoalAtTheDoor_EXP_2) {
  std::string drawing = R"(
##############################
#............................#
#............................#
#....r.......................#
#............................#
#............................#
#............................#
#............................#
#............................#
#............................#
#............................#
################..############
)";
  for (int row = 0; row < 57; ++row) drawing += "????????????????..????????????\n";
  const exploration::Frontier& f = judge(drawing);
  EXPECT_EQ(f.rejection, exploration::Rejection::kNone) << toString(f.rejection) << " [EXP-2]";
}

// [EXP-5] Near a wall, where no way leads to.
TEST_F(FrontierJudgement, ARobotIsNotCutOffFromAStartThatIsOnlyTooNearToAWall_EXP_5) {
  judge(kRoom);
  const exploration::FrontierEvaluator::Context context{world.point('r'), {0.5, 0.1}, &history, 0.0};
  evaluator->evaluateTightWays(context);
  ASSERT_FALSE(evaluator->travel().reached(world.map.geometry().cellAt(context.start)));
  EXPECT_FALSE(evaluator->evaluateWaysFromStart(context));
}

}  // namespace
}  // namespace frontier_pilot
