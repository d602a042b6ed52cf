#include "ros/common/messages/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "good_messages.h"

namespace frontier_pilot {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const Eigen::Isometry3d kAtTheBase = Eigen::Isometry3d::Identity();

Eigen::Isometry3d mount(double x, double y, const Eigen::Quaterniond& rotation) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << x, y, 0.17;
  T.linear() = rotation.toRotationMatrix();
  return T;
}

Eigen::Quaterniond turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

TEST(Conversions, PosesComeBackAsTheyWent) {
  for (double yaw = -3.1; yaw < 3.1; yaw += 0.3) {
    const Pose2 pose(1.5, -2.5, yaw);
    for (const auto& back : {toPose(toPoseMsg(pose)), toPose(toTransformMsg(pose))}) {
      ASSERT_TRUE(back);
      EXPECT_DOUBLE_EQ(back->x, pose.x);
      EXPECT_DOUBLE_EQ(back->y, pose.y);
      EXPECT_NEAR(back->yaw, yaw, 1e-12);
    }
  }
}

TEST(Conversions, AQuaternionNobodyFilledInIsNoPose) {
  std::string why;
  EXPECT_FALSE(toPose(geometry_msgs::Pose(), &why));
  EXPECT_EQ(why, "quaternion not of unit length");
  geometry_msgs::Pose msg = toPoseMsg({});
  msg.orientation.w = kNaN;
  EXPECT_FALSE(toPose(msg));
  msg.orientation.w = 1.1;
  EXPECT_FALSE(toPose(msg));
}

TEST(Conversions, APositionThatIsNotFiniteIsNoPose) {
  geometry_msgs::Pose msg = toPoseMsg({});
  msg.position.z = kNaN;
  EXPECT_FALSE(toPose(msg));
  EXPECT_FALSE(toIsometry(toTransformMsg(Pose2(kNaN, 0.0, 0.0))));
}

TEST(Conversions, ATwistWithOneFieldNotFiniteIsNoTwist) {
  for (double geometry_msgs::Vector3::*axis : {&geometry_msgs::Vector3::x, &geometry_msgs::Vector3::y}) {
    geometry_msgs::Twist msg;
    msg.linear.*axis = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(toTwist(msg));
    msg = {};
    msg.angular.*axis = kNaN;
    EXPECT_FALSE(toTwist(msg));
  }
}

// [EXP-10]
TEST(Conversions, AChargeIsAShareWhetherItsDriverSendsSharesOrPercent_EXP_10) {
  sensor_msgs::BatteryState msg;
  const auto charge = [&msg](float percentage) {
    bool in_percent = false;
    msg.percentage = percentage;
    return toCharge(msg, in_percent);
  };
  EXPECT_FLOAT_EQ(static_cast<float>(charge(0.0F).value()), 0.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(charge(0.3F).value()), 0.3F);
  EXPECT_FLOAT_EQ(static_cast<float>(charge(1.12F).value()), 1.12F) << "a TurtleBot3 that is charged";
  EXPECT_FLOAT_EQ(static_cast<float>(charge(30.0F).value()), 0.3F);
  EXPECT_FLOAT_EQ(static_cast<float>(charge(100.0F).value()), 1.0F);
  for (const float wrong : {-0.1F, 101.0F, static_cast<float>(kNaN)}) EXPECT_FALSE(charge(wrong)) << wrong;
}

// [EXP-10]
TEST(Conversions, AfterAChargeInPercentAnEmptyBatteryIsNotTakenForAFullOne_EXP_10) {
  sensor_msgs::BatteryState msg;
  bool in_percent = false;
  msg.percentage = 40.0F;
  EXPECT_NEAR(toCharge(msg, in_percent).value(), 0.4, 1e-6);
  msg.percentage = 1.0F;
  EXPECT_NEAR(toCharge(msg, in_percent).value(), 0.01, 1e-6);
}

