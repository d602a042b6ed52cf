#include "frontier_pilot/navigation/navigator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/floors/driven_robot.h"

namespace frontier_pilot {
namespace {

using test::AsciiWorld;
using test::DrivenRobot;

/// Two rooms of 3 m with a door of `door` cells at 5 cm, drawn by the program because of its size.
AsciiWorld twoRooms(int door) {
  std::string drawing;
  for (int y = 0; y < 62; ++y) {
    std::string row(124, '.');
    for (int x = 0; x < 124; ++x) {
      const bool border = x == 0 || y == 0 || x == 123 || y == 61;
      const bool wall = x == 62 && std::abs(y - 30) > door / 2;
      if (border || wall) row[static_cast<std::size_t>(x)] = '#';
    }
    drawing += row + '\n';
  }
  return test::drawWorld(drawing);
}

const Pose2 kLeft(1.0, 1.5, kPi);
const Vec2 kRight(5.0, 1.0);

void expectFinished(const std::optional<navigation::NavFinished>& finished, navigation::NavResult result,
                    navigation::NavReason reason) {
  ASSERT_TRUE(finished.has_value());
  EXPECT_STREQ(toString(finished->result), toString(result));
  EXPECT_STREQ(toString(finished->reason), toString(reason));
}

// [NAV-1] [NAV-4]
TEST(Navigator, DrivesThroughADoorToItsGoalAndStopsThere_NAV_1_NAV_4) {
  for (const navigation::NavigatorParams& params : {navigation::NavigatorParams{}, DrivenRobot::fast()}) {
    DrivenRobot robot(twoRooms(14), kLeft, params);
    robot.send(kRight);
    expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
    EXPECT_EQ(robot.output().command, Twist2{});
    EXPECT_LT((robot.pose().position() - kRight).norm(), params.goal_tolerance + 0.01);
    robot.run(0.5);
    EXPECT_EQ(robot.speed(), 0.0);
    EXPECT_FALSE(robot.output().command.has_value()) << "without a goal nothing is published";
    EXPECT_EQ(robot.contacts(), 0);
  }
}

TEST(Navigator, TurnsToTheGoalsDirectionOnlyWhereItMatters_NAV_1) {
  DrivenRobot robot(twoRooms(14), kLeft);
  robot.sendPose({1.5, 1.5, -2.0}, true);
  expectFinished(robot.runUntilFinished(30.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  EXPECT_NEAR(angleDifference(robot.pose().yaw, -2.0), 0.0, 0.15);
}

TEST(Navigator, DoesNotStopForANewerGoal_NAV_1) {
  DrivenRobot robot(twoRooms(14), {1.0, 1.5, 0.0});
  robot.send(kRight, 1);
  robot.run(5.0);
  const double standing = robot.standingTime();
  robot.send({5.0, 2.0}, 2);
  const navigation::NavigatorOutput& output = robot.tick();
  ASSERT_EQ(output.finished.size(), 1U);
  EXPECT_EQ(output.finished[0].id, 1U);
  EXPECT_EQ(output.finished[0].result, navigation::NavResult::kPreempted);
  EXPECT_FALSE(output.command->isZero()) << "the robot goes on";
  const auto finished = robot.runUntilFinished(60.0);
  expectFinished(finished, navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  EXPECT_EQ(finished->id, 2U);
  EXPECT_EQ(robot.standingTime(), standing) << "and never stood";
}

TEST(Navigator, StandsAtOnceWhenCanceled_NAV_1) {
  DrivenRobot robot(twoRooms(14), kLeft);
  robot.send(kRight);
  robot.run(5.0);
  robot.cancel();
  const navigation::NavigatorOutput& output = robot.tick();
  EXPECT_EQ(output.command, Twist2{});
  ASSERT_EQ(output.finished.size(), 1U);
  EXPECT_EQ(output.finished[0].result, navigation::NavResult::kCanceled);
  robot.run(0.5);
  EXPECT_EQ(robot.speed(), 0.0);
}

TEST(Navigator, SaysWhyItAborts_NAV_1) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    int door;
    Vec2 goal;
    navigation::NavReason reason;
  } cases[] = {{3, kRight, navigation::NavReason::kNoPath},
               {14, {-5.0, 1.0}, navigation::NavReason::kGoalOutside},
               {14, {nan, 1.0}, navigation::NavReason::kInvalidGoal}};
  for (const auto& test_case : cases) {
    DrivenRobot robot(twoRooms(test_case.door), kLeft);
    robot.run(0.5);
    robot.send(test_case.goal);
    const auto finished = robot.runUntilFinished(1.0);
    expectFinished(finished, navigation::NavResult::kAborted, test_case.reason);
    EXPECT_EQ(robot.output().command, Twist2{});
  }
}

TEST(Navigator, StandsStillWithoutPoseScanOrMapAndGoesOnWhenTheyAreBack_NAV_1) {
  bool DrivenRobot::*const needed[] = {&DrivenRobot::has_pose, &DrivenRobot::has_scan, &DrivenRobot::has_map,
                                       &DrivenRobot::is_localized};
  const navigation::NavReason reasons[] = {navigation::NavReason::kNoPose, navigation::NavReason::kNoScan,
                                           navigation::NavReason::kNoMap, navigation::NavReason::kNotLocalized};
  for (std::size_t i = 0; i < 4; ++i) {
    DrivenRobot robot(twoRooms(14), kLeft);
    robot.send(kRight);
    robot.run(5.0);
    robot.*needed[i] = false;
    robot.run(1.5);
    EXPECT_EQ(robot.output().command, Twist2{});
    EXPECT_EQ(robot.output().reason, reasons[i]);
    EXPECT_EQ(robot.output().state, navigation::NavState::kWaiting);
    EXPECT_EQ(robot.speed(), 0.0);
    robot.*needed[i] = true;
    expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  }
}

// [FLT-1] [NAV-4]
TEST(Navigator, StandsWhenItsScannerSeesNoneOfTheWallsOfTheMap_FLT_1_NAV_4) {
  DrivenRobot robot(twoRooms(14), kLeft);
  robot.send(kRight);
  robot.run(5.0);
  robot.is_blind = true;
  robot.run(1.5);
  EXPECT_EQ(robot.output().reason, navigation::NavReason::kNoScan);
  EXPECT_EQ(robot.speed(), 0.0);
  robot.is_blind = false;
  expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  EXPECT_EQ(robot.contacts(), 0);
}

TEST(Navigator, AbortsWithLostPoseAfterItsPatience_NAV_1) {
  DrivenRobot robot(twoRooms(14), kLeft);
  robot.send(kRight);
  robot.run(2.0);
  robot.has_pose = false;
  expectFinished(robot.runUntilFinished(20.0), navigation::NavResult::kAborted, navigation::NavReason::kNoPose);
  EXPECT_STREQ(toString(navigation::NavReason::kNoPose), "lost pose");
}

TEST(Navigator, StandsByPosesOfTheFutureAndGoesOnByTheNextTrueOne_NAV_1_FLT_1) {
  DrivenRobot robot(twoRooms(14), kLeft);
  robot.send(kRight);
  robot.run(2.0);
  robot.pose_ahead = std::chrono::seconds(20);  // one node's transforms come from another time
  robot.run(1.0);
  EXPECT_STREQ(toString(robot.output().reason), toString(navigation::NavReason::kNoPose));
  EXPECT_EQ(robot.output().command, Twist2{});
  robot.pose_ahead = Duration::zero();
  robot.run(0.3);
  EXPECT_FALSE(robot.output().command->isZero());
  expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
}

TEST(Navigator, AvoidsAnObstacleThatTheMapLacks_NAV_2_NAV_4) {
  // [NAV-2] [NAV-4]
  for (const navigation::NavigatorParams& params : {navigation::NavigatorParams{}, DrivenRobot::fast()}) {
    for (const double radius : {0.2, 0.3}) {
      DrivenRobot robot(twoRooms(30), {1.0, 1.5, 0.0}, params);
      robot.send(kRight);
      robot.run(3.0);
      const Vec2 ahead = robot.navigator().path().at(robot.navigator().progress() + 0.6 + radius);
      ASSERT_EQ(robot.simulator().spawnObstacle("crate", {ahead, 0.0}, radius), sim::Placement::kDone);
      expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
      EXPECT_EQ(robot.contacts(), 0);
    }
  }
}

TEST(Navigator, ClimbsTheLadderWhenBlockedAndThenGivesUp_NAV_3) {
  // [NAV-3] A crate fills the only door.
  DrivenRobot robot(twoRooms(10), {1.0, 1.5, 0.0}, {});
  ASSERT_EQ(robot.simulator().spawnObstacle("crate", {3.1, 1.5, 0.0}, 0.25), sim::Placement::kDone);
  robot.send(kRight);
  const auto finished = robot.runUntilFinished(300.0);
  ASSERT_TRUE(finished.has_value());
  EXPECT_EQ(finished->result, navigation::NavResult::kAborted);
  EXPECT_EQ(robot.recoveries, (std::set<std::string>{"clearing the local costmap", "backing up", "spinning"}));
  EXPECT_EQ(robot.contacts(), 0);
}

TEST(Navigator, GoesOnWhenTheObstacleIsTakenAway_NAV_3) {
  DrivenRobot robot(twoRooms(10), {1.0, 1.5, 0.0}, {});
  ASSERT_EQ(robot.simulator().spawnObstacle("crate", {3.1, 1.5, 0.0}, 0.25), sim::Placement::kDone);
  robot.send(kRight);
  while (robot.recoveries.count("backing up") == 0) robot.tick();
  robot.simulator().removeObstacle("crate");
  expectFinished(robot.runUntilFinished(120.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
}

TEST(Navigator, ReplansWhenTheMapClosesItsWay_NAV_2) {
  AsciiWorld world = twoRooms(14);
  DrivenRobot robot(world, {1.0, 1.5, 0.0});
  robot.send(kRight);
  robot.run(2.0);
  for (int y = 0; y < 62; ++y) world.map[Cell{62, y}] = kOccupied;
  robot.navigator().setMap(world.map, {62, 0, 1, 62});
  expectFinished(robot.runUntilFinished(2.0), navigation::NavResult::kAborted, navigation::NavReason::kNoPath);
}

TEST(Navigator, SurvivesAMapOfAnotherSize_NAV_2) {
  DrivenRobot robot(twoRooms(14), {1.0, 1.5, 0.0});
  robot.send(kRight);
  robot.run(2.0);
  OccupancyGrid small(GridGeometry{0.05, Vec2::Zero(), 50, 50}, kFree);
  robot.navigator().setMap(small, small.geometry().rect());
  expectFinished(robot.runUntilFinished(2.0), navigation::NavResult::kAborted, navigation::NavReason::kGoalOutside);
}

TEST(Navigator, GetsOutOfTheInflation_NAV_2) {
  // Centre 0.13 m from the wall's surface: free of contact, but too near for a path.
  DrivenRobot robot(twoRooms(14), {1.0, 0.05 + 0.115, 0.0});
  robot.send(kRight);
  expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  EXPECT_EQ(robot.contacts(), 0);
}

TEST(Navigator, StopsWhenTheClockJumpsBackward) {
  navigation::Navigator navigator;
  navigation::NavigatorInputs inputs;
  inputs.new_goal = navigation::NavGoal{7, {1.0, 1.0, 0.0}, false};
  navigator.update(inputs, timeFromSeconds(100.0));
  const navigation::NavigatorOutput output = navigator.update({}, timeFromSeconds(50.0));
  ASSERT_EQ(output.finished.size(), 1U);
  EXPECT_EQ(output.finished[0].reason, navigation::NavReason::kClockJumped);
  EXPECT_STREQ(toString(navigation::NavReason::kClockJumped), "the clock jumped");
  EXPECT_EQ(output.command, Twist2{});
}

TEST(Navigator, EndsEveryGoalExactlyOnce_NAV_1) {
  DrivenRobot robot(twoRooms(14), kLeft);
  std::multiset<std::uint64_t> ended;
  for (std::uint64_t id = 1; id <= 40; ++id) {
    robot.send({0.5 + 0.13 * static_cast<double>(id % 37), 1.5}, id);
    if (id % 7 == 0) robot.cancel();
    for (int i = 0; i < 15; ++i) {
      for (const navigation::NavFinished& finished : robot.tick().finished) ended.insert(finished.id);
    }
  }
  robot.cancel();
  for (const navigation::NavFinished& finished : robot.tick().finished) ended.insert(finished.id);
  for (std::uint64_t id = 1; id <= 40; ++id) EXPECT_EQ(ended.count(id), 1U) << id;
}

TEST(Navigator, ASlowerLimitHoldsWhileItDrives) {
  navigation::NavigatorParams params = DrivenRobot::fast();
  DrivenRobot robot(twoRooms(14), {1.0, 1.5, 0.0}, params);
  robot.send(kRight);
  robot.run(3.0);
  EXPECT_GT(robot.speed(), 0.3);
  params.robot.limits.max_linear = 0.1;
  robot.navigator().setParameters(params, navigation::clearingLadder());
  EXPECT_LE(robot.tick().command->linear, 0.1);
  expectFinished(robot.runUntilFinished(90.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
  EXPECT_EQ(robot.contacts(), 0);
}

TEST(Navigator, AnotherClearanceMovesThePathAndTheRobotDoesNotStopForIt) {
  const AsciiWorld world = twoRooms(14);
  const Vec2 along_the_wall(2.6, 0.3);
  navigation::NavigatorParams params;
  params.clearance.preferred_clearance = 0.0;
  DrivenRobot robot(world, {0.3, 0.3, 0.0}, params);
  robot.send(along_the_wall);
  robot.run(2.0);
  const auto nearest = [&] {
    double most = 0.0;
    for (const Vec2& point : robot.navigator().path().sampled(0.1)) most = std::max(most, point.y());
    return most;
  };
  EXPECT_LT(nearest(), 0.4) << "straight along the wall";
  params.clearance.preferred_clearance = 0.6;
  robot.navigator().setParameters(params, navigation::clearingLadder());
  EXPECT_FALSE(robot.tick().command->isZero());
  EXPECT_GT(nearest(), 0.45) << "farther from it";
  expectFinished(robot.runUntilFinished(60.0), navigation::NavResult::kSucceeded, navigation::NavReason::kReached);
}

}  // namespace
}  // namespace frontier_pilot
