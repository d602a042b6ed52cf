#include <gtest/gtest.h>

#include "ros/common/clock_monitor.h"

namespace frontier_pilot {
namespace {

const Time kClock = timeFromSeconds(100.0);

bool isAhead(double seconds) { return frontier_pilot::isAhead(kClock + fromSeconds(seconds), kClock); }

// [FLT-1]
TEST(ClockAhead, IsTenSecondsOnARealClock) {
  ros::Time::init();
  EXPECT_FALSE(isAhead(-1000.0));
  EXPECT_FALSE(isAhead(9.9));
  EXPECT_TRUE(isAhead(10.1));
  ros::Time::setNow(ros::Time(100));
}

// [FLT-1] At three hundred times real time a tenth of a second on a loaded machine is half a minute.
TEST(ClockAhead, IsWhatAFastSimulationMayBeAheadOfItsReader) {
  ros::Time::setNow(ros::Time(100));
  EXPECT_FALSE(isAhead(kSimulatedPace.slack - 1.0));
  EXPECT_TRUE(isAhead(kSimulatedPace.slack + 1.0));
}

// [FLT-1]
TEST(ClockAhead, IsNotToldBeforeTheFirstClock) {
  EXPECT_FALSE(frontier_pilot::isAhead(timeFromSeconds(1.7e9), Time{}));
}

}  // namespace
}  // namespace frontier_pilot
