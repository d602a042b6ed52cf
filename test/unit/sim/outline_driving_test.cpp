// Robots that are no discs: what their outline bumps into, and how they get away from it. [SIM-3] [ROB-1]

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "waffle.h"

namespace frontier_pilot::sim {
namespace {

const Vec2 kRearLeft(-kWaffleRear, kWaffleHalfWidth);

// [SIM-3] a corner is in the way where a disc never is
TEST(OutlinedRobots, StopTurningWhereTheirRearCornerTouchesAndCanTurnBack_SIM_3) {
  Simulator simulator(world(room()), waffleAt(0.8, 0.827, 0.0));
  drive(simulator, {0.0, -0.5}, 2.0);
  EXPECT_NEAR(simulator.pose(0).yaw, yawOfContact(1.0 - 0.827), 1e-5);
  EXPECT_NEAR((simulator.pose(0) * kRearLeft).y(), 1.0, 2e-6);
  EXPECT_LE((simulator.pose(0) * kRearLeft).y(), 1.0);
  EXPECT_EQ(simulator.pose(0).position(), Vec2(0.8, 0.827));
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_EQ(simulator.contactCount(0), 1);
  EXPECT_NEAR(simulator.odometry(0).yaw, simulator.pose(0).yaw, 1e-9) << "the wheels stood as well";
  EXPECT_NEAR(simulator.velocity(0).angular, 0.0, 1e-3);
  drive(simulator, {0.0, 0.5}, 2.0);
  EXPECT_GT(simulator.pose(0).yaw, 0.7);
  EXPECT_FALSE(simulator.stalled(0));
  EXPECT_EQ(simulator.contactCount(0), 1);
}

// [SIM-3]
TEST(OutlinedRobots, DriveAwayFromWhatTheirCornerTouches_SIM_3) {
  Simulator simulator(world(room()), waffleAt(0.8, 0.827, 0.0));
  drive(simulator, {0.0, -0.5}, 1.0);
  ASSERT_TRUE(simulator.stalled(0));
  drive(simulator, {0.2, 0.0}, 1.0);
  EXPECT_GT(simulator.pose(0).x, 0.95);
  EXPECT_FALSE(simulator.stalled(0));
  EXPECT_EQ(simulator.contactCount(0), 1);
}

// [SIM-3] as a disc does: what is left of the turn is made where it stands
TEST(OutlinedRobots, TurnOnWhereTheirNoseTouchesAsFarAsThatGoes_SIM_3) {
  Simulator simulator(world(room()), waffleAt(0.6, 0.55, 0.0));
  drive(simulator, {-0.2, 0.0}, 3.0);
  EXPECT_NEAR(simulator.pose(0).x, 0.1 + kWaffleRear, 1e-5);
  EXPECT_TRUE(simulator.stalled(0));
  drive(simulator, {-0.2, 0.5}, 1.0);
  EXPECT_NEAR(simulator.pose(0).yaw, 0.0, 1e-4) << "its rear lies flat against the wall";
  drive(simulator, {0.2, 0.0}, 1.0);
  EXPECT_GT(simulator.pose(0).x, 0.45);
  EXPECT_FALSE(simulator.stalled(0));
  EXPECT_EQ(simulator.setPose("", {0.35, 0.35, -0.5 * kPi}), Placement::kDone);
  drive(simulator, {0.2, 0.0}, 2.0);
  EXPECT_NEAR(simulator.pose(0).y, 0.1 + kWaffleFront, 1e-5);
  EXPECT_EQ(simulator.setPose("", {0.6, 0.3, -0.75 * kPi}), Placement::kDone);
  drive(simulator, {0.2, 0.3}, 1.5);
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_GT(simulator.pose(0).yaw, -0.7 * kPi) << "a corner in front touches, and goes on touching while it turns";
}

// [SIM-3] [ROB-1]
TEST(OutlinedRobots, DriveThroughALaneAsWideAsTheyAre_SIM_3) {
  const AsciiWorld lane = drawWorld(R"(
      ########################
      #.......########.......#
      #.......########.......#
      #......................#
      #......................#
      #......................#
      #......................#
      #.......########.......#
      #.......########.......#
      ########################)",
                                    0.08);
  SimulatorParameters parameters = waffleAt(0.4, 0.4, 0.0);
  Simulator simulator(world(lane), parameters);
  drive(simulator, {0.2, 0.0}, 5.5);
  EXPECT_GT(simulator.pose(0).x, 1.4);
  EXPECT_EQ(simulator.contactCount(0), 0);
  EXPECT_EQ(simulator.setPose("", {0.96, 0.4, kPi}), Placement::kDone) << "backwards it fits as well";
  EXPECT_EQ(simulator.setPose("", {0.96, 0.4, 0.2}), Placement::kInWall);
  parameters.robot.outline.clear();
  parameters.robot.disc_radius = waffleRadius();
  Simulator round(world(lane), parameters);
  drive(round, {0.2, 0.0}, 5.5);
  EXPECT_LT(round.pose(0).x, 0.7) << "the disc around it does not fit";
}

// [SIM-3]
TEST(OutlinedRobots, StopAtObstaclesWithTheSideThatMeetsThem_SIM_3) {
  Simulator simulator(world(room()), waffleAt(0.5, 0.5, 0.0));
  EXPECT_EQ(simulator.spawnObstacle("beside", {0.8, 0.5 + kWaffleHalfWidth + 0.101, 0.0}, 0.1), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("ahead", {1.2, 0.6, 0.0}, 0.1), Placement::kDone);
  drive(simulator, {0.2, 0.0}, 4.0);
  EXPECT_NEAR(simulator.pose(0).x, 1.1 - kWaffleFront, 1e-5) << "past the one, up to the other";
  EXPECT_LE(simulator.pose(0).x, 1.1 - kWaffleFront);
  EXPECT_EQ(simulator.contactCount(0), 1);
  EXPECT_EQ(simulator.removeObstacle("ahead"), Placement::kDone);
  drive(simulator, {0.2, 0.0}, 0.5);
  EXPECT_GT(simulator.pose(0).x, 1.1);
  EXPECT_FALSE(simulator.stalled(0));
}

// [SIM-3]
TEST(OutlinedRobots, StopTurningAtAnObstacle_SIM_3) {
  Simulator simulator(world(room()), waffleAt(0.8, 0.5, 0.0));
  EXPECT_EQ(simulator.spawnObstacle("post", {0.65, 0.5 + kWaffleHalfWidth + 0.03, 0.0}, 0.02), Placement::kDone);
  drive(simulator, {0.0, -0.5}, 2.0);
  EXPECT_TRUE(simulator.stalled(0));
  EXPECT_LT(simulator.pose(0).yaw, -0.02);
  EXPECT_GT(simulator.pose(0).yaw, -0.2);
  EXPECT_EQ(simulator.contactCount(0), 1);
}

// [SIM-2] [SIM-3]
TEST(OutlinedRobots, TouchEachOthersOutlinesAndSeeTheDiscAroundThem_SIM_2_SIM_3) {
  SimulatorParameters parameters = waffleAt(0.4, 0.5, 0.0);
  parameters.robots = {{"a", 0.4, 0.5, 0.0}, {"b", 1.0, 0.5, 0.0}};
  Simulator simulator(world(room()), parameters);
  while (simulator.newScan(0) == nullptr) simulator.step();
  EXPECT_NEAR(simulator.newScan(0)->ranges[0], 0.6 - waffleRadius(), 1e-6);
  drive(simulator, {0.2, 0.0}, 3.0, 0);
  const double nearest = 1.0 - kWaffleFront - kWaffleRear;
  EXPECT_NEAR(simulator.pose(0).x, nearest, 1e-5);
  EXPECT_TRUE(simulator.stalled(0));
  drive(simulator, {0.0, 1.0}, 1.0, 1);
  EXPECT_TRUE(simulator.stalled(1)) << "its corners swing out";
  EXPECT_EQ(simulator.setPose("a", {nearest + 0.01, 0.5, 0.0}), Placement::kOnRobot);
  EXPECT_EQ(simulator.setPose("a", {nearest - 0.01, 0.5, 0.0}), Placement::kDone);
}

// [SIM-2] With the scanner within the disc around the other robot.
TEST(OutlinedRobots, AreSeenAlsoFromVeryNear_SIM_2) {
  SimulatorParameters parameters = waffleAt(0.4, 0.5, 0.0);
  parameters.robots = {{"a", 0.4, 0.5, 0.0}, {"b", 0.6, 0.5, kPi}};
  Simulator simulator(world(room()), parameters);
  while (simulator.newScan(0) == nullptr) simulator.step();
  EXPECT_NEAR(simulator.newScan(0)->ranges[0], 0.2 - kWaffleFront, 1e-6);
}

// How deep the outline and the solid cells reach into each other at most [m]: points of the outline in the cells, and
// corners and centres of the cells in the outline.
double depth(const Outline& outline, const Pose2& pose, const Grid<std::uint8_t>& solid) {
  const GridGeometry& geometry = solid.geometry();
  const double half = 0.5 * geometry.resolution;
  double deepest = 0.0;
  const std::vector<Vec2>& corners = outline.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < 100; ++k) {
      const Vec2 point = pose * (corners[i] + k / 100.0 * (corners[(i + 1) % corners.size()] - corners[i]));
      const Cell cell = geometry.cellAt(point);
      if (solid.get(cell, 1) == 0) continue;
      deepest = std::max(deepest, half - (point - geometry.centre(cell)).cwiseAbs().maxCoeff());
    }
  }
  for (std::size_t i = 0; i < solid.size(); ++i) {
    const Vec2 centre = geometry.centre(geometry.cell(i));
    if (solid[i] == 0 || (centre - pose.position()).norm() > 1.0) continue;
    for (const Vec2& off : {Vec2(0, 0), Vec2(half, half), Vec2(half, -half), Vec2(-half, half), Vec2(-half, -half)}) {
      deepest = std::max(deepest, -outline.distance(pose.inverse() * (centre + off)));
    }
  }
  return deepest;
}