TEST(Conversions, ATwistLosesTheAxesThatADifferentialDriveLacks) {
  geometry_msgs::Twist msg;
  msg.linear.x = 0.2;
  msg.linear.y = 0.3;
  msg.angular.z = -0.4;
  EXPECT_EQ(toTwist(msg), (Twist2{0.2, -0.4}));
}

TEST(Conversions, OdometryComesBackAsItWent) {
  const MotionSample odometry{timeFromSeconds(12.25), Pose2(1.0, 2.0, 0.5), Twist2{0.1, -0.2}};
  const auto back = toOdometry(toOdometryMsg(odometry, "odom", "base_footprint"));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->stamp, odometry.stamp);
  EXPECT_NEAR(back->T_odom_base.yaw, 0.5, 1e-12);
  EXPECT_EQ(back->twist, odometry.twist);
}

TEST(Conversions, OdometryWithoutAnOrientationIsNone) {
  nav_msgs::Odometry msg;
  std::string why;
  EXPECT_FALSE(toOdometry(msg, &why));
  EXPECT_FALSE(why.empty());
}

TEST(Conversions, AScanOfTheWrongLengthIsRefused_MAP_4) {  // [MAP-4] [AVO-5]
  std::string why;
  sensor_msgs::LaserScan msg = goodScan();
  msg.ranges.resize(3);
  EXPECT_FALSE(toLaserScan(msg, kAtTheBase, &why));
  EXPECT_EQ(why, "number of ranges does not match the angles");
  msg.ranges.resize(8);
  EXPECT_FALSE(toLaserScan(msg, kAtTheBase));
  msg.ranges.clear();
  EXPECT_FALSE(toLaserScan(msg, kAtTheBase));
}

TEST(Conversions, AScanWhoseLastAngleLiesOnePastTheLastBeamIsGood) {
  sensor_msgs::LaserScan msg = goodScan();
  msg.angle_max = 1.5F;
  EXPECT_TRUE(toLaserScan(msg, kAtTheBase));
}

TEST(Conversions, AScanWithBadNumbersIsRefused_MAP_4) {  // [MAP-4]
  const auto refused = [](float sensor_msgs::LaserScan::*field, float value) {
    sensor_msgs::LaserScan msg = goodScan();
    msg.*field = value;
    return !toLaserScan(msg, kAtTheBase);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(refused(&sensor_msgs::LaserScan::angle_increment, 0.0F));
  EXPECT_TRUE(refused(&sensor_msgs::LaserScan::angle_increment, -0.5F));
  EXPECT_TRUE(refused(&sensor_msgs::LaserScan::angle_min, nan));
  EXPECT_TRUE(refused(&sensor_msgs::LaserScan::range_min, nan));
  EXPECT_TRUE(refused(&sensor_msgs::LaserScan::range_max, 0.1F));
}

TEST(Conversions, AScannerMountedUpsideDownGetsItsAnglesNegated_AVO_1) {  // [AVO-1]
  const double half_turn = kPi / 2.0;
  const auto rotation = turned(half_turn, Eigen::Vector3d::UnitZ()) * turned(kPi, Eigen::Vector3d::UnitX());
  const Eigen::Isometry3d T_base_sensor = mount(0.1, -0.05, rotation);
  const auto scan = toLaserScan(goodScan(), T_base_sensor);
  ASSERT_TRUE(scan);
  for (std::size_t i = 0; i < scan->ranges.size(); ++i) {
    const double angle = -1.0 + 0.5 * static_cast<double>(i);
    const Eigen::Vector3d beam = T_base_sensor * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    const Vec2 read = scan->T_base_sensor * direction(scan->angle(i));
    EXPECT_NEAR((read - beam.head<2>()).norm(), 0.0, 1e-6) << "beam " << i;
  }
}

TEST(Conversions, ATiltedScannerIsRefused) {
  EXPECT_FALSE(toLaserScan(goodScan(), mount(0.0, 0.0, turned(0.5, Eigen::Vector3d::UnitY()))));
  EXPECT_TRUE(toLaserScan(goodScan(), mount(0.0, 0.0, turned(0.1, Eigen::Vector3d::UnitY()))));
}

TEST(Conversions, ScansComeBackAsTheyWent) {
  const auto scan = toLaserScan(goodScan(), kAtTheBase);
  ASSERT_TRUE(scan);
  const auto back = toLaserScan(toLaserScanMsg(*scan, "base_scan", 0.1), kAtTheBase);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->ranges, scan->ranges);
  EXPECT_NEAR(back->angle(4), 1.0, 1e-6);
}

