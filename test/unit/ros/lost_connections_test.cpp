#include "ros/common/master/lost_connections.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime afterSeconds(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

/// How often "/scan" is due within `seconds` if it stays lost, asked once a second.
int attemptsWithin(int seconds) {
  ReconnectTimes times;
  int attempts = 0;
  for (int second = 0; second <= seconds; ++second)
    attempts += static_cast<int>(times.due({"/scan"}, afterSeconds(second)).size());
  return attempts;
}

TEST(ReconnectTimes, AConnectionHasTwoSecondsToBeMadeBeforeItIsMadeAgain_FLT_1) {
  ReconnectTimes times;
  EXPECT_TRUE(times.due({"/scan"}, afterSeconds(0.0)).empty());
  EXPECT_TRUE(times.due({"/scan"}, afterSeconds(1.9)).empty());
  EXPECT_EQ(times.due({"/scan", "/odom"}, afterSeconds(2.0)), std::vector<std::string>{"/scan"});
  EXPECT_EQ(times.due({"/scan", "/odom"}, afterSeconds(4.0)), std::vector<std::string>{"/odom"});
}

TEST(ReconnectTimes, AConnectionThatCannotBeMadeIsTriedLessAndLessOften_FLT_1) {
  EXPECT_EQ(attemptsWithin(2), 1);
  EXPECT_EQ(attemptsWithin(12), 2);
  EXPECT_EQ(attemptsWithin(32), 3);
  EXPECT_EQ(attemptsWithin(3600), 16);  // five while the pauses grow from 10 to 160 s, then one in five minutes
}

TEST(ReconnectTimes, AConnectionThatIsLostAgainIsMadeAgainAsSoonAsTheFirstTime_FLT_1) {
  ReconnectTimes times;
  for (int second = 0; second < 100; ++second) times.due({"/scan"}, afterSeconds(second));
  EXPECT_TRUE(times.due({}, afterSeconds(100.0)).empty());
  EXPECT_TRUE(times.due({"/scan"}, afterSeconds(101.0)).empty());
  EXPECT_EQ(times.due({"/scan"}, afterSeconds(103.0)).size(), 1U);
}

}  // namespace
}  // namespace frontier_pilot
