#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "frontier_pilot/core/bounds.h"
#include "good_messages.h"
#include "ros/common/messages/conversions.h"

/// Messages that are well-formed and hold a number that would size memory or work. [FLT-1]
namespace frontier_pilot {
namespace {

const Eigen::Isometry3d kOnTheBase = Eigen::Isometry3d::Identity();

Eigen::Isometry3d mountedAt(double x, double y) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << x, y, 0.17;
  return T;
}

TEST(HostileMessages, FLT_1_APoseTooFarAwayIsNone) {  // [FLT-1]
  for (const double far : {1e300, -1e300, 1.1e6, -1.1e6}) {
    std::string why;
    EXPECT_FALSE(toPose(toPoseMsg(Pose2(far, 0.0, 0.0)), &why)) << far;
    EXPECT_EQ(why, "position farther than 1000 km from the origin");
    EXPECT_FALSE(toPose(toTransformMsg(Pose2(0.0, far, 0.0))));
    EXPECT_FALSE(toIsometry(toTransformMsg(Pose2(0.0, far, 0.0))));
  }
  EXPECT_TRUE(toPose(toPoseMsg(Pose2(1e6, -1e6, 0.0))));
  EXPECT_TRUE(toPose(toPoseMsg(Pose2(std::numeric_limits<double>::denorm_min(), 0.0, 0.0))));
}

TEST(HostileMessages, FLT_1_OdometryFasterThanAnyRobotIsNone) {  // [FLT-1]
  for (const Twist2& twist : {Twist2{1e300, 0.0}, Twist2{0.0, -1e300}, Twist2{101.0, 0.0}}) {
    EXPECT_FALSE(toOdometry(toOdometryMsg({Time{}, Pose2(), twist}, "odom", "base_footprint")));
  }
  EXPECT_TRUE(toOdometry(toOdometryMsg({Time{}, Pose2(), {30.0, -10.0}}, "odom", "base_footprint")));
}

TEST(HostileMessages, FLT_1_AScanWhoseNumbersWouldSizeTooMuchIsRefused) {  // [FLT-1]
  using Scan = sensor_msgs::LaserScan;
  const auto whyNot = [](const std::function<void(Scan&)>& spoil) {
    Scan msg = goodScan();
    spoil(msg);
    std::string why = "taken";
    toLaserScan(msg, kOnTheBase, &why);
    return why;
  };
  EXPECT_EQ(whyNot([](Scan&) {}), "taken");
  EXPECT_EQ(whyNot([](Scan& msg) { msg.range_max = 1e30F; }), "range limit beyond 1000 m");
  EXPECT_EQ(whyNot([](Scan& msg) { msg.range_min = 150.0F, msg.range_max = 200.0F; }), "blind within 100 m");
  EXPECT_EQ(whyNot([](Scan& msg) { msg.angle_max = msg.angle_min, msg.angle_increment = 1e-30F, msg.ranges = {1.0F}; }),
            "angle increment too small");
  EXPECT_EQ(whyNot([](Scan& msg) { msg.angle_max = 1e30F, msg.angle_increment = 2.5e29F; }), "angles beyond two turns");
  EXPECT_EQ(whyNot([](Scan& msg) {
              msg.ranges.resize(1000000, 1.0F);
              msg.angle_increment = 2.0F / 999999.0F;
            }),
            "more than 36000 ranges");
}

TEST(HostileMessages, FLT_1_BeamsAreUsedAsFarAsAMapReaches) {  // [FLT-1]
  sensor_msgs::LaserScan msg = goodScan();
  msg.range_max = 300.0F;
  msg.ranges = {1.0F, 99.0F, 101.0F, 250.0F, 1e30F};
  const auto scan = toLaserScan(msg, kOnTheBase);
  ASSERT_TRUE(scan);
  EXPECT_EQ(readBeam(*scan, 1).kind, RangeKind::kHit);
  for (std::size_t beam = 2; beam < 5; ++beam) {
    EXPECT_EQ(readBeam(*scan, beam).kind, RangeKind::kFree);
    EXPECT_EQ(readBeam(*scan, beam).distance, bounds::kUsedRange);
  }
}

TEST(HostileMessages, FLT_1_AScannerThatIsNotOnTheRobotIsRefused) {  // [FLT-1]
  std::string why;
  EXPECT_FALSE(toLaserScan(goodScan(), mountedAt(1e6, 0.0), &why));
  EXPECT_EQ(why, "scanner mounted farther than 10 m from the base");
  EXPECT_FALSE(toLaserScan(goodScan(), mountedAt(0.0, -10.1)));
  EXPECT_TRUE(toLaserScan(goodScan(), mountedAt(6.0, -6.0)));
}

TEST(HostileMessages, FLT_1_AMapOfCellsTooSmallOrTooLargeIsRefused) {  // [FLT-1]
  nav_msgs::OccupancyGrid msg = goodMap();
  for (const float resolution : {1e-10F, 1e-40F, 0.009F, 10.1F, 1e30F}) {
    msg.info.resolution = resolution;
    std::string why;
    EXPECT_FALSE(toOccupancyGrid(msg, &why)) << resolution;
    EXPECT_EQ(why, "resolution not within 0.01 m ... 10 m");
  }
  for (const float resolution : {0.01F, 0.05F, 10.0F}) {
    msg.info.resolution = resolution;
    EXPECT_TRUE(toOccupancyGrid(msg)) << resolution;
  }
}

TEST(HostileMessages, FLT_1_AMapOfTooManyCellsIsRefusedAndSaysWhatToDo) {  // [FLT-1]
  const auto whyNot = [](std::uint32_t width, std::uint32_t height) {
    nav_msgs::OccupancyGrid msg = goodMap();
    msg.info.width = width;
    msg.info.height = height;
    msg.data.assign(std::size_t{width} * height, kUnknown);
    std::string why = "taken";
    toOccupancyGrid(msg, &why);
    return why;
  };
  EXPECT_EQ(whyNot(6000, 6000), "taken") << "600 m x 600 m in cells of 10 cm";
  const std::string large =
      "map of more than 40000000 cells: make its cells larger, or leave out what nobody drives in";
  EXPECT_EQ(whyNot(8000, 8000), large);
  EXPECT_EQ(whyNot(20001, 1), "map of more than 20000 cells along a side");
  EXPECT_EQ(whyNot(1, 20001), "map of more than 20000 cells along a side");
}

TEST(HostileMessages, FLT_1_APathOfTooManyPosesIsRefused) {  // [FLT-1]
  EXPECT_FALSE(toPath(toPathMsg(std::vector<Pose2>(100001), "map", Time{})));
}

TEST(HostileMessages, FLT_1_WhateverComesInWhatIsTakenIsWithinTheBounds) {  // [FLT-1]
  constexpr std::array<double, 20> kEdges = {0.0,   1.0,    -1.0,      0.05,     0.01,      10.0, 1e-10,
                                             1e-40, -1e-40, 4e-324,    1e6,      -1e6,      1e30, -1e30,
                                             1e300, -1e300, 2.0 * kPi, HUGE_VAL, -HUGE_VAL, NAN};
  std::mt19937 random(11);
  const auto edge = [&](double usual) { return random() % 3 == 0 ? kEdges[random() % kEdges.size()] : usual; };
  const auto narrow = [&](double usual) { return static_cast<float>(edge(usual)); };
  int maps = 0, scans = 0;
  for (int i = 0; i < 100000; ++i) {
    nav_msgs::OccupancyGrid map = goodMap();
    map.info.resolution = narrow(0.05);
    map.info.origin.position.x = edge(0.0);
    map.info.origin.orientation.w = edge(1.0);
    if (const auto grid = toOccupancyGrid(map)) {
      ++maps;
      ASSERT_TRUE(grid->resolution() > 0.0099 && grid->resolution() <= 10.0);
      ASSERT_LE(std::abs(grid->geometry().origin.x()), 1e6);
    }
    sensor_msgs::LaserScan msg = goodScan();
    msg.angle_min = narrow(-1.0);
    msg.angle_max = narrow(1.0);
    msg.angle_increment = narrow(0.5);
    msg.range_min = narrow(0.12);
    msg.range_max = narrow(3.5);
    for (float& range : msg.ranges) range = narrow(1.0);
    const auto scan = toLaserScan(msg, mountedAt(edge(0.1), edge(0.0)));
    if (!scan) continue;
    ++scans;
    ASSERT_LE(scan->T_base_sensor.position().norm(), 10.0);
    ASSERT_GE(std::abs(scan->angle_increment), bounds::kLeastAngleIncrement);
    for (std::size_t beam = 0; beam < scan->ranges.size(); ++beam) {
      const double distance = readBeam(*scan, beam).distance;
      ASSERT_TRUE(distance >= 0.0 && distance <= 100.0) << msg;
    }
  }
  EXPECT_GT(maps, 1000);
  EXPECT_GT(scans, 1000);
}

}  // namespace
}  // namespace frontier_pilot
