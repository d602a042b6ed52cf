#include "ros/common/master/lost_connections.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime steadyAt(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

/// How often "/scan" is due within `seconds` if it stays lost, asked once a second.
int attemptsWithin(int seconds) {
  ReconnectTimes times;
  int attempts = 0;
  for (int second = 0; second <= seconds; ++second)
    attempts += static_cast<int>(times.due({"/scan"}, steadyAt(second)).size());
  return attempts;
}

TEST(ReconnectTimes, AConnectionHasTwoSecondsToBeMadeBeforeItIsMadeAgain_FLT_1) {
  ReconnectTimes times;
  EXPECT_TRUE(times.due({"/scan"}, steadyAt(0.0)).empty());
  EXPECT_TRUE(times.due({"/scan"}, steadyAt(1.9)).empty());
  EXPECT_EQ(times.due({"/scan", "/odom"}, steadyAt(2.0)), std::vector<std::string>{"/scan"});
  EXPECT_EQ(times.due({"/scan", "/odom"}, steadyAt(4.0)), std::vector<std::string>{"/odom"});
}

TEST(ReconnectTimes, AConnectionThatCannotBeMadeIsTriedLessAndLessOften_FLT_1) {
  EXPECT_EQ(attemptsWithin(2), 1);
  EXPECT_EQ(attemptsWithin(12), 2);
  EXPECT_EQ(attemptsWithin(32), 3);
  EXPECT_EQ(attemptsWithin(3600), 16);  // five while the pauses grow from 10 to 160 s, then one in five minutes
}

TEST(ReconnectTimes, AConnectionThatIsLostAgainIsMadeAgainAsSoonAsTheFirstTime_FLT_1) {
  ReconnectTimes times;
  for (int second = 0; second < 100; ++second) times.due({"/scan"}, steadyAt(second));
  EXPECT_TRUE(times.due({}, steadyAt(100.0)).empty());
  EXPECT_TRUE(times.due({"/scan"}, steadyAt(101.0)).empty());
  EXPECT_EQ(times.due({"/scan"}, steadyAt(103.0)).size(), 1U);
}

}  // namespace
}  // namespace frontier_pilot
