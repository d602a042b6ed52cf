// What the simulator takes from the description of the robot.

#include <gtest/gtest.h>

#include "simulated_room.h"

namespace frontier_pilot::sim {
namespace {

// [ROB-1] one description; the names of an earlier version are answered with the new ones
TEST(SimulatorParameters, NameTheNewParameterForEachOldOne_ROB_1) {
  SimulatorParameters parameters;
  EXPECT_EQ(
      loadParameters(parseYaml("{radius: 0.2, command_timeout: 1.0, lidar: {rate: 5.0, beams: 90, angle_min: 0.0, "
                               "field_of_view: 1.0, range_min: 0.1, range_max: 3.5, mount_x: 0.1, mount_y: 0.1, "
                               "mount_yaw: 0.1, noise_stddev: 0.02}}"),
                     parameters),
      (Problems{"lidar/rate: is called robot/scanner/rate now", "lidar/beams: is called robot/scanner/beams now",
                "lidar/angle_min: is called robot/scanner/angle_min now",
                "lidar/field_of_view: is called robot/scanner/field_of_view now",
                "lidar/range_min: is called robot/scanner/range_min now",
                "lidar/range_max: is called robot/scanner/range_max now",
                "lidar/mount_x: is called robot/scanner/x now", "lidar/mount_y: is called robot/scanner/y now",
                "lidar/mount_yaw: is called robot/scanner/yaw now", "radius: is called robot/disc_radius now",
                "command_timeout: is called robot/watchdog now"}));
  EXPECT_EQ(parameters.lidar.noise_stddev, 0.02);
}

// [ROB-1]
TEST(SimulatorParameters, ReadTheRobotAndLimitsThatOverrideIt_ROB_1) {
  SimulatorParameters parameters;
  EXPECT_TRUE(loadParameters(parseYaml("{limits: {max_linear: 0.5}, robot: {disc_radius: 0.2, watchdog: 0.3, "
                                       "limits: {max_linear: 0.1}, scanner: {range_max: 3.5}}}"),
                             parameters)
                  .empty());
  EXPECT_EQ(parameters.robot.limits.max_linear, 0.5);
  EXPECT_EQ(parameters.robot.disc_radius, 0.2);
  EXPECT_EQ(parameters.robot.watchdog, 0.3);
  EXPECT_EQ(parameters.robot.scanner.range_max, 3.5);
}

// [SIM-1] [ROB-1]
TEST(Simulator, StopsWhenTheRobotsWatchdogSays_SIM_1) {
  SimulatorParameters parameters = quiet();
  parameters.robot.watchdog = 0.2;
  Simulator simulator(world(room()), parameters);
  simulator.setCommand(0, {0.2, 0.0});
  for (int i = 0; i < 20; ++i) simulator.step();
  EXPECT_NEAR(simulator.velocity(0).linear, 0.2, 1e-12);
  for (int i = 0; i < 20; ++i) simulator.step();
  EXPECT_TRUE(simulator.velocity(0).isZero());
}

// [SIM-2] [ROB-1]
TEST(Simulator, MeasuresFromWhereTheScannerSits_SIM_2) {
  SimulatorParameters parameters = quiet();
  parameters.robot.scanner.x = 0.1;
  parameters.robot.scanner.y = 0.05;
  parameters.robot.scanner.yaw = 0.5 * kPi;
  parameters.robot.scanner.range_max = 1.0;
  Simulator simulator(world(room()), parameters);
  while (simulator.newScan(0) == nullptr) simulator.step();
  const LaserScan2& scan = *simulator.newScan(0);
  EXPECT_NEAR(scan.ranges[0], 0.5, 1e-6) << "looks to the left, from 5 cm on that side";
  EXPECT_NEAR(scan.ranges[90], 0.35, 1e-6) << "the wall behind";
  EXPECT_NEAR(scan.ranges[270], 0.95, 1e-6) << "the pillar ahead";
  EXPECT_EQ(scan.T_base_sensor, Pose2(0.1, 0.05, 0.5 * kPi));
}

}  // namespace
}  // namespace frontier_pilot::sim
