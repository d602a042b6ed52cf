// A robot that turns at up to 2.8 rad/s with a scanner that measures one beam after the other, five times a second.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/mapper.h"
#include "support/closed_loop/guided_drive.h"

namespace frontier_pilot {
namespace {

sim::SimulatorParameters fastTurns() {
  sim::SimulatorParameters parameters;
  parameters.odom_noise = true;
  parameters.odometry.distance_scale = parameters.odometry.turn_scale = 0.03;
  parameters.robot.limits.max_angular = 2.8;
  parameters.robot.scanner.rate = 5.0;
  return parameters;
}

/// The root of the mean square of the distance between the estimated and the true position, over all scans [m].
double errorOf(const sim::SimulatorParameters& parameters) {
  test::GuidedDrive drive(sim::loadWorld(std::string(WORLDS_DIRECTORY) + "/office.yaml"), parameters, 30.0);
  mapping::Mapper mapper;
  BeamTiming timing(parameters.robot.scanner);
  double sum = 0.0;
  int scans = 0;
  while (const LaserScan2* raw = drive.nextScan()) {
    LaserScan2 scan = *raw;
    timing.apply(scan);
    placeBeams(drive.odometry(), ScanReference::kMiddle, scan);
    const Pose2 T_odom_base = drive.odometry().nearest(scan.stamp).value();
    mapper.insert(scan, T_odom_base, drive.now());
    const Pose2 estimated = mapper.T_map_odom() * T_odom_base;
    sum += (estimated.position() - drive.truth().nearest(scan.stamp)->position()).squaredNorm();
    ++scans;
  }
  return std::sqrt(sum / scans);
}

// [SCN-1]
TEST(RollingScans, AreMappedAboutAsWellAsThoseMeasuredAtOnceAndMuchWorseUncorrected_SCN_1) {
  sim::SimulatorParameters parameters = fastTurns();
  const double at_once = errorOf(parameters);
  parameters.robot.scanner.rolling = true;
  const double corrected = errorOf(parameters);
  parameters.robot.scanner.time_increment = 0.0;
  const double skewed = errorOf(parameters);
  EXPECT_LT(corrected, 1.3 * at_once) << at_once;
  EXPECT_GT(skewed, 1.3 * at_once) << at_once;
  EXPECT_GT(skewed, 2.0 * corrected) << corrected;
}

}  // namespace
}  // namespace frontier_pilot
