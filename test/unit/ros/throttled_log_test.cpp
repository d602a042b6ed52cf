#include "ros/common/throttled_log.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

constexpr SteadyTime kStart = SteadyTime(std::chrono::hours(1));

TEST(LogThrottle, LetsOrdinaryWorkBeLoggedAsItIs) {
  LogThrottle throttle;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(throttle.admit(kStart + std::chrono::seconds(i)), 0U);
  }
  for (std::uint64_t i = 0; i + 1 < LogThrottle::kBurst; ++i)
    EXPECT_TRUE(throttle.admit(kStart + std::chrono::hours(1)));
}

// [FLT-1] what is refused is counted and named, and the log of it is bounded
TEST(LogThrottle, BoundsAFloodAndSaysHowMuchWasLeftOut_FLT_1) {
  LogThrottle throttle;
  std::uint64_t admitted = 0;
  std::uint64_t left_out = 0;
  for (int i = 0; i <= 100000; ++i) {  // for 100 s, a thousand lines a second
    if (const auto before = throttle.admit(kStart + std::chrono::milliseconds(i))) {
      ++admitted;
      left_out += *before;
    }
  }
  EXPECT_EQ(admitted, LogThrottle::kBurst + 100);
  EXPECT_EQ(left_out, 100001 - admitted);
}

TEST(LogThrottle, ForgetsNoPartOfAPeriod) {
  LogThrottle throttle;
  for (std::uint64_t i = 0; i < LogThrottle::kBurst; ++i) throttle.admit(kStart);
  int admitted = 0;
  for (int i = 1; i <= 100; ++i) admitted += throttle.admit(kStart + std::chrono::milliseconds(300 * i)) ? 1 : 0;
  EXPECT_EQ(admitted, 30);
}

// [FLT-1] what came in with a request can neither fill the log nor forge its lines
TEST(LogThrottle, KeepsALineALine_FLT_1) {
  EXPECT_EQ(throttledLine("saved floor", 0), "saved floor");
  EXPECT_EQ(throttledLine("saved floor", 7), "saved floor (7 similar lines suppressed before it)");
  EXPECT_EQ(throttledLine("a\n[ERROR] b\x1b[2J", 0), R"(a\n[ERROR] b\x1b[2J)");
  EXPECT_LT(throttledLine(std::string(1000000, 'x'), 0).size(), 600U);
  const std::string wide = throttledLine("x" + std::string(999, '\xc3') + std::string(1, '\xa9'), 0);
  EXPECT_LT(wide.size(), 600U);
}

}  // namespace
}  // namespace frontier_pilot
