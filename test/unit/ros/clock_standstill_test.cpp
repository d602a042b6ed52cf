#include <gtest/gtest.h>

#include "ros/common/clock_monitor.h"

namespace frontier_pilot {
namespace {

Instant at(double ros, double steady) { return {timeFromSeconds(ros), SteadyTime(fromSeconds(steady))}; }

// [FLT-1] Nodes tick on ROS time: where that stands still they do nothing, and nothing else would say so.
TEST(ClockStandstill, IsSaidAfterTwoSecondsOfSteadyTime_FLT_1) {
  EXPECT_EQ(standstill(at(5.0, 100.0), at(5.0, 101.9)), "");
  EXPECT_EQ(standstill(at(5.0, 100.0), at(5.0, 102.1)), "ROS time has stood still for 2 s");
  EXPECT_EQ(standstill(at(5.0, 100.0), at(5.0, 3700.0)), "ROS time has stood still for 3600 s");
}

TEST(ClockStandstill, IsNotSaidWhereTheClockHasMovedSinceItWasLastLookedAt) {
  EXPECT_EQ(standstill(at(5.0, 100.0), at(5.1, 200.0)), "");
}

TEST(ClockStandstill, IsSaidInOtherWordsBeforeTheFirstClock) {
  EXPECT_EQ(standstill(at(0.0, 100.0), at(0.0, 101.0)), "");
  EXPECT_EQ(standstill(at(0.0, 100.0), at(0.0, 110.0)), "no /clock received yet");
}

}  // namespace
}  // namespace frontier_pilot
