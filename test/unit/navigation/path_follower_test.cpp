#include "navigation/path_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot {
namespace {

RobotLimits fast() {
  RobotLimits limits;
  limits.max_linear = 0.5;
  limits.max_angular = 1.5;
  return limits;
}

RobotModel fastRobot() {
  RobotModel robot;
  robot.limits = fast();
  return robot;
}

/// Two posts whose corners are 0.224 m apart.
OccupancyGrid posts() {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 60, 60}, kFree);
  map[Cell{28, 31}] = kOccupied;
  map[Cell{33, 28}] = kOccupied;
  return map;
}

// [NAV-4] One post beside the scanner, too near to be measured, must not let the robot come as near to the other.
TEST(PathFollower, KeepsItsDistanceFromBothSidesOfAPassageThatIsTooNarrow_NAV_4) {
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(posts().geometry(), kFree), {0, 0, 60, 60});
  open.refresh();
  const Vec2 left(1.45, 1.55);  // corners of the posts
  const Vec2 right(1.65, 1.45);
  const Vec2 along = Vec2(1.0, 2.0).normalized();
  const Vec2 aside = Vec2(2.0, -1.0).normalized();
  for (int i = 0; i < 21; ++i) {
    const double off = 0.001 * (i - 10);  // as the map may be
    const Vec2 start = 0.5 * (left + right) - 0.1 * along + off * aside;
    sim::SimulatorParameters parameters;
    parameters.seed = i + 1;
    parameters.x = start.x();
    parameters.y = start.y();
    parameters.yaw = bearing(along);
    parameters.robot.limits = fast();
    sim::Simulator simulator(sim::World{posts(), Pose2(start, parameters.yaw)}, parameters);
    navigation::PathFollower follower({}, fastRobot());
    follower.setPath(planning::Path({start, start + 1.2 * along}));
    std::optional<navigation::ScanPoints> scan;
    double nearest = 1.0;
    for (int step = 0; step < 6000; ++step) {
      simulator.step();
      const Vec2 position = simulator.pose(0).position();
      nearest = std::min({nearest, (position - left).norm(), (position - right).norm()});
      if (const LaserScan2* fresh = simulator.newScan(0))
        scan = navigation::scanPoints(*fresh, simulator.pose(0), Outline::disc(0.105));
      if (!scan || step % 5 != 0) continue;
      const navigation::FollowerInputs inputs{simulator.pose(0), simulator.velocity(0), 0.05, *scan, open};
      simulator.setCommand(0, follower.update(inputs).command);
    }
    EXPECT_EQ(simulator.contactCount(0), 0) << "on a path " << off << " m off the middle";
    EXPECT_GT(nearest, 0.105 + 0.003) << "on a path " << off << " m off the middle";
  }
}

TEST(PathFollower, IsFreeToLeaveWhatItIsTooNearTo_NAV_4) {
  // Somewhere on a large map, where a float is coarse: straight behind the robot something touches its edge.
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 800, 800}, kFree), {0, 0, 800, 800});
  open.refresh();
  for (int i = 0; i < 50; ++i) {
    const Vec2 position(30.0 + 0.0137 * i, 30.0 + 0.0071 * i);
    navigation::ScanPoints scan;
    scan.add(position - Vec2(0.105, 0.0));
    navigation::PathFollower follower({}, fastRobot());
    follower.setPath(planning::Path({position, position + Vec2(1.0, 0.0)}));
    const navigation::FollowerOutput output = follower.update({Pose2(position, 0.0), {}, 0.05, scan, open});
    EXPECT_FALSE(output.blocked) << i;
    EXPECT_GT(output.command.linear, 0.1) << i;
  }
}

// [FLT-1] A navigator that dies leaves its last command in force until the arbiter's timeout.
TEST(PathFollower, TouchesNothingIfAnyOfItsCommandsIsTheLast_FLT_1) {
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(posts().geometry(), kFree), {0, 0, 60, 60});
  open.refresh();
  OccupancyGrid walls(posts().geometry(), kFree);  // a passage that ends, with the path round its corner
  for (int i = 10; i < 50; ++i) walls[Cell{i, 40}] = walls[Cell{40, i}] = kOccupied;
  for (int i = 10; i < 29; ++i) walls[Cell{i, 28}] = walls[Cell{28, i}] = kOccupied;
  sim::SimulatorParameters parameters;
  parameters.x = 0.8;
  parameters.y = 1.72;
  parameters.robot.limits = fast();
  sim::Simulator simulator(sim::World{walls, Pose2(parameters.x, parameters.y, 0.0)}, parameters);
  navigation::PathFollower follower({}, fastRobot());
  follower.setPath(planning::Path({Vec2(0.8, 1.72), Vec2(1.72, 1.72), Vec2(1.72, 0.8)}));
  std::optional<navigation::ScanPoints> scan;
  const auto touches = [&](const Vec2& position) {
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {
        const Vec2 off = (walls.geometry().centre({x, y}) - position).cwiseAbs() - Vec2(0.025, 0.025);
        if (isOccupied(walls[Cell{x, y}]) && off.cwiseMax(0.0).norm() < 0.105) return true;
      }
    }
    return false;
  };
  int moving = 0;
  for (int step = 0; step < 1500; ++step) {
    simulator.step();
    if (const LaserScan2* fresh = simulator.newScan(0))
      scan = navigation::scanPoints(*fresh, simulator.pose(0), Outline::disc(0.105));
    if (!scan || step % 10 != 0) continue;
    const navigation::FollowerInputs inputs{simulator.pose(0), simulator.velocity(0), 0.05, *scan, open};
    const Twist2 command = follower.update(inputs).command;
    simulator.setCommand(0, command);
    if (command.linear > 0.0) ++moving;
    Pose2 pose = simulator.pose(0);
    Twist2 twist = simulator.velocity(0);
    for (double t = 0.0; t < 1.0 || !twist.isZero(); t += 0.02) {
      twist = limitAcceleration(t < 1.0 ? command : Twist2{}, twist, fast(), 0.02);
      pose = integrate(pose, twist, 0.02);
      ASSERT_FALSE(touches(pose.position())) << "by the command (" << command.linear << ", " << command.angular
                                             << ") at " << simulator.pose(0).position().transpose();
    }
  }
  EXPECT_GT(moving, 10);
  EXPECT_LT((simulator.pose(0).position() - Vec2(1.72, 0.8)).norm(), 0.2) << "it arrives all the same";
}

