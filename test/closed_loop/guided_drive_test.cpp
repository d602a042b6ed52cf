#include <gtest/gtest.h>

#include "support/closed_loop/corridor_world.h"
#include "support/closed_loop/faulty_drive.h"

namespace frontier_pilot::test {
namespace {

sim::SimulatorParameters noisy(int seed) {
  sim::SimulatorParameters parameters;
  parameters.seed = seed;
  parameters.odom_noise = true;
  parameters.odometry.turn_scale = 0.1;
  return parameters;
}

TEST(GuidedDrive, IsTheSameForEverySeedAndTouchesNothing) {
  GuidedDrive first(corridorWorld(), noisy(1), 20.0);
  GuidedDrive second(corridorWorld(), noisy(2), 20.0);
  while (first.nextScan() != nullptr) {
    ASSERT_NE(second.nextScan(), nullptr);
    ASSERT_EQ(first.T_map_base(), second.T_map_base());
  }
  EXPECT_EQ(second.nextScan(), nullptr);
  EXPECT_GE(first.distance(), 20.0);
  EXPECT_NE(first.T_odom_base().yaw, second.T_odom_base().yaw);
  EXPECT_EQ(first.simulator().contactCount(0), 0);
}

/// Drives `seconds` with a fault, and calls `look` for each scan.
template <class Look>
void drive(SensorFault fault, double seconds, const Look& look) {
  sim::SimulatorParameters parameters;
  parameters.lidar.noise_stddev = 0.0;
  FaultyDrive faulty(corridorWorld(), parameters, 1000.0, fault);
  while (toSeconds(faulty.drive().now()) < seconds) look(faulty, *faulty.nextScan());
}

TEST(FaultyDrive, LosesTheMotionOfASecondWhenOdometryFreezes) {
  double frozen = 0.0;
  Pose2 last;
  drive(SensorFault::kOdomFrozen, 20.0, [&](const FaultyDrive& faulty, const LaserScan2&) {
    const Pose2 odometry = faulty.T_odom_base().value();
    const bool stands = (odometry.position() - last.position()).norm() < 1e-9 && odometry.yaw == last.yaw;
    if (toSeconds(faulty.drive().now()) > 14.0 && stands) frozen += 0.1;
    last = odometry;
  });
  EXPECT_NEAR(frozen, 1.0, 0.11);
}

TEST(FaultyDrive, HasNoOdometryForASecondWhenItIsMissing) {
  double missing = 0.0;
  drive(SensorFault::kOdomMissing, 20.0,
        [&](const FaultyDrive& faulty, const LaserScan2&) { missing += faulty.T_odom_base() ? 0.0 : 0.1; });
  EXPECT_NEAR(missing, 1.0, 0.11);
}

TEST(FaultyDrive, SeesAnotherPlaceForThreeSecondsWhenKidnapped) {
  std::vector<float> first;
  double kidnapped = 0.0;
  drive(SensorFault::kKidnap, 30.0, [&](const FaultyDrive& faulty, const LaserScan2& scan) {
    if (first.empty()) first = scan.ranges;
    if (toSeconds(faulty.drive().now()) > 5.0 && std::abs(scan.ranges[90] - first[90]) < 0.01F) kidnapped += 0.1;
  });
  EXPECT_NEAR(kidnapped, 3.0, 0.5);
}

TEST(FaultyDrive, SeesAPersonCross) {
  double seen = 0.0;
  drive(SensorFault::kPerson, 30.0, [&](const FaultyDrive&, const LaserScan2& scan) {
    seen += scan.ranges[0] < 1.1F && scan.ranges[0] > 0.8F ? 0.1 : 0.0;
  });
  EXPECT_GT(seen, 0.2);
}

}  // namespace
}  // namespace frontier_pilot::test
