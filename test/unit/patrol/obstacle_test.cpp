// What a patrol does with what is in its way. [PAT-7]

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "patrol_loop.h"

namespace frontier_pilot {
namespace {

using patrol::PatrolOutcome;

// [PAT-7]
TEST(PatrolAndObstacles, StopsBeforeAnObstacleAndSaysWhatItIs_PAT_7) {
  test::PatrolLoop loop;
  constexpr double kWall = 0.7;  // [m] ahead of the start
  loop.inputs.way_ahead = [](const Pose2& T_odom_base, const Twist2& arc) -> std::optional<std::string> {
    if ((T_odom_base * Pose2(arc.linear, 0.0, 0.0)).x < kWall) return std::nullopt;
    return "an obstacle ahead";
  };
  loop.start(test::kSquare);
  const patrol::PatrolOutput output = loop.run(60.0);
  test::expectEnd(output, PatrolOutcome::kObstacleAhead);
  EXPECT_EQ(output.text, "aborted: an obstacle ahead");
  loop.base.run({}, 1.0);  // until it stands
  EXPECT_LT(loop.base.pose().x, kWall - 0.1);
  EXPECT_GT(loop.base.pose().x, 0.4);
}

// [PAT-7]
TEST(PatrolAndObstacles, StandsUntilSomethingThatPassesIsGone_PAT_7) {
  test::PatrolLoop loop;
  loop.start(test::kSquare);
  loop.run(2.0);
  loop.inputs.way_ahead = [](const Pose2&, const Twist2&) { return std::optional<std::string>("an obstacle ahead"); };
  EXPECT_TRUE(loop.cycle().command->isZero());
  EXPECT_EQ(loop.run(0.8).outcome, PatrolOutcome::kRunning);
  loop.inputs.way_ahead = [](const Pose2&, const Twist2&) { return std::optional<std::string>(); };
  EXPECT_EQ(loop.run(120.0).outcome, PatrolOutcome::kCompleted);
  test::expectClosed(loop, {});
}

// [PAT-7] The clock of a simulation may be many times as fast as the one by which nodes connect.
TEST(PatrolAndObstacles, BeginsOnceItIsKnownWhetherSomebodyLooksAheadHoweverLongThatTakes_PAT_7) {
  const patrol::PatrolParameters parameters;
  test::PatrolLoop loop(parameters);
  loop.inputs.is_connecting = true;
  loop.inputs.way_ahead = [](const Pose2&, const Twist2&) { return std::optional<std::string>("no fresh scan"); };
  loop.start(test::kSquare);
  EXPECT_EQ(loop.run(parameters.blocked_timeout + parameters.obstacle_timeout).outcome, PatrolOutcome::kRunning);
  EXPECT_TRUE(loop.cycle().command->isZero());
  loop.inputs.is_connecting = false;
  loop.inputs.way_ahead = {};
  EXPECT_EQ(loop.run(120.0).outcome, PatrolOutcome::kCompleted);
  test::expectClosed(loop, {});
}

// [PAT-7] A robot that stands before an obstacle makes no progress, but that is not why it does not drive.
TEST(PatrolAndObstacles, StandsBeforeAnObstacleForLongerThanWithoutProgress_PAT_7) {
  patrol::PatrolParameters parameters;
  parameters.obstacle_timeout = 2.0 * parameters.blocked_timeout;
  test::PatrolLoop loop(parameters);
  loop.start(test::kSquare);
  loop.run(2.0);
  loop.inputs.way_ahead = [](const Pose2&, const Twist2&) { return std::optional<std::string>("an obstacle ahead"); };
  EXPECT_EQ(loop.run(parameters.obstacle_timeout - 1.0).outcome, PatrolOutcome::kRunning);
  const patrol::PatrolOutput output = loop.run(2.0);
  test::expectEnd(output, PatrolOutcome::kObstacleAhead);
  EXPECT_EQ(output.text, "aborted: an obstacle ahead");
}

// [PAT-7] [PAT-5] What is seen in one cycle and not in the next one does not keep the patrol waiting for ever.
TEST(PatrolAndObstacles, GivesUpWithoutProgressBeforeAnObstacleThatComesAndGoes_PAT_5_PAT_7) {
  test::PatrolLoop loop;
  loop.start(test::kSquare);
  loop.run(2.0);
  bool seen = false;
  loop.inputs.way_ahead = [&seen](const Pose2&, const Twist2&) {
    seen = !seen;
    return seen ? std::optional<std::string>("an obstacle ahead") : std::nullopt;
  };
  test::expectEnd(loop.run(30.0, Twist2()), PatrolOutcome::kBlocked);
}

/// What is driven in a second at `speed`, and until the robot then stands.
double wayUntilItStands(double speed, double acceleration) { return speed + 0.5 * speed * speed / acceleration; }

// [PAT-7] A wall behind the corner of the shape is in nobody's way, unless the robot would all but touch it: it does
// not come to stand to the centimetre.
TEST(PatrolAndObstacles, LooksALittleBeyondTheEndOfTheLegAndNoFarther_PAT_7) {
  test::PatrolLoop loop;
  double farthest = 0.0, most_turn = 0.0;
  loop.inputs.way_ahead = [&](const Pose2& T_odom_base, const Twist2& arc) {
    farthest = std::max(farthest, (T_odom_base * Pose2(arc.linear, 0.0, 0.0)).x);
    most_turn = std::max(most_turn, arc.angular);
    return std::optional<std::string>();
  };
  loop.start(test::kSquare);
  EXPECT_EQ(loop.run(120.0).outcome, PatrolOutcome::kCompleted);
  EXPECT_GT(farthest, test::kSquare.size + 0.025);
  EXPECT_LT(farthest, test::kSquare.size + 0.06);
  EXPECT_NEAR(most_turn, wayUntilItStands(1.0, patrol::PatrolParameters().turn_acc), 1e-9);
}

// [PAT-7] So far has to be seen.
TEST(PatrolAndObstacles, LooksNoFartherThanItSaysThatItDoes_PAT_7) {
  patrol::PatrolParameters parameters;
  parameters.robot.limits.max_linear = parameters.linear_speed = 0.65;
  for (const patrol::PatrolOrder& order : {patrol::PatrolOrder{1.0, 4.0, 1.0}, patrol::PatrolOrder{3.0, 2.0, 1.0}}) {
    test::PatrolLoop loop(parameters);
    double farthest = 0.0;
    loop.inputs.way_ahead = [&farthest](const Pose2&, const Twist2& arc) {
      farthest = std::max(farthest, arc.linear);
      return std::optional<std::string>();
    };
    loop.start(order);
    loop.run(20.0);
    EXPECT_NEAR(farthest, patrol::reach(parameters, 0.0), 1e-9);
  }
  EXPECT_NEAR(patrol::reach(parameters, 1.0) - patrol::reach(parameters, 0.0), 0.65, 1e-9);
}

// [PAT-7]
TEST(PatrolAndObstacles, LooksAlongTheArcOfACircle_PAT_7) {
  test::PatrolLoop loop;
  std::vector<Twist2> arcs;
  loop.inputs.way_ahead = [&arcs](const Pose2&, const Twist2& arc) {
    arcs.push_back(arc);
    return std::optional<std::string>();
  };
  loop.start({3.0, 0.5, 1.0});
  EXPECT_EQ(loop.run(120.0).outcome, PatrolOutcome::kCompleted);
  const Twist2& cruising = arcs[arcs.size() / 2];
  EXPECT_NEAR(cruising.linear, wayUntilItStands(0.18, patrol::PatrolParameters().linear_acc), 0.01);
  EXPECT_NEAR(cruising.angular, cruising.linear / 0.5, 0.1);
}

// [PAT-7] [PAT-5] The avoider looks for itself, and may get nearer than a patrol would.
TEST(PatrolAndObstacles, LeavesTheWayToAnotherSourceThatDrives_PAT_5_PAT_7) {
  test::PatrolLoop loop;
  loop.start(test::kSquare);
  loop.run(1.0);
  loop.inputs.way_ahead = [](const Pose2&, const Twist2&) { return std::optional<std::string>("an obstacle ahead"); };
  loop.inputs.wheels_held_by = "avoid";
  EXPECT_EQ(loop.run(1.0, Twist2()).outcome, PatrolOutcome::kRunning);
  loop.inputs.wheels_held_by.reset();
  EXPECT_TRUE(loop.cycle().command->isZero());
  test::expectEnd(loop.run(2.0), PatrolOutcome::kObstacleAhead);
}

}  // namespace
}  // namespace frontier_pilot