TEST(PathFollower, LooksAsFarAsTheRobotGoesOnByItsLastCommand_FLT_1) {
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 200, 200}, kFree), {0, 0, 200, 200});
  open.refresh();
  navigation::FollowerParams patient;
  patient.command_lifetime = 3.0;  // 1.5 m, and 0.05 m until it stands
  const auto commandBefore = [&](double distance) {
    navigation::ScanPoints wall;
    for (int i = -20; i <= 20; ++i) wall.add(Vec2(3.0 + distance, 5.0 + 0.05 * i));
    navigation::PathFollower follower(patient, fastRobot());
    follower.setPath(planning::Path({Vec2(3.0, 5.0), Vec2(8.0, 5.0)}));
    return follower.update({Pose2(3.0, 5.0, 0.0), Twist2{0.5, 0.0}, 0.05, wall, open}).command.linear;
  };
  EXPECT_EQ(commandBefore(2.0), 0.5);
  EXPECT_LT(commandBefore(1.4), 0.45);
}

// [MUL-3] Where it is now another robot is out of the way, but both would be at the crossing at the same time.
TEST(PathFollower, BrakesForARobotThatIsGoingToCrossItsWay_MUL_3) {
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 200, 200}, kFree), {0, 0, 200, 200});
  open.refresh();
  const Pose2 start(3.0, 5.0, 0.0);
  const Twist2 driving{0.5, 0.0};
  const navigation::ScanPoints nothing;
  const auto commandBeside = [&](const Vec2& from, const Vec2& velocity) {
    navigation::PathFollower follower({}, fastRobot());
    follower.setPath(planning::Path({start.position(), start.position() + Vec2(3.0, 0.0)}));
    const navigation::Neighbours others{{{from, velocity, 0.105}}, {}};
    return follower.update({start, driving, 0.05, nothing, open, others}).command;
  };
  EXPECT_EQ(commandBeside({3.3, 4.7}, {0.0, 0.0}), driving) << "stands beside the way";
  EXPECT_EQ(commandBeside({3.3, 4.7}, {0.5, 0.0}), driving) << "drives along beside it";
  EXPECT_EQ(commandBeside({3.3, 4.7}, {0.0, -0.5}), driving) << "drives away";
  EXPECT_LT(commandBeside({3.3, 4.7}, {0.0, 0.5}).linear, 0.1) << "would be touched in less than a second";
}

// [MUL-3] It could brake before the other one, but not if that one comes as fast.
TEST(PathFollower, BrakesOnItsSideOfTheMiddleBetweenItselfAndARobotThatItSees_MUL_3) {
  planning::ClearanceMap open;
  open.setMap(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 200, 200}, kFree), {0, 0, 200, 200});
  open.refresh();
  navigation::FollowerParams params;
  params.command_lifetime = 0.1;
  const auto commandBefore = [&](const Vec2& other) {
    navigation::ScanPoints nothing;
    navigation::PathFollower follower(params, fastRobot());
    follower.setPath(planning::Path({Vec2(3.0, 5.0), Vec2(8.0, 5.0)}));
    const Vec2 nearest = other - 0.105 * (other - Vec2(3.0, 5.0)).normalized();
    const navigation::Neighbours neighbours{{}, {{{other, Vec2::Zero(), 0.105}, nearest}}};
    return follower.update({Pose2(3.0, 5.0, 0.0), Twist2{0.5, 0.0}, 0.05, nothing, open, neighbours}).command.linear;
  };
  // It drives on for 0.15 m until it brakes, and then for 0.05 m: twice that to the middle, and both radii.
  EXPECT_EQ(commandBefore({3.0 + 1.0, 5.0}), 0.5);
  EXPECT_LT(commandBefore({3.0 + 0.55, 5.0}), 0.4);
  EXPECT_LT(commandBefore({3.0 + 0.35, 5.0}), 0.2);
  EXPECT_EQ(commandBefore({3.0, 5.4}), 0.5) << "beside it";
}

}  // namespace
}  // namespace frontier_pilot
