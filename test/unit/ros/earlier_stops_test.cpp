#include "ros/common/inputs/earlier_stops.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

constexpr Duration kSecond = std::chrono::seconds(1);
constexpr SteadyTime kStart{std::chrono::hours(1)};

// [FLT-2]
TEST(EarlierStops, AreThoseThatTheArbiterCountsBeyondTheKnownOnes_FLT_2) {
  for (const std::uint64_t count : {2U, 3U, 0U}) {
    EarlierStops stops;
    stops.hear();
    stops.ask(2, Duration::max(), kStart);
    EXPECT_EQ(stops.take(count), count != 2U) << count << "; an arbiter that counts anew may have been asked for any";
    EXPECT_EQ(stops.take(count + 1), std::nullopt) << "answered once";
  }
}

// [FLT-2]
TEST(EarlierStops, AreNotToldByACountAfterWhichAStopCanBeMissed_FLT_2) {
  EarlierStops stops;
  stops.ask(0, Duration::max(), kStart);
  EXPECT_EQ(stops.take(0), std::nullopt) << "a stop and its clear may follow before the first message is heard";
  EXPECT_TRUE(stops.asks());
  stops.hear();
  EXPECT_EQ(stops.take(1), true);
}

TEST(EarlierStops, HoldBackTheNodeForAsLongAsItsPatienceLastsAndNoLongerThanTheyAreAskedFor) {
  EarlierStops stops;
  EXPECT_FALSE(stops.holdsBack(kStart)) << "nothing was asked";
  stops.ask(0, kSecond, kStart);
  EXPECT_TRUE(stops.holdsBack(kStart + kSecond / 2));
  EXPECT_FALSE(stops.holdsBack(kStart + kSecond));
  EXPECT_TRUE(stops.asks()) << "a late answer still counts";
  stops.ask(0, Duration::max(), kStart);
  EXPECT_TRUE(stops.holdsBack(kStart + 1000000 * kSecond));
  stops.dismiss();
  EXPECT_FALSE(stops.holdsBack(kStart));
  stops.hear();
  EXPECT_EQ(stops.take(1), std::nullopt);
}

}  // namespace
}  // namespace frontier_pilot
