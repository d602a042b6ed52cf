#include "sim/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frontier_pilot::sim {
namespace {

struct Spread {
  double yaw = 0.0;
  double distance = 0.0;
};

// The variances at the end of `metres` driven in `steps`.
Spread spreadAfter(double metres, double turn, int steps, const OdometryParameters& parameters) {
  constexpr int kRuns = 4000;
  Spread spread;
  for (int run = 0; run < kRuns; ++run) {
    Odometry odometry(parameters, true, Random(9, static_cast<std::uint64_t>(run)));
    for (int i = 0; i < steps; ++i) odometry.move(metres / steps, turn / steps, 0.01);
    const double yaw_error = angleDifference(odometry.pose().yaw, turn);
    spread.yaw += yaw_error * yaw_error / kRuns;
    const double distance_error = odometry.pose().position().norm() - metres;
    spread.distance += distance_error * distance_error / kRuns;
  }
  return spread;
}

TEST(Odometry, WithoutNoiseIsTheMotionItself) {
  Odometry odometry(OdometryParameters{}, false, Random(1));
  for (int i = 0; i < 100; ++i) odometry.move(0.01, 0.02, 0.1);
  const Pose2 expected = integrate({}, {1.0, 2.0}, 1.0);
  EXPECT_NEAR(odometry.pose().x, expected.x, 1e-12);
  EXPECT_NEAR(odometry.pose().y, expected.y, 1e-12);
  EXPECT_NEAR(odometry.pose().yaw, expected.yaw, 1e-12);
  EXPECT_NEAR(odometry.twist().linear, 0.1, 1e-12);
  EXPECT_NEAR(odometry.twist().angular, 0.2, 1e-12);
}

// [SIM-2] alpha1...alpha4, whatever the length of a step
TEST(Odometry, NoiseIsThatOfTheAlphasWhateverTheStep_SIM_2) {
  OdometryParameters parameters;
  parameters.alpha1 = parameters.alpha4 = 0.0;
  parameters.alpha2 = 1e-6;
  parameters.alpha3 = 4e-4;
  for (int steps : {5, 100}) {
    const Spread spread = spreadAfter(2.0, 0.0, steps, parameters);
    EXPECT_NEAR(spread.yaw / 2e-6, 1.0, 0.1) << steps;
    EXPECT_NEAR(spread.distance / 8e-4, 1.0, 0.1) << steps;
  }
  parameters = {};
  parameters.alpha2 = parameters.alpha3 = parameters.alpha4 = 0.0;
  for (int steps : {5, 100}) {
    EXPECT_NEAR(spreadAfter(0.0, 1.5, steps, parameters).yaw / (1.5 * parameters.alpha1), 1.0, 0.1) << steps;
  }
}

// [SIM-2] a base that is badly calibrated errs the same way all the time
TEST(Odometry, ScalesAndDriftsByWhatWasDrawnAtTheStart_SIM_2) {
  OdometryParameters parameters;
  parameters.alpha1 = parameters.alpha2 = parameters.alpha3 = parameters.alpha4 = 0.0;
  parameters.distance_scale = 0.05;
  constexpr int kRobots = 4000;
  double variance = 0.0;
  for (int robot = 0; robot < kRobots; ++robot) {
    Odometry odometry(parameters, true, Random(9, static_cast<std::uint64_t>(robot)));
    odometry.move(1.0, 0.0, 1.0);
    const double first = odometry.pose().x;
    odometry.move(1.0, 0.0, 1.0);
    EXPECT_NEAR(odometry.pose().x, 2.0 * first, 1e-12) << "no two metres differ";
    variance += (first - 1.0) * (first - 1.0) / kRobots;
  }
  EXPECT_NEAR(std::sqrt(variance), 0.05, 0.003);
  parameters.distance_scale = 0.0;
  parameters.turn_scale = 0.05;
  parameters.drift = 0.01;
  Odometry odometry(parameters, true, Random(3));
  odometry.move(0.0, 1.0, 1.0);
  const double turned = odometry.pose().yaw - 1.0;
  EXPECT_NE(turned, 0.0);
  odometry.move(2.0, 0.0, 1.0);
  const double drifted = odometry.pose().yaw - 1.0 - turned;
  EXPECT_NE(drifted, 0.0);
  odometry.move(2.0, 1.0, 1.0);
  EXPECT_NEAR(odometry.pose().yaw, 2.0 + 2.0 * (turned + drifted), 1e-12);
}

TEST(Odometry, StandsStillWithoutDrifting) {
  Odometry odometry(OdometryParameters{}, true, Random(1));
  for (int i = 0; i < 1000; ++i) odometry.move(0.0, 0.0, 0.01);
  EXPECT_EQ(odometry.pose(), Pose2());
}

TEST(Random, IsUniformAndNormalAsItShouldBe) {
  Random random(4);
  double uniform = 0.0;
  double mean = 0.0;
  double variance = 0.0;
  double tails = 0.0;
  constexpr int kCount = 200000;
  for (int i = 0; i < kCount; ++i) {
    uniform += random.uniform() / kCount;
    const double x = random.gaussian();
    mean += x / kCount;
    variance += x * x / kCount;
    tails += std::abs(x) > 1.959964 ? 1.0 / kCount : 0.0;
  }
  EXPECT_NEAR(uniform, 0.5, 0.003);
  EXPECT_NEAR(mean, 0.0, 0.01);
  EXPECT_NEAR(variance, 1.0, 0.015);
  EXPECT_NEAR(tails, 0.05, 0.002);
}

TEST(Random, HasIndependentStreams) {
  Random a(4, 0);
  Random b(4, 1);
  double product = 0.0;
  for (int i = 0; i < 10000; ++i) product += a.gaussian() * b.gaussian() / 10000.0;
  EXPECT_NEAR(product, 0.0, 0.04);
}

}  // namespace
}  // namespace frontier_pilot::sim
