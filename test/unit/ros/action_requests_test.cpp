#include "ros/common/actions/action_requests.h"

#include <gtest/gtest.h>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

const Time kNow = timeFromSeconds(100.0);
const ros::Time kEndOfTime(4294967295U, 999999999U);

// [FLT-1]
TEST(ActionRequests, OfTheFutureAreOfNow) {
  EXPECT_EQ(stampOrNow(kEndOfTime, kNow), ros::Time(100));
  EXPECT_EQ(stampOrNow(ros::Time(100, 1), kNow), ros::Time(100));
  EXPECT_EQ(goalStamp(kEndOfTime, kNow), ros::Time()) << "actionlib dates it now";
}

TEST(ActionRequests, OfThePastKeepTheirStampAndTheUnstampedStaySo) {
  for (const ros::Time& stamp : {ros::Time(), ros::Time(99, 5), ros::Time(100)}) {
    EXPECT_EQ(stampOrNow(stamp, kNow), stamp);
    EXPECT_EQ(goalStamp(stamp, kNow), stamp);
  }
}

TEST(ActionRequests, WithMoreNanosecondsThanASecondHasAreOfNow) {
  ros::Time broken;
  broken.nsec = 4000000000U;
  EXPECT_EQ(stampOrNow(broken, kNow), ros::Time(100));
}

TEST(ActionRequests, MayBeUnnamedAndNotNamedWithoutEnd) {
  actionlib_msgs::GoalID id;
  EXPECT_EQ(problemOf(id), nullptr);
  id.id = "/explorer-17-12.345";
  EXPECT_EQ(problemOf(id), nullptr);
  id.id.assign(100000, 'x');
  EXPECT_NE(problemOf(id), nullptr);
}

}  // namespace
}  // namespace frontier_pilot
