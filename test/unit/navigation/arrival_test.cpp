// What happens at the position of a goal, where only its direction is left.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "support/floors/driven_robot.h"
#include "support/floors/room.h"
#include "support/floors/zigzag.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

using navigation::NavReason;
using navigation::NavResult;
using navigation::NavState;
using test::DrivenRobot;
using test::room;

const Pose2 kGoal(2.0, 1.5, 3.0);

/// A robot that has arrived at the position of kGoal and turns there.
DrivenRobot turningRobot() {
  DrivenRobot robot(room(), {1.5, 1.5, 0.0});
  robot.sendPose(kGoal, true);
  for (int i = 0; i < 400 && robot.output().state != NavState::kTurning; ++i) robot.tick();
  EXPECT_EQ(robot.output().state, NavState::kTurning);
  return robot;
}

double distanceFromGoal(const DrivenRobot& robot) { return (robot.pose().position() - kGoal.position()).norm(); }

// [NAV-1] The avoider may hold it, its navigation be switched off, or a wheel be jammed.
TEST(Arrival, ATurnThatDoesNotGetOnEndsTheGoalAsBlocked_NAV_1) {
  DrivenRobot robot = turningRobot();
  robot.held = true;
  const auto finished = robot.runUntilFinished(120.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kAborted);
  EXPECT_STREQ(toString(finished->reason), toString(NavReason::kBlocked));
}

// [NAV-1]
TEST(Arrival, ATurnGoesOnWhenTheWheelsAreFreeAgain_NAV_1) {
  DrivenRobot robot = turningRobot();
  robot.held = true;
  robot.run(12.0);
  robot.held = false;
  const auto finished = robot.runUntilFinished(60.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kSucceeded);
}

// [NAV-1] A robot that is slow to turn gets on all the same.
TEST(Arrival, ASlowTurnIsNoBlockedOne_NAV_1) {
  navigation::NavigatorParams params;
  params.robot.limits.max_angular = 0.05;
  DrivenRobot robot(room(), {2.0, 1.5, 0.0}, params);
  robot.sendPose(kGoal, true);
  const auto finished = robot.runUntilFinished(90.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kSucceeded);
}

// [NAV-1] By a source of higher priority, or because a closed loop has corrected the map.
TEST(Arrival, ARobotThatIsMovedAwayWhileItTurnsDrivesBackToItsGoal_NAV_1) {
  DrivenRobot robot = turningRobot();
  ASSERT_EQ(robot.simulator().setPose("", {3.0, 1.5, robot.pose().yaw}), sim::Placement::kDone);
  const auto finished = robot.runUntilFinished(60.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kSucceeded);
  EXPECT_LT(distanceFromGoal(robot), navigation::NavigatorParams().goal_tolerance + 0.01);
}

// [NAV-1] Somebody stood there when it was mapped.
TEST(Arrival, AGoalThatBecomesFreeOnTheWayIsTheOneThatIsReached_NAV_1) {
  const Vec2 goal(4.0, 1.5);
  DrivenRobot robot(room(), {1.0, 1.5, 0.0});
  OccupancyGrid occupied = room();
  for (int y = 27; y < 33; ++y) {
    for (int x = 77; x < 83; ++x) occupied[Cell{x, y}] = kOccupied;  // 0.3 m x 0.3 m
  }
  robot.navigator().setMap(occupied, occupied.geometry().rect());
  robot.send(goal);
  robot.run(1.0);
  const double tolerance = navigation::NavigatorParams().goal_tolerance;
  ASSERT_GT((robot.navigator().path().goal() - goal).norm(), tolerance) << "it would end beside the goal";
  robot.navigator().setMap(room(), occupied.geometry().rect());
  const auto finished = robot.runUntilFinished(60.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kSucceeded);
  EXPECT_LT((robot.pose().position() - goal).norm(), tolerance + 0.01);
}

// [NAV-1] On a floor where it slips, or with a pose that jumps to and fro.
TEST(Arrival, ARobotThatIsMovedAwayEachTimeGivesUpAtLast_NAV_1) {
  DrivenRobot robot = turningRobot();
  std::optional<navigation::NavFinished> finished;
  for (int i = 0; i < 4000 && !finished; ++i) {
    if (robot.output().state == NavState::kTurning) robot.simulator().setPose("", {2.5, 1.5, 0.0});
    finished = robot.runUntilFinished(0.05);
  }
  ASSERT_TRUE(finished);
  EXPECT_STREQ(toString(finished->reason), toString(NavReason::kBlocked));
}

