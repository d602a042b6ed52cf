#include "frontier_pilot/sim/simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "sim/collision/collision_map.h"
#include "simulated_room.h"

namespace frontier_pilot::sim {
namespace {

std::string refusal(const SimulatorParameters& parameters) {
  try {
    const Simulator simulator(world(room()), parameters);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// [SIM-1] a start in a wall, outside, or nowhere is refused in words that help
TEST(Simulator, RefusesAStartInAWallAndNamesTheNearestFreePlace_SIM_1) {
  SimulatorParameters parameters = quiet();
  parameters.x = 1.55;
  parameters.y = 0.42;
  EXPECT_EQ(refusal(parameters),
            "the robot cannot start at (1.55, 0.42): the place is in or too near to a wall; the nearest free place is "
            "(1.55, 0.25)");
  parameters.x = -4.0;
  EXPECT_NE(refusal(parameters).find("outside of the world"), std::string::npos);
  parameters.x = 0.15;  // free, but the footprint reaches into the wall
  EXPECT_NE(refusal(parameters).find("too near to a wall"), std::string::npos);
}

TEST(Simulator, RefusesTwoRobotsInOnePlace_SIM_1) {
  SimulatorParameters parameters = quiet();
  parameters.robots = {{"a", 0.5, 0.5, 0.0}, {"b", 0.6, 0.5, 0.0}};
  EXPECT_NE(refusal(parameters).find("robot 'b' cannot start at (0.6, 0.5): the place is taken by a robot"),
            std::string::npos);
}

// [SIM-1] unknown cells are solid unless they are declared free
TEST(Simulator, TakesUnknownCellsForSolidUnlessTold_SIM_1) {
  const AsciiWorld drawing = drawWorld("??????\n??????\n??????\n??????\n??????\n??????", 0.1);
  SimulatorParameters parameters = quiet();
  parameters.x = parameters.y = 0.3;
  EXPECT_THROW(Simulator(world(drawing), parameters), std::runtime_error);
  parameters.unknown_is_free = true;
  EXPECT_NO_THROW(Simulator(world(drawing), parameters));
}

// [SIM-1]
TEST(Simulator, StartsAtTheFreePlaceNearestToTheMiddleWhenNobodySaysWhere_SIM_1) {
  const AsciiWorld drawing =
      drawWorld("########\n#......#\n#......#\n#..##..#\n#..##..#\n#......#\n#......#\n########", 0.5);
  SimulatorParameters parameters;
  parameters.yaw = 0.5;
  const Simulator simulator(world(drawing), parameters);
  EXPECT_TRUE(simulator.startWasChosen());
  EXPECT_NEAR((simulator.pose(0).position() - Vec2(2.0, 2.0)).norm(), 0.79, 0.01);  // beside the pillar in the middle
  EXPECT_EQ(simulator.pose(0).yaw, 0.5);
  parameters.x = parameters.y = 0.75;
  EXPECT_FALSE(Simulator(world(drawing), parameters).startWasChosen());
}

// [SIM-1]
TEST(Simulator, SaysThatAWorldHasNoFreePlaceAtAll_SIM_1) {
  const auto refused = [](const std::string& drawing) {
    try {
      Simulator(world(drawWorld(drawing, 0.1)), SimulatorParameters());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused("####\n####\n####").find("the world has no free cell"), std::string::npos);
  EXPECT_NE(refused("####\n#.##\n####").find("the robot fits nowhere"), std::string::npos);
}

TEST(Simulator, StartsWhereTheWorldSaysUnlessToldOtherwise) {
  World with_start = world(room());
  with_start.start = Pose2(0.55, 0.65, 1.0);
  SimulatorParameters parameters;
  EXPECT_EQ(Simulator(with_start, parameters).pose(0), Pose2(0.55, 0.65, 1.0));
  parameters.yaw = 0.5;
  EXPECT_EQ(Simulator(with_start, parameters).pose(0), Pose2(0.55, 0.65, 0.5));
  parameters.x = 0.35;
  parameters.y = 0.45;
  EXPECT_EQ(Simulator(with_start, parameters).pose(0), Pose2(0.35, 0.45, 0.5));
}

// [SIM-1] accelerates within its limits and follows the exact arc
TEST(Simulator, DrivesExactArcs_SIM_1) {
  SimulatorParameters parameters = quiet();
  parameters.robot.limits.max_linear_acc = parameters.robot.limits.max_angular_acc = 1e6;
  Simulator simulator(world(room()), parameters);
  drive(simulator, {0.1, 0.5}, 2.0);
  const Pose2 expected = integrate({0.35, 0.45, 0.0}, {0.1, 0.5}, 2.0);
  EXPECT_NEAR(simulator.pose(0).x, expected.x, 1e-12);
  EXPECT_NEAR(simulator.pose(0).y, expected.y, 1e-12);
  EXPECT_NEAR(simulator.pose(0).yaw, 1.0, 1e-12);
}

TEST(Simulator, KeepsTheLimitsOfSpeedAndAcceleration_SIM_1) {
  SimulatorParameters parameters = quiet();
  parameters.robot.limits = {0.2, 1.0, 1.0, 2.0};
  Simulator simulator(world(room()), parameters);
  drive(simulator, {9.0, -9.0}, 0.1);
  EXPECT_NEAR(simulator.velocity(0).linear, 0.1, 1e-12);
  EXPECT_NEAR(simulator.velocity(0).angular, -0.2, 1e-12);
  drive(simulator, {9.0, -9.0}, 0.9);
  EXPECT_NEAR(simulator.velocity(0).linear, 0.2, 1e-12);
  EXPECT_NEAR(simulator.velocity(0).angular, -1.0, 1e-12);
}

// [SIM-1] a robot that is told nothing any more stops after 0.6 s
TEST(Simulator, StopsWhenTheCommandsCease_SIM_1) {
  Simulator simulator(world(room()), quiet());
  simulator.setCommand(0, {0.2, 0.0});
  for (int i = 0; i < 60; ++i) simulator.step();
  EXPECT_NEAR(simulator.velocity(0).linear, 0.2, 1e-12);
  for (int i = 0; i < 30; ++i) simulator.step();
  EXPECT_TRUE(simulator.velocity(0).isZero());
}

// [SIM-3] stops at the surface, counts one contact, can leave again
TEST(Simulator, StopsAtAWallAndCanDriveAwayAgain_SIM_3) {
  Simulator simulator(world(room()), quiet());
  drive(simulator, {0.2, 0.0}, 8.0);
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_EQ(simulator.contactCount(0), 1);
  EXPECT_NEAR(simulator.pose(0).x, 1.4 - 0.105, 1e-6);
  EXPECT_LE(simulator.pose(0).x, 1.4 - 0.105);
  EXPECT_NEAR(simulator.odometry(0).x, simulator.pose(0).x - 0.35, 1e-9);
  drive(simulator, {0.0, 1.0}, 1.0);
  EXPECT_TRUE(simulator.stalled(0)) << "it still touches the pillar";
  EXPECT_GT(simulator.pose(0).yaw, 0.5);
  drive(simulator, {-0.2, 0.0}, 1.0);
  EXPECT_FALSE(simulator.stalled(0));
  EXPECT_EQ(simulator.contactCount(0), 1);
}

// [SIM-3] never tunnels, however fast
TEST(Simulator, NeverTunnelsAtAnySpeed_SIM_3) {
  for (double speed : {0.5, 3.0, 20.0, 170.0}) {
    SimulatorParameters parameters = quiet();
    parameters.robot.limits = {1e3, 1e3, 1e6, 1e6};
    Simulator simulator(world(room()), parameters);
    const Outline outline = parameters.robot.drivenOutline();
    const CollisionMap walls(room().solid(), outline.circumscribedRadius());
    std::mt19937 random(7);
    for (int i = 0; i < 400; ++i) {
      simulator.setCommand(0, {speed, static_cast<double>(random() % 100) - 50.0});
      simulator.step();
      const Vec2 at = simulator.pose(0).position();
      ASSERT_FALSE(walls.overlaps({outline, simulator.pose(0)})) << speed << " m/s";
      ASSERT_TRUE(at.x() > 0.1 && at.x() < 1.9 && at.y() > 0.1 && at.y() < 1.0) << speed << " m/s";
    }
    EXPECT_GT(simulator.contactCount(0), 0);
  }
}

// [SIM-3] the world has an end even where nothing is drawn
TEST(Simulator, StopsAtTheEdgeOfTheWorld_SIM_3) {
  Simulator simulator(world(drawWorld("......\n......\n......\n......\n......\n......", 0.1)), quiet());
  drive(simulator, {0.2, 0.0}, 5.0);
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_NEAR(simulator.pose(0).x, 0.6 - 0.105, 1e-6);
}

// [SIM-2] [SIM-3] what stops a robot is seen by its scanner
TEST(Simulator, SeesTheEdgeOfTheWorldThatStopsIt_SIM_2) {
  Simulator simulator(world(drawWorld("......\n......\n......\n......\n......\n......", 0.1)), quiet());
  while (simulator.newScan(0) == nullptr) simulator.step();
  EXPECT_NEAR(simulator.newScan(0)->ranges[0], 0.25, 1e-6);
  EXPECT_NEAR(simulator.newScan(0)->ranges[180], 0.35, 1e-6);
}

// [SIM-3] robots and obstacles stop each other
TEST(Simulator, StopsAtAnotherRobotAndAtAnObstacle_SIM_3) {
  SimulatorParameters parameters = quiet();
  parameters.robots = {{"a", 0.35, 0.45, 0.0}, {"b", 0.8, 0.45, 0.0}};
  Simulator simulator(world(room()), parameters);
  EXPECT_EQ(simulator.spawnObstacle("box", {1.2, 0.45, 0.0}, 0.1), Placement::kDone);
  drive(simulator, {0.2, 0.0}, 3.0, 0);
  EXPECT_NEAR(simulator.pose(0).x, 0.8 - 0.21, 1e-6);
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_FALSE(simulator.stalled(1)) << "it did not move";
  drive(simulator, {0.2, 0.0}, 3.0, 1);
  EXPECT_NEAR(simulator.pose(1).x, 1.2 - 0.205, 1e-6);
  EXPECT_EQ(simulator.removeObstacle("box"), Placement::kDone);
  drive(simulator, {0.2, 0.0}, 0.5, 1);
  EXPECT_GT(simulator.pose(1).x, 1.0);
}

TEST(Simulator, SaysWhyItRefusesAPlace) {
  SimulatorParameters parameters = quiet();
  parameters.robots = {{"a", 0.35, 0.45, 0.0}, {"b", 0.8, 0.45, 0.0}};
  Simulator simulator(world(room()), parameters);
  EXPECT_EQ(simulator.setPose("c", {}), Placement::kUnknownRobot);
  EXPECT_EQ(simulator.setPose("a", {NAN, 0.0, 0.0}), Placement::kNotFinite);
  EXPECT_EQ(simulator.setPose("a", {1.55, 0.55, 0.0}), Placement::kInWall);
  EXPECT_EQ(simulator.setPose("a", {0.75, 0.45, 0.0}), Placement::kOnRobot);
  EXPECT_EQ(simulator.setPose("a", {1e300, 0.45, 0.0}), Placement::kOutside);
  EXPECT_EQ(simulator.pose(0), Pose2(0.35, 0.45, 0.0));
  EXPECT_EQ(simulator.spawnObstacle("box", {0.4, 0.45, 0.0}, 0.1), Placement::kOnRobot);
  EXPECT_EQ(simulator.spawnObstacle("box", {1.2, 0.45, 0.0}, 0.0), Placement::kBadRadius);
  EXPECT_EQ(simulator.spawnObstacle("box", {1.2, 0.45, 0.0}, INFINITY), Placement::kNotFinite);
  EXPECT_EQ(simulator.spawnObstacle("box", {1.2, 0.45, 0.0}, 0.1), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("box", {1.2, 0.8, 0.0}, 0.1), Placement::kNameTaken);
  EXPECT_EQ(simulator.setPose("a", {1.2, 0.45, 0.0}), Placement::kOnObstacle);
  EXPECT_EQ(simulator.removeObstacle("bag"), Placement::kUnknownObstacle);
}

TEST(Simulator, FLT_1_TakesOnlySoManyObstaclesOfSoMuchSize) {  // [FLT-1]
  Simulator simulator(world(room()), quiet());
  const std::string large(1000000, 'x');
  EXPECT_EQ(simulator.setPose(large, {0.8, 0.45, 0.0}), Placement::kUnknownRobot);
  EXPECT_EQ(simulator.setPose("", {0.8, 0.45, 1e300}), Placement::kDone) << "a turn is a turn";
  EXPECT_LE(std::abs(simulator.pose(0).yaw), kPi);
  EXPECT_EQ(simulator.spawnObstacle(large, {1.2, 0.45, 0.0}, 0.1), Placement::kNameTooLong);
  EXPECT_EQ(simulator.spawnObstacle("box", {1e300, 0.45, 0.0}, 0.1), Placement::kTooFar);
  EXPECT_EQ(simulator.spawnObstacle("box", {1e5, 0.45, 0.0}, 1e300), Placement::kTooLarge);
  EXPECT_EQ(simulator.spawnObstacle("box", {1e5, 0.45, 0.0}, 10.0), Placement::kDone)
      << "outside, where it is not seen";
  int spawned = 1;
  while (spawned < 2000 &&
         simulator.spawnObstacle(std::to_string(spawned), {1.2, 0.45, 0.0}, 0.1) == Placement::kDone) {
    ++spawned;
  }
  EXPECT_EQ(spawned, 1000);
  EXPECT_EQ(simulator.spawnObstacle("more", {1.2, 0.45, 0.0}, 0.1), Placement::kTooMany);
  EXPECT_EQ(simulator.removeObstacle("7"), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("more", {1.2, 0.45, 0.0}, 0.1), Placement::kDone);
}

TEST(Simulator, CarriesARobotWithoutItsOdometryNoticing) {
  Simulator simulator(world(room()), quiet());
  drive(simulator, {0.1, 0.0}, 1.0);
  const Pose2 odometry = simulator.odometry(0);
  EXPECT_EQ(simulator.setPose("", {1.0, 0.8, 2.0}), Placement::kDone);
  EXPECT_EQ(simulator.pose(0), Pose2(1.0, 0.8, 2.0));
  EXPECT_EQ(simulator.odometry(0), odometry);
  simulator.step();
  EXPECT_EQ(simulator.pose(0), Pose2(1.0, 0.8, 2.0)) << "it stands until it is told something new";
}

TEST(Simulator, BringsEveryoneBackUnlessTheStartIsTaken) {
  SimulatorParameters parameters = quiet();
  parameters.robots = {{"a", 0.35, 0.45, 0.5}, {"b", 0.8, 0.45, 0.0}};
  Simulator simulator(world(room()), parameters);
  EXPECT_EQ(simulator.setPose("a", {0.35, 0.8, 0.0}), Placement::kDone);
  EXPECT_EQ(simulator.setPose("b", {0.35, 0.45, 0.0}), Placement::kDone);
  EXPECT_TRUE(simulator.resetPositions().empty());
  EXPECT_EQ(simulator.pose(0), Pose2(0.35, 0.45, 0.5));
  EXPECT_EQ(simulator.odometry(0), Pose2());
  EXPECT_EQ(simulator.setPose("b", {1.2, 0.8, 0.0}), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("box", {0.8, 0.45, 0.0}, 0.05), Placement::kDone);
  EXPECT_EQ(simulator.resetPositions(), std::vector<std::string>{"b"});
}

}  // namespace
}  // namespace frontier_pilot::sim