// [SIM-3] whatever it does, at any speed and in either direction
void driveAtRandom(const std::vector<double>& corners, double speed, unsigned seed) {
  SimulatorParameters parameters = waffleAt(0.6, 0.6, 0.3);
  parameters.robot.outline = corners;
  parameters.robot.limits = {1e3, 1e3, 1e6, 1e6};
  const AsciiWorld drawing = room();
  Simulator simulator(world(drawing), parameters);
  const Outline outline = parameters.robot.drivenOutline();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const int hold = 10 + static_cast<int>(30.0 / speed);  // [steps], long enough to get somewhere
  Twist2 command;
  int moves = 0;
  int stalls = 0;
  for (int i = 0; i < 1500; ++i) {
    if (i % hold == 0) command = {i % (3 * hold) == 0 ? 0.0 : speed * share(random), 5.0 * speed * share(random)};
    const Pose2 before = simulator.pose(0);
    simulator.setCommand(0, command);
    simulator.step();
    moves += simulator.pose(0) == before ? 0 : 1;
    stalls += simulator.stalled(0) ? 1 : 0;
    ASSERT_LT(depth(outline, simulator.pose(0), drawing.solid()), 1e-9) << speed << " m/s, step " << i;
  }
  EXPECT_GT(simulator.contactCount(0), 0) << speed;
  EXPECT_GT(stalls, 100) << speed;
  EXPECT_GT(moves, 100) << speed << " m/s: it must not be safe by standing";
}

