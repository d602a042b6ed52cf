#include <gtest/gtest.h>

#include <limits>

#include "ros/common/clock.h"
#include "ros/common/tf/tf_listener.h"

namespace frontier_pilot {
namespace {

const Time kHeardAt = timeFromSeconds(100.0);

geometry_msgs::TransformStamped transform() {
  geometry_msgs::TransformStamped msg;
  msg.header.stamp = ros::Time(100);
  msg.header.frame_id = "map";
  msg.child_frame_id = "odom";
  msg.transform.rotation.w = 1.0;
  return msg;
}

// [FLT-1] At three hundred times real time a tenth of a second on a loaded machine is half a minute.
TEST(Transforms, AreTakenAlsoFromASimulationThatIsAheadOfItsReader) {
  ros::Time::setNow(ros::Time(100));
  auto msg = transform();
  msg.header.stamp = ros::Time(130);
  EXPECT_EQ(problemOf(msg, kHeardAt, false), nullptr);
}

TEST(Transforms, AreTakenAsRobotsSendThem) {
  auto msg = transform();
  EXPECT_EQ(problemOf(msg, kHeardAt, false), nullptr);
  msg.header.stamp = ros::Time(100.1);
  EXPECT_EQ(problemOf(msg, kHeardAt, false), nullptr) << "a mapper dates them ahead";
  EXPECT_EQ(problemOf(msg, Time{}, false), nullptr) << "before the first /clock";
  msg.header.stamp = ros::Time(5000);
  EXPECT_EQ(problemOf(msg, kHeardAt, true), nullptr) << "a static one holds at any time";
}

// [FLT-1]
TEST(Transforms, AreRefusedWithStampsThatTimeArithmeticCannotTake) {
  auto msg = transform();
  for (const ros::Time& stamp : {ros::Time(4294967295U, 999999999U), ros::Time(4294967290U, 0U)}) {
    msg.header.stamp = stamp;
    EXPECT_STREQ(problemOf(msg, kHeardAt, false), "stamp out of range");
    EXPECT_STREQ(problemOf(msg, kHeardAt, true), "stamp out of range");
  }
  msg.header.stamp = ros::Time(1000100);
  EXPECT_STREQ(problemOf(msg, kHeardAt, false), "stamp too far in the future");
}

// [FLT-1]
TEST(Transforms, AreRefusedWithoutNameOrOrientationAndWithNamesThatNobodyCanRead) {
  for (const char* frame : {"", "/"}) {
    auto msg = transform();
    msg.child_frame_id = frame;
    EXPECT_STREQ(problemOf(msg, kHeardAt, false), "frame without a name");
  }
  auto self = transform();
  self.child_frame_id = "/map";
  EXPECT_STREQ(problemOf(self, kHeardAt, false), "frame that is its own parent");
  auto endless = transform();
  endless.child_frame_id.assign(100000, 'x');
  EXPECT_STREQ(problemOf(endless, kHeardAt, false), "frame's name longer than 256 characters");
  for (const char* frame : {"od\nom", "\x1b[2J", "\u2028", "\xff"}) {
    auto msg = transform();
    msg.header.frame_id = frame;
    EXPECT_STREQ(problemOf(msg, kHeardAt, false), "control characters in a frame's name") << frame;
  }
  for (const double w : {0.0, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    auto msg = transform();
    msg.transform.rotation.w = w;
    EXPECT_STREQ(problemOf(msg, kHeardAt, false),
                 "not finite, farther than 1000 km, or its quaternion not of unit length");
  }
}

}  // namespace
}  // namespace frontier_pilot
