#include "frontier_pilot/core/tick_schedule.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

/// How many ticks are due while the clock goes from `from` to `to` [s] in steps of a millisecond.
int ticks(TickSchedule& schedule, double from, double to) {
  int count = 0;
  const int steps = static_cast<int>((to - from) * 1000.0 + 0.5);
  for (int i = 1; i <= steps; ++i) count += schedule.isDue(timeFromSeconds(from + i * 0.001)) ? 1 : 0;
  return count;
}

TEST(TickSchedule, TicksOncePerPeriodAndNotAtTheBeginning) {
  TickSchedule schedule(fromSeconds(0.05));
  EXPECT_FALSE(schedule.isDue(timeFromSeconds(10.0)));
  EXPECT_EQ(ticks(schedule, 10.0, 11.0), 20);
}

TEST(TickSchedule, TellsWhatIsLeftUntilTheNextTick) {
  TickSchedule schedule(fromSeconds(0.05));
  EXPECT_EQ(schedule.left(timeFromSeconds(10.0)), Duration::zero()) << "not known yet";
  schedule.isDue(timeFromSeconds(10.0));
  EXPECT_EQ(schedule.left(timeFromSeconds(10.02)), fromSeconds(0.03));
  EXPECT_EQ(schedule.left(timeFromSeconds(10.07)), Duration::zero()) << "due";
}

TEST(TickSchedule, TicksForEachPeriodThatWasSlightlyMissedAndOnceForMany) {
  TickSchedule schedule(fromSeconds(0.05));
  schedule.isDue(timeFromSeconds(10.0));
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(10.11)));
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(10.11)));
  EXPECT_FALSE(schedule.isDue(timeFromSeconds(10.11)));
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(20.0)));
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(20.0)));
  EXPECT_FALSE(schedule.isDue(timeFromSeconds(20.0)));
}

// [FLT-1]
TEST(TickSchedule, GoesOnAfterAFutureThatNeverWasAndAtTheEndOfTime) {
  TickSchedule schedule(fromSeconds(0.05));
  schedule.isDue(timeFromSeconds(10.0));
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(1e6)));
  EXPECT_FALSE(schedule.isDue(timeFromSeconds(10.1)));
  EXPECT_EQ(ticks(schedule, 10.1, 11.1), 20);
  EXPECT_TRUE(schedule.isDue(timeFromSeconds(4294967295.999)));
  EXPECT_FALSE(schedule.isDue(timeFromSeconds(11.1)));
  EXPECT_EQ(ticks(schedule, 11.1, 12.1), 20);
}

}  // namespace
}  // namespace frontier_pilot