TEST(OutlinedRobots, NeverReachIntoAWall_SIM_3) {
  const std::vector<double> waffle = waffleAt(0, 0, 0).robot.outline;
  const std::vector<double> hook = {0.2, 0.05, 0.05, 0.05, 0.05, 0.2, -0.1, 0.2, -0.1, -0.1, 0.2, -0.1};
  for (const double speed : {0.3, 2.0, 20.0}) {
    driveAtRandom(waffle, speed, 5);
    driveAtRandom(hook, speed, 6);
  }
}

// [SIM-1]
TEST(OutlinedRobots, ArePlacedWhereTheirOutlineFitsAtThatYaw_SIM_1) {
  Simulator simulator(world(room()), waffleAt(0.8, 0.5, 0.0));
  EXPECT_EQ(simulator.setPose("", {0.32, 0.26, 0.0}), Placement::kDone) << "less than the disc around it has room";
  EXPECT_EQ(simulator.setPose("", {0.32, 0.26, kPi}), Placement::kDone);
  EXPECT_EQ(simulator.setPose("", {0.32, 0.26, 0.5 * kPi}), Placement::kInWall);
  EXPECT_EQ(simulator.setPose("", {0.2, 0.26, kPi}), Placement::kDone);
  EXPECT_EQ(simulator.setPose("", {0.2, 0.26, 0.0}), Placement::kInWall);
  EXPECT_EQ(simulator.setPose("", {0.8, 0.5, 0.0}), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("behind", {0.62, 0.5, 0.0}, 0.04), Placement::kOnRobot);
  EXPECT_EQ(simulator.spawnObstacle("ahead", {0.98, 0.5, 0.0}, 0.04), Placement::kDone);
  EXPECT_EQ(simulator.setPose("", {0.8, 0.5, kPi}), Placement::kOnObstacle);
}

// [SIM-1]
TEST(OutlinedRobots, AreToldANearestFreePlaceForTheYawTheyAskedFor_SIM_1) {
  const auto refusal = [](double x, double yaw) -> std::string {
    try {
      const Simulator simulator(world(room()), waffleAt(x, 0.55, yaw));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(0.21, kPi), "") << "its back is not to the wall";
  EXPECT_EQ(refusal(0.21, 0.0),
            "the robot cannot start at (0.21, 0.55): the place is in or too near to a wall; the nearest free place is "
            "(0.35, 0.55)");
  EXPECT_EQ(refusal(0.15, kPi),
            "the robot cannot start at (0.15, 0.55): the place is in or too near to a wall; the nearest free place is "
            "(0.25, 0.55)");
}

// [SIM-1]
TEST(OutlinedRobots, StayWhereTheirStartIsTakenByAnObstacle_SIM_1) {
  Simulator simulator(world(room()), waffleAt(0.8, 0.5, 0.0));
  EXPECT_EQ(simulator.setPose("", {1.0, 0.5, kPi}), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("ahead", {0.8 + kWaffleFront + 0.02, 0.8, 0.0}, 0.01), Placement::kDone);
  EXPECT_TRUE(simulator.resetPositions().empty());
  EXPECT_EQ(simulator.setPose("", {1.0, 0.5, kPi}), Placement::kDone);
  EXPECT_EQ(simulator.spawnObstacle("behind", {0.62, 0.5, 0.0}, 0.01), Placement::kDone);
  EXPECT_EQ(simulator.resetPositions().size(), 1U);
}

}  // namespace
}  // namespace frontier_pilot::sim