// [NAV-1] [NAV-3] The way back to the goal is so long that it counts as progress.
TEST(Arrival, ARobotThatBacksFarAwayFromAGoalWhereItCannotTurnGivesUpAtLast_NAV_1_NAV_3) {
  navigation::NavigatorParams params;
  params.recovery.back_up_distance = 0.8;
  DrivenRobot robot(room(), {1.5, 1.5, 0.0}, params);
  robot.sendPose(kGoal, true);
  std::optional<navigation::NavFinished> finished;
  for (int i = 0; i < 8000 && !finished; ++i) {
    robot.held = robot.output().state == NavState::kTurning;
    finished = robot.runUntilFinished(0.05);
  }
  ASSERT_TRUE(finished);
  EXPECT_STREQ(toString(finished->reason), toString(NavReason::kBlocked));
}

// [NAV-1] [NAV-3] It could turn a little way behind the goal, but that is not the goal.
TEST(Arrival, ARobotThatHasBackedAwayFromItsGoalHasNotReachedIt_NAV_1_NAV_3) {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot("waffle");
  OccupancyGrid map = room();
  for (int y = 2; y < 62; ++y) {
    for (int x = 36; x < 122; ++x) {
      if (y < 27 || y >= 36) map[Cell{x, y}] = kOccupied;  // a corridor of 0.45 m begins at x = 1.8
    }
  }
  for (const double x : {1.7, 1.74, 1.78, 1.82, 1.86, 1.9}) {
    DrivenRobot robot(map, {1.0, 1.575, 0.0}, params);
    const Vec2 goal(x, 1.575);
    robot.sendPose({goal, 0.5 * kPi}, true);
    const auto finished = robot.runUntilFinished(180.0);
    ASSERT_TRUE(finished) << x;
    EXPECT_EQ(robot.contacts(), 0) << x;
    if (finished->result != NavResult::kSucceeded) continue;
    EXPECT_LT((robot.pose().position() - goal).norm(), params.goal_tolerance + 0.01) << x;
  }
}

/// The room with a wall in column `x`, with a door of 0.5 m in it or without.
void drawWall(OccupancyGrid& map, int x, bool has_door) {
  for (int y = 2; y < 62; ++y) map[Cell{x, y}] = has_door && y >= 26 && y < 36 ? kFree : kOccupied;
}

// [NAV-3] [NAV-4] The door ahead is shut, and the scanner does not see the wall behind the robot.
TEST(Recoveries, DoNotBackIntoAWallThatOnlyTheMapShows_NAV_3_NAV_4) {
  for (const bool disc : {true, false}) {
    navigation::NavigatorParams params;
    if (!disc) params.robot = test::shippedRobot("waffle");
    const Outline outline = params.robot.drivenOutline();
    const double rear = outline.rear();
    OccupancyGrid world = room(), map = room();
    drawWall(world, 64, false);
    drawWall(map, 64, true);
    drawWall(map, 45, false);  // its surface is at x = 2.3
    DrivenRobot robot(world, {2.4 + rear, 1.55, 0.0}, params);
    robot.navigator().setMap(map, map.geometry().rect());
    robot.send({5.0, 1.55});
    double least = robot.pose().x;
    std::optional<navigation::NavFinished> finished;
    for (int i = 0; i < 6000 && !finished; ++i) {
      finished = robot.runUntilFinished(0.05);
      least = std::min(least, robot.pose().x);
    }
    EXPECT_TRUE(finished) << disc;
    EXPECT_EQ(robot.recoveries.count("backing up"), 1U) << disc;
    EXPECT_GT(least - rear, 2.3) << disc;
    EXPECT_EQ(robot.contacts(), 0) << disc;
  }
}

// [NAV-3] [NAV-4] It backs towards a wall beside it that the scanner does not see, by 9 cm with each metre.
TEST(Recoveries, DoNotComeNearerStepByStepToAWallThatOnlyTheMapShows_NAV_3_NAV_4) {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot("waffle");
  params.recovery.back_up_distance = 1.0;
  const Outline outline = params.robot.drivenOutline();
  OccupancyGrid world = room(), map = room();
  drawWall(world, 64, false);
  drawWall(map, 64, true);
  for (int y = 22; y < 26; ++y) {
    for (int x = 10; x < 54; ++x) map[Cell{x, y}] = kOccupied;  // its surface is at y = 1.3
  }
  const Vec2 corner(-outline.rear(), -outline.halfWidth());
  const double skew = 0.087;
  DrivenRobot robot(world, {2.6, 1.365 - (Pose2(0.0, 0.0, skew) * corner).y(), skew}, params);
  robot.navigator().setMap(map, map.geometry().rect());
  robot.send({5.0, 1.76});
  double least = 3.0;
  std::optional<navigation::NavFinished> finished;
  for (int i = 0; i < 4000 && !finished; ++i) {
    finished = robot.runUntilFinished(0.05);
    least = std::min(least, (robot.pose() * corner).y());
  }
  EXPECT_TRUE(finished);
  EXPECT_EQ(robot.recoveries.count("backing up"), 1U);
  EXPECT_GT(least, 1.3);
  EXPECT_EQ(robot.contacts(), 0);
}

