#include "ros/common/hold_up_watch.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using std::chrono::milliseconds;

constexpr Duration kBacklog = milliseconds(200);
constexpr Duration kLongest = milliseconds(1000);

struct HoldUp : ::testing::Test {
  /// Looks every 20 ms for `time`; gives for how long of it the process was catching up.
  Duration run(Duration time) {
    Duration waited{};
    for (const SteadyTime end = now + time; now < end; now += milliseconds(20)) {
      if (watch.isCatchingUp(now)) waited += milliseconds(20);
    }
    return waited;
  }

  HoldUpWatch watch{kBacklog, kLongest};
  SteadyTime now{std::chrono::seconds(5)};
};

// [FLT-2]
TEST_F(HoldUp, AProcessThatRunsActsAtOnceAlsoAfterALateStart) {
  EXPECT_EQ(run(milliseconds(2000)), Duration::zero());
  now += milliseconds(200);
  EXPECT_EQ(run(milliseconds(500)), Duration::zero()) << "a short delay";
  EXPECT_EQ(watch.count(), 0);
}

// [FLT-2]
TEST_F(HoldUp, AProcessThatWasHeldUpReadsFirst) {
  run(milliseconds(100));
  now += milliseconds(400);
  EXPECT_EQ(run(milliseconds(1000)), kBacklog);
  EXPECT_EQ(watch.count(), 1);
  now += std::chrono::hours(10);
  EXPECT_EQ(run(milliseconds(1000)), kBacklog);
  EXPECT_EQ(watch.count(), 2);
}

// [FLT-2] A stop of the second time must be read before the process acts, too.
TEST_F(HoldUp, AProcessThatIsFrozenAgainWhileItCatchesUpReadsFirstAgain_FLT_2) {
  run(milliseconds(100));
  for (const Duration frozen : {milliseconds(2000), milliseconds(900)}) {
    now += milliseconds(2000);
    run(milliseconds(100));
    now += frozen;
    EXPECT_EQ(run(milliseconds(1000)), kBacklog);
  }
  EXPECT_EQ(watch.count(), 4);
}

// [FLT-2]
TEST_F(HoldUp, HoldUpsThatFollowEachOtherDoNotKeepAProcessFromActingForGood) {
  int acted = 0;
  for (int i = 0; i < 40; ++i) {  // 16 s
    acted += watch.isCatchingUp(now) ? 0 : 1;
    now += milliseconds(400);
  }
  EXPECT_GE(acted, 8);
  EXPECT_LE(acted, 16);
  EXPECT_EQ(watch.count(), 39);
}

}  // namespace
}  // namespace frontier_pilot
