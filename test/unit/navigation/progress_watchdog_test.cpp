#include "navigation/progress_watchdog.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Verdict = navigation::ProgressWatchdog::Verdict;

class ProgressWatchdogTest : public ::testing::Test {
 protected:
  ProgressWatchdogTest() { watchdog.restart(timeFromSeconds(0.0), Vec2::Zero()); }
  Verdict at(double seconds, double x, double remaining) {
    return watchdog.update(timeFromSeconds(seconds), Vec2(x, 0.0), remaining);
  }

  navigation::ProgressWatchdog watchdog;
};

TEST_F(ProgressWatchdogTest, FindsNothingWrongWithARobotThatComesNearer) {
  for (int i = 0; i <= 100; ++i) ASSERT_EQ(at(i, 0.1 * i, 10.0 - 0.1 * i), Verdict::kFine);
}

TEST_F(ProgressWatchdogTest, GivesUpAfterItsTimeWithoutProgressAndNotBefore) {
  ASSERT_EQ(at(1.0, 0.0, 5.0), Verdict::kFine);
  EXPECT_EQ(at(11.0, 0.0, 5.0), Verdict::kFine) << "exactly the timeout";
  EXPECT_EQ(at(11.001, 0.0, 5.0), Verdict::kNoProgress);
}

TEST_F(ProgressWatchdogTest, CountsNothingBelowItsDistanceAsProgress) {
  ASSERT_EQ(at(1.0, 0.0, 5.0), Verdict::kFine);
  ASSERT_EQ(at(6.0, 0.0, 4.95), Verdict::kFine);
  EXPECT_EQ(at(11.5, 0.0, 4.95), Verdict::kNoProgress);
}

TEST_F(ProgressWatchdogTest, AddsSmallStepsUpToProgress) {
  for (int i = 0; i <= 40; ++i) ASSERT_EQ(at(i, 0.02 * i, 5.0 - 0.02 * i), Verdict::kFine) << i;
}

TEST_F(ProgressWatchdogTest, MeasuresALongerPathAnewWithoutTakingItForProgress) {
  ASSERT_EQ(at(1.0, 0.0, 5.0), Verdict::kFine);
  watchdog.newPath(8.0);
  EXPECT_EQ(at(11.5, 0.0, 8.0), Verdict::kNoProgress);
  EXPECT_EQ(at(12.0, 0.0, 7.9), Verdict::kFine) << "nearer by that path";
}

TEST_F(ProgressWatchdogTest, SeesARobotThatComesNearerAllTheTimeAndStaysOnTheSpot) {
  Verdict verdict = Verdict::kFine;
  double seconds = 0.0;
  while (verdict == Verdict::kFine && seconds < 100.0) {
    seconds += 1.0;
    watchdog.newPath(5.0);
    verdict = at(seconds, 0.0, 4.0);
  }
  EXPECT_EQ(verdict, Verdict::kOscillating);
  EXPECT_NEAR(seconds, 30.5, 0.5);
}

TEST_F(ProgressWatchdogTest, HasMovedWhenItLeftTheCircleAroundWhereItBegan) {
  at(1.0, 0.5, 5.0);
  EXPECT_FALSE(watchdog.hasMoved()) << "on the circle";
  at(2.0, 0.51, 5.0);
  EXPECT_TRUE(watchdog.hasMoved());
  watchdog.restart(timeFromSeconds(3.0), Vec2(0.51, 0.0));
  EXPECT_FALSE(watchdog.hasMoved());
}

TEST_F(ProgressWatchdogTest, StartsAllOverWhenRestarted) {
  ASSERT_EQ(at(1.0, 0.0, 1.0), Verdict::kFine);
  ASSERT_EQ(at(50.0, 0.0, 1.0), Verdict::kNoProgress);
  watchdog.restart(timeFromSeconds(50.0), Vec2::Zero());
  EXPECT_EQ(at(55.0, 0.0, 20.0), Verdict::kFine) << "a goal far away is as good as any";
}

}  // namespace
}  // namespace frontier_pilot