// [NAV-3] [MUL-3] It could be a robot that backs up as well.
TEST(Recoveries, KeepToTheirSideOfTheMiddleToWhatStandsWhereTheMapShowsFreeFloor_NAV_3_MUL_3) {
  DrivenRobot robot(room(), {4.0, 1.5, 0.0});
  ASSERT_EQ(robot.simulator().spawnObstacle("crate", {3.2, 1.5, 0.0}, 0.25), sim::Placement::kDone);
  std::optional<bool> before_the_middle, beyond_the_middle;
  const auto look = [&](const navigation::RecoveryInputs& in, Time) {
    before_the_middle = in.has_room(in.T_map_base * Pose2(-0.12, 0.0, 0.0));
    beyond_the_middle = in.has_room(in.T_map_base * Pose2(-0.22, 0.0, 0.0));
    return navigation::RecoveryStep{{}, true};
  };
  robot.navigator().setParameters({}, {{"looking", false, [&] { return look; }}});
  robot.held = true;
  robot.send({5.0, 1.5});
  robot.runUntilFinished(60.0);
  ASSERT_TRUE(before_the_middle);
  EXPECT_TRUE(*before_the_middle);
  EXPECT_FALSE(*beyond_the_middle);
}

// [NAV-3] [MUL-3]
TEST(Recoveries, BackUpAsFarAsThereIsRoomBeforeACrateBehind_NAV_3_MUL_3) {
  for (const char* kind : {"burger", "turtlebot2", "waffle"}) {
    navigation::NavigatorParams params;
    params.robot = test::shippedRobot(kind);
    const double rear = params.robot.drivenOutline().rear();
    OccupancyGrid world = room(), map = room();
    drawWall(world, 64, false);
    drawWall(map, 64, true);
    DrivenRobot robot(world, {2.6, 1.55, 0.0}, params);
    robot.navigator().setMap(map, map.geometry().rect());
    ASSERT_EQ(robot.simulator().spawnObstacle("crate", {2.6 - rear - 0.25 - 0.2, 1.55, 0.0}, 0.2),
              sim::Placement::kDone);
    robot.send({5.0, 1.55});
    while (robot.recoveries.count("backing up") == 0) robot.tick();
    const Vec2 before = robot.pose().position();
    double backed = 0.0;
    while (robot.output().recovery == "backing up") {
      robot.tick();
      backed = std::max(backed, (robot.pose().position() - before).norm());
    }
    EXPECT_GT(backed, 0.04) << kind;
    EXPECT_EQ(robot.contacts(), 0) << kind;
  }
}

// [NAV-3] [MUL-3] Teammates that pass do not change that the way is blocked by a thing.
TEST(Recoveries, AreNotBegunAnewByOrdersToHold_NAV_3_MUL_3) {
  OccupancyGrid world = room(), map = room();
  drawWall(world, 64, false);
  drawWall(map, 64, true);
  DrivenRobot robot(world, {1.5, 1.55, 0.0});
  robot.navigator().setMap(map, map.geometry().rect());
  robot.send({5.0, 1.55});
  std::optional<navigation::NavFinished> finished;
  for (int i = 0; i < 6000 && !finished; ++i) {
    robot.order.hold = i % 80 < 10;  // for half a second every four
    finished = robot.runUntilFinished(0.05);
  }
  EXPECT_TRUE(finished);
}

// [FLT-1]
TEST(Recoveries, NoMarkOutlivesAClockThatIsSetBack_FLT_1) {
  DrivenRobot robot(room(), {1.5, 1.5, 0.0});
  const Vec2 place(2.3, 1.5);
  ASSERT_EQ(robot.simulator().spawnObstacle("crate", {place, 0.0}, 0.2), sim::Placement::kDone);
  robot.run(1.0);
  const auto marked = [&] {
    const planning::ClearanceMap& map = robot.navigator().clearanceMap();
    return map.isOccupied(map.geometry().cellAt(place - Vec2(0.2, 0.0)));
  };
  ASSERT_TRUE(marked());
  robot.navigator().update({}, robot.simulator().now() - std::chrono::seconds(1));
  EXPECT_FALSE(marked());
}

}  // namespace
}  // namespace frontier_pilot
