// Odometry of a rosbag that jumps, because the base's driver was started again or a message is wrong. [FLT-1]

#include <gtest/gtest.h>

#include <algorithm>

#include "frontier_pilot/core/motion.h"
#include "ros/map_log/bag_log.h"
#include "written_bag.h"

namespace frontier_pilot {
namespace {

using BagOdometry = BagLog;

// [FLT-1]
TEST_F(BagOdometry, ThatIsResetOnTheWayMovesTheRobotNowhere_FLT_1) {
  writeMounts();
  for (int i = 0; i <= 40; ++i) {
    writeOdometryAt(100.0 + 0.1 * i, 0.1 * (i < 20 ? i : i - 20));
    if (i < 40) writeScan(100.05 + 0.1 * i);
  }
  const logs::ScanLog log = read();
  ASSERT_EQ(log.records.size(), 40U);
  for (std::size_t i = 1; i < log.records.size(); ++i)
    EXPECT_FALSE(isJump(log.records[i - 1].T_odom_base, log.records[i].T_odom_base, 0.2, 0.01)) << i;
  EXPECT_NEAR(log.records.back().T_odom_base.x, 3.85, 1e-6) << "a step of 0.1 m is not known";
  const std::vector<std::string> expected{
      "jumps of odometry: 1, taken for restarts of the base's driver: the robot has stayed where it "
      "was",
      "2 x odometry farther from the last message than a robot can drive in that time"};
  EXPECT_EQ(log.notes, expected);
}

// [FLT-1]
TEST_F(BagOdometry, IsTakenWithoutASingleMessageThatIsWrong_FLT_1) {
  writeMounts();
  for (int i = 0; i <= 20; ++i) {
    writeOdometryAt(100.0 + 0.1 * i, i == 10 ? 50.0 : 0.1 * i);
    if (i < 20) writeScan(100.05 + 0.1 * i);
  }
  const logs::ScanLog log = read();
  ASSERT_EQ(log.records.size(), 20U);
  EXPECT_NEAR(log.records[10].T_odom_base.x, 1.05, 1e-6);
  EXPECT_EQ(log.notes,
            std::vector<std::string>{"1 x odometry farther from the last message than a robot can drive in that time"});
}

}  // namespace
}  // namespace frontier_pilot
