#include "ros/common/clock.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Clock, ConvertsTimesAndDurationsThereAndBack) {
  const ros::Time time(4294967295U, 999999999U);
  EXPECT_EQ(toTime(time).time_since_epoch(), std::chrono::seconds(4294967295) + std::chrono::nanoseconds(999999999));
  for (const double seconds : {0.0, 0.25, -1.5, 1e9, -2e9}) {
    EXPECT_EQ(toDuration(toRosDuration(seconds)), fromSeconds(seconds)) << seconds;
  }
  EXPECT_EQ(toRosTime(toTime(ros::Time(12, 34))), ros::Time(12, 34));
}

// [FLT-1]
TEST(Clock, SaturatesWhereRosTimeEnds) {
  EXPECT_EQ(toRosTime(toTime(ros::Time(4294967295U, 999999999U))).sec, 4294967295U);
  EXPECT_EQ(toRosTime(Time::max()).sec, 4294967295U);
  EXPECT_EQ(toRosTime(Time::min()), ros::Time());
  EXPECT_EQ(toRosDuration(Duration::max()).sec, 2147483647);
  EXPECT_EQ(toRosDuration(Duration::min()).sec, -2147483647);
  const ros::Duration longest(2147483647, 999999999);
  EXPECT_EQ(toRosDuration(toDuration(longest)).sec, 2147483647);
  EXPECT_EQ(toRosDuration(longest.toSec()).sec, 2147483647);  // which rounds up to 2^31 s
  EXPECT_EQ(toRosDuration(-kInfinity).sec, -2147483647);
  EXPECT_EQ(toRosDuration(1e300).sec, 2147483647);
  EXPECT_EQ(toRosDuration(std::numeric_limits<double>::quiet_NaN()), ros::Duration());
}

}  // namespace
}  // namespace frontier_pilot