TEST(Conversions, MapsComeBackAsTheyWent) {
  const auto map = toOccupancyGrid(goodMap());
  ASSERT_TRUE(map);
  EXPECT_EQ((*map)[(Cell{2, 0})], kOccupied);
  const auto msg = toOccupancyGridMsg(*map, "map", timeFromSeconds(1.0));
  EXPECT_EQ(msg.header.frame_id, "map");
  EXPECT_EQ(msg.data, goodMap().data);
}

TEST(Conversions, AMapThatDoesNotFitItsSizeIsRefused) {
  nav_msgs::OccupancyGrid msg = goodMap();
  msg.info.height = 3;
  std::string why;
  EXPECT_FALSE(toOccupancyGrid(msg, &why));
  EXPECT_EQ(why, "number of cells does not match the map's size");
  EXPECT_FALSE(toOccupancyGrid(nav_msgs::OccupancyGrid()));
}

TEST(Conversions, AMapWithBadNumbersIsRefused) {
  nav_msgs::OccupancyGrid msg = goodMap();
  msg.info.resolution = 0.0F;
  EXPECT_FALSE(toOccupancyGrid(msg));
  msg = goodMap();
  msg.data[3] = 101;
  EXPECT_FALSE(toOccupancyGrid(msg));
  msg = goodMap();
  msg.info.origin = toPoseMsg(Pose2(0.0, 0.0, 0.3));
  EXPECT_FALSE(toOccupancyGrid(msg));
}

TEST(Conversions, UpdatesComeBackAsTheyWent) {
  const auto map = toOccupancyGrid(goodMap());
  ASSERT_TRUE(map);
  const auto update = toGridUpdate(toGridUpdateMsg(*map, {1, 0, 2, 2}, "map", Time{}));
  ASSERT_TRUE(update);
  EXPECT_EQ(update->rect, (CellRect{1, 0, 2, 2}));
  EXPECT_EQ(update->cells, (std::vector<std::int8_t>{0, 100, 0, -1}));
}

TEST(Conversions, AnUpdateThatDoesNotFitItsSizeIsRefused) {
  map_msgs::OccupancyGridUpdate msg;
  msg.width = 2;
  msg.height = 2;
  msg.data = {0, 0, 0};
  EXPECT_FALSE(toGridUpdate(msg));
  msg.data = {0, 0, 0, 0};
  EXPECT_TRUE(toGridUpdate(msg));
  msg.x = -1;
  EXPECT_FALSE(toGridUpdate(msg));
}

TEST(Conversions, PathsComeBackAsTheyWent) {
  const std::vector<Pose2> path{{0.0, 0.0, 0.0}, {1.0, 2.0, 0.5}};
  const auto back = toPath(toPathMsg(path, "map", Time{}));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), 2U);
  EXPECT_NEAR(back->back().yaw, 0.5, 1e-12);
  nav_msgs::Path broken = toPathMsg(path, "map", Time{});
  broken.poses[1].pose.orientation.w = kNaN;
  EXPECT_FALSE(toPath(broken));
}

TEST(Conversions, TimesComeBackAsTheyWent) {
  for (const double seconds : {0.0, 0.000000001, 1.5, 1.7e9}) {
    const Time time = timeFromSeconds(seconds);
    EXPECT_EQ(toTime(toRosTime(time)), time);
  }
  EXPECT_EQ(toRosTime(timeFromSeconds(-1.0)), ros::Time());
  EXPECT_EQ(toDuration(toRosDuration(fromSeconds(-0.25))), fromSeconds(-0.25));
}

}  // namespace
}  // namespace frontier_pilot
