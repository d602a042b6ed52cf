// Robots of different kinds in one world.

#include <gtest/gtest.h>

#include "waffle.h"

namespace frontier_pilot::sim {
namespace {

// A small robot ahead of the start of a Waffle, in a room without a pillar.
SimulatorParameters smallOneAndWaffle() {
  SimulatorParameters parameters = quiet();
  parameters.kinds = {{"waffle", test::shippedRobot("waffle")}};
  parameters.robots = {{"small", 1.3, 0.75, 0.0}, {"large", 0.5, 0.75, 0.0, "waffle"}};
  return parameters;
}

World emptyRoom() { return {OccupancyGrid(GridGeometry{0.1, Vec2::Zero(), 20, 15}, kFree), std::nullopt}; }

// [SIM-1] [ROB-1]
TEST(RobotKinds, ObeyTheirOwnLimits_SIM_1) {
  SimulatorParameters parameters = smallOneAndWaffle();
  parameters.robot.limits.max_linear = 0.1;
  Simulator simulator(emptyRoom(), parameters);
  for (int i = 0; i < 50; ++i) {
    simulator.setCommand(0, {0.3, 0.0});
    simulator.setCommand(1, {0.3, 0.0});
    simulator.step();
  }
  EXPECT_NEAR(simulator.velocity(0).linear, 0.1, 1e-9);
  EXPECT_NEAR(simulator.velocity(1).linear, 0.26, 1e-9);
  EXPECT_EQ(simulator.model(0).limits.max_linear, 0.1);
  EXPECT_EQ(simulator.model(1).limits.max_linear, 0.26);
}

// [SIM-2] [SCN-1] the small one's scanner measures all at once, ten times a second; the Waffle's turns five times
TEST(RobotKinds, ScanWithTheirOwnScannersAtTheirOwnTimes_SIM_2) {
  Simulator simulator(emptyRoom(), smallOneAndWaffle());
  int small = 0;
  int large = 0;
  while (simulator.now() < Time{} + std::chrono::seconds(2)) {
    simulator.step();
    if (const LaserScan2* scan = simulator.newScan(0)) {
      ++small;
      EXPECT_EQ(scan->stamp, simulator.now());
      EXPECT_EQ(scan->range_max, 8.0F);
    }
    if (const LaserScan2* scan = simulator.newScan(1)) {
      ++large;
      EXPECT_LT(scan->stamp, simulator.now());
      EXPECT_EQ(scan->range_max, 3.5F);
    }
  }
  EXPECT_EQ(small, 20);
  EXPECT_EQ(large, 10);
}

// [SIM-3] each is stopped by the outlines of both
TEST(RobotKinds, CollideWithTheirOwnOutlines_SIM_3) {
  Simulator simulator(emptyRoom(), smallOneAndWaffle());
  drive(simulator, {0.2, 0.0}, 5.0, 1);
  EXPECT_TRUE(simulator.stalled(1));
  EXPECT_NEAR(simulator.pose(0).x - simulator.pose(1).x, kWaffleFront + 0.105, 1e-5);
  drive(simulator, {0.2, 0.0}, 5.0, 0);
  EXPECT_NEAR(simulator.pose(0).x, 2.0 - 0.105, 1e-5);
  drive(simulator, {0.26, 0.0}, 7.0, 1);
  drive(simulator, {-0.26, 0.0}, 10.0, 1);
  EXPECT_NEAR(simulator.pose(1).x, kWaffleRear, 1e-5);
}

// [SIM-2] [SIM-3] and each is seen in its own size
TEST(RobotKinds, SeeEachOtherInTheirSizes_SIM_2) {
  SimulatorParameters parameters = smallOneAndWaffle();
  parameters.kinds[0].robot.scanner = parameters.robot.scanner;
  Simulator simulator(emptyRoom(), parameters);
  while (simulator.newScan(0) == nullptr) simulator.step();
  EXPECT_NEAR(simulator.newScan(0)->ranges[180], 0.8 - waffleRadius(), 1e-5);
  EXPECT_NEAR(simulator.newScan(1)->ranges[0], 0.8 - 0.105, 1e-5);
}

// [SIM-1] a place that a small robot takes may be too narrow for a large one
TEST(RobotKinds, StartWhereTheyFit_SIM_1) {
  SimulatorParameters parameters = smallOneAndWaffle();
  parameters.robots = {{"small", 0.15, 0.75, 0.0}, {"large", 1.0, 0.75, 0.0, "waffle"}};
  EXPECT_NO_THROW(Simulator(emptyRoom(), parameters));
  parameters.robots[0].robot = "waffle";
  EXPECT_THROW(Simulator(emptyRoom(), parameters), std::runtime_error);
}

// [ROB-1]
TEST(RobotKinds, MustBeKnownByName_ROB_1) {
  SimulatorParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("{kinds: [{name: a}, {name: a}, {name: ''}], robots: [{name: r, robot: b}]}"),
                           parameters),
            (Problems{"kinds: two are named 'a'", "kinds: each must have a name",
                      "robots: 'r' is to be a 'b', which is none of the kinds"}));
  SimulatorParameters alike;
  EXPECT_EQ(loadParameters(parseYaml("{robots: [{name: a}, {name: /a}]}"), alike),
            Problems{"robots: '/a' is no name of a namespace"});
  SimulatorParameters bad_kind;
  EXPECT_EQ(loadParameters(parseYaml("{kinds: [{name: a, robot: {watchdog: -1.0}}]}"), bad_kind),
            (Problems{"kinds[0]/robot/watchdog: must be > 0 and <= 1e+06, is -1"}));
  SimulatorParameters unchecked = smallOneAndWaffle();
  unchecked.kinds.clear();
  EXPECT_THROW(Simulator(emptyRoom(), unchecked), std::runtime_error);
}

// [ROB-1] limits that override the robot's, as for a single robot
TEST(RobotKinds, AreDescribedLikeTheRobotOfANode_ROB_1) {
  SimulatorParameters parameters;
  EXPECT_EQ(loadParameters(
                parseYaml("{kinds: [{name: a, robot: {disc_radius: 0.2, limits: {max_linear: 0.1, max_angular: 1.0}}, "
                          "limits: {max_linear: 0.5}}]}"),
                parameters),
            Problems{});
  ASSERT_EQ(parameters.kinds.size(), 1U);
  EXPECT_EQ(parameters.kinds[0].robot.disc_radius, 0.2);
  EXPECT_EQ(parameters.kinds[0].robot.limits.max_linear, 0.5);
  EXPECT_EQ(parameters.kinds[0].robot.limits.max_angular, 1.0);
}

}  // namespace
}  // namespace frontier_pilot::sim
