#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/solid_cells.h"
#include "simulated_room.h"

namespace frontier_pilot::sim {
namespace {

SimulatorParameters rolling(double rate = 5.0) {
  SimulatorParameters parameters = quiet();
  parameters.robot.scanner.rolling = true;
  parameters.robot.scanner.rate = rate;
  return parameters;
}

/// What the last scan of a drive was, and the poses meanwhile.
struct Drive {
  LaserScan2 scan;
  PoseTrack truth;
  int scans = 0;
};

Drive driven(const SimulatorParameters& parameters, const Twist2& twist, double seconds) {
  Simulator simulator(world(room()), parameters);
  Drive drive;
  drive.truth.add(simulator.now(), simulator.pose(0));
  while (toSeconds(simulator.now()) < seconds - 1e-9) {
    simulator.setCommand(0, twist);
    simulator.step();
    drive.truth.add(simulator.now(), simulator.pose(0));
    if (simulator.newScan(0) == nullptr) continue;
    drive.scan = *simulator.newScan(0);
    ++drive.scans;
  }
  return drive;
}

/// The greatest difference of a range from the true one, as seen from where the beam is said to have been measured.
double worstError(const LaserScan2& scan, const Pose2& T_world_base) {
  const grids::RayCaster walls(solidCells(room().map, false));
  double worst = 0.0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const Pose2 T_world_sensor = T_world_base * scan.mount(beam);
    const double range = walls.cast(T_world_sensor.position(), T_world_sensor.yaw + scan.angle(beam), scan.range_max);
    const RangeReading reading = readBeam(scan, beam);
    if (reading.kind == RangeKind::kHit) worst = std::max(worst, std::abs(reading.distance - range));
  }
  return worst;
}

// [SCN-1]
TEST(RollingLidar, OfARobotThatStandsMeasuresWhatOneDoesThatMeasuresAtOnce_SCN_1) {
  SimulatorParameters at_once = rolling();
  at_once.robot.scanner.rolling = false;
  const Drive a = driven(rolling(), {}, 1.0);
  const Drive b = driven(at_once, {}, 1.0);
  EXPECT_EQ(a.scans, b.scans);
  ASSERT_EQ(a.scan.ranges.size(), b.scan.ranges.size());
  for (std::size_t i = 0; i < a.scan.ranges.size(); ++i) {
    EXPECT_TRUE(a.scan.ranges[i] == b.scan.ranges[i] || std::abs(a.scan.ranges[i] - b.scan.ranges[i]) < 1e-4F) << i;
  }
}

// [SCN-1]
TEST(RollingLidar, GivesTheTimesAsDriversDo_SCN_1) {
  const Drive drive = driven(rolling(), {}, 1.0);
  EXPECT_EQ(drive.scans, 5);
  EXPECT_EQ(drive.scan.stamp, timeFromSeconds(0.8)) << "the time of the first beam";
  EXPECT_NEAR(drive.scan.time_increment * 360, 0.2, 1e-9);
  EXPECT_EQ(driven(rolling(5.5), {}, 2.0).scans, 11) << "a period that is no multiple of the step";
  EXPECT_EQ(driven(rolling(100.0), {}, 1.0).scans, 100) << "or a single step";
}

// [SCN-1]
TEST(RollingLidar, SeesEachBeamFromWhereTheRobotIsAtThatTime_SCN_1) {
  for (const double rate : {5.0, 5.5, 13.7}) {
    Drive drive = driven(rolling(rate), {0.1, 2.8}, 2.0);
    const Pose2 at_first = drive.truth.nearest(drive.scan.stamp).value();
    EXPECT_GT(worstError(drive.scan, at_first), 0.1) << "as if it were measured at once";
    placeBeams(drive.truth, ScanReference::kEnd, drive.scan);
    // A beam that grazes the edge of the pillar may meet it or not.
    EXPECT_LT(worstError(drive.scan, drive.truth.nearest(drive.scan.stamp).value()), 0.01) << rate;
  }
}

// [SCN-1]
TEST(RollingLidar, MeasuresTheLastBeamFirstIfTheRobotsScannerDoes_SCN_1) {
  SimulatorParameters parameters = rolling();
  parameters.robot.scanner.reversed = true;
  Drive drive = driven(parameters, {0.1, 2.8}, 2.0);
  LaserScan2 forwards = drive.scan;
  forwards.reversed = false;
  placeBeams(drive.truth, ScanReference::kEnd, forwards);
  EXPECT_GT(worstError(forwards, drive.truth.nearest(forwards.stamp).value()), 0.1) << "in the wrong order";
  placeBeams(drive.truth, ScanReference::kEnd, drive.scan);
  EXPECT_LT(worstError(drive.scan, drive.truth.nearest(drive.scan.stamp).value()), 0.01);
}

// [SCN-1] [SIM-2]
TEST(RollingLidar, SeesObstaclesAndOtherRobotsButNotItself_SCN_1) {
  SimulatorParameters parameters = rolling();
  parameters.robots = {{"a", 0.35, 0.45, 0.0}, {"b", 0.35, 0.85, 0.0}};
  Simulator simulator(world(room()), parameters);
  ASSERT_EQ(simulator.spawnObstacle("can", {1.0, 0.45, 0.0}, 0.1), Placement::kDone);
  for (int i = 0; i < 20; ++i) simulator.step();
  ASSERT_NE(simulator.newScan(0), nullptr);
  const LaserScan2& scan = *simulator.newScan(0);
  EXPECT_NEAR(scan.ranges[0], 0.55, 1e-5);
  EXPECT_NEAR(scan.ranges[90], 0.4 - 0.105, 1e-5);
  EXPECT_NEAR(scan.ranges[180], 0.25, 1e-5) << "the wall behind it";
}

// [SCN-1] [SIM-2]
TEST(RollingLidar, GivesTheSameBytesForTheSameSeed_SCN_1) {
  SimulatorParameters parameters = rolling();
  parameters.lidar.noise_stddev = 0.01;
  const auto bytes = [&] { return driven(parameters, {0.1, 1.0}, 2.0).scan.ranges; };
  const std::vector<float> first = bytes();
  const std::vector<float> again = bytes();
  ASSERT_EQ(first.size(), again.size());
  EXPECT_EQ(std::memcmp(first.data(), again.data(), first.size() * sizeof(float)), 0);
}

// [SCN-1]
TEST(RollingLidar, IsSwitchedByTheRobotsDescriptionAndByTheSimulator_SCN_1) {
  SimulatorParameters parameters;
  EXPECT_FALSE(parameters.robot.scanner.rolling);
  EXPECT_TRUE(loadParameters(parseYaml("{robot: {scanner: {rolling: true}}}"), parameters).empty());
  EXPECT_TRUE(parameters.robot.scanner.rolling);
  EXPECT_TRUE(loadParameters(parseYaml("{lidar: {rolling: false}}"), parameters).empty());
  EXPECT_FALSE(parameters.robot.scanner.rolling);
}

}  // namespace
}  // namespace frontier_pilot::sim
