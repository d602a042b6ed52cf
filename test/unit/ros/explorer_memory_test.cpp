#include "ros/frontier_explorer/explorer_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace frontier_pilot {
namespace {

// [EXP-10] [FLT-2]
TEST(ExplorerMemory, WritesOrdersSoThatTheyAreReadAsTheyWere_EXP_10_FLT_2) {
  exploration::ExplorationBounds bounds;
  bounds.stay_within = {{0.1, -2.0}, {1.0 / 3.0, 0.0}, {5.0, 7.25}};
  bounds.keep_out = {{{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}}, {{3.0, 3.0}, {4.0, 3.0}, {4.0, 4.0}, {3.0, 4.0}}};
  const Pose2 start(-3.25, 1.0 / 3.0, 2.5);
  const auto read = ordersIn(toText({bounds, true, start, "the time asked for has passed", 3}));
  ASSERT_TRUE(read && read->bounds);
  EXPECT_EQ(read->bounds->stay_within, bounds.stay_within);
  EXPECT_EQ(read->bounds->keep_out, bounds.keep_out);
  EXPECT_EQ(read->returns_to_start, true);
  EXPECT_EQ(read->start, start);
  EXPECT_EQ(read->ended, "the time asked for has passed");
  EXPECT_EQ(read->stops, 3U);
}

// [EXP-10] Bounds that were lifted are not those of the parameters, which hold while nobody has said anything.
TEST(ExplorerMemory, TellsWhatWasLiftedFromWhatWasNeverTold_EXP_10) {
  const auto untold = ordersIn(toText({}));
  ASSERT_TRUE(untold);
  EXPECT_FALSE(untold->bounds || untold->returns_to_start || untold->start || untold->ended || untold->stops);
  const auto lifted = ordersIn(toText({exploration::ExplorationBounds(), false, {}, {}, {}}));
  ASSERT_TRUE(lifted && lifted->bounds);
  EXPECT_TRUE(lifted->bounds->empty());
  EXPECT_EQ(lifted->returns_to_start, false);
}

// [FLT-1] The robot must not explore without the bounds that somebody has set.
TEST(ExplorerMemory, TakesNothingThatIsDamagedForOrders_FLT_1) {
  for (const char* text :
       {"", "x", "-", "- x", "b 3 0 0 1 0 -", "b 0 -", "b 0 1 -", "b 0 99999999999999999999 -", "b 2 0 0 1 0 0 -",
        "b 0 0", "- - @ 1 2", "- - @ 1 2 nan", "- - @ 1e300 2 3", "- - @ 1 -1e300 3 the end", "b 3 0 0 1 0 nan 1 0 -",
        "b 3 0 0 1e300 0 1 1 0 -", "b -1 0 -"}) {
    EXPECT_FALSE(ordersIn(text)) << text;
  }
}

// [ARB-8] [FLT-2]
TEST(ExplorerMemory, KnowsOfWhichStopsTheExplorerKnewAndThatTheRobotWasStopped_ARB_8_FLT_2) {
  for (const std::uint64_t stops : {std::uint64_t{0}, std::uint64_t{7}, ExplorerOrders::kStopped}) {
    ExplorerOrders orders;
    orders.stops = stops;
    EXPECT_EQ(ordersIn(toText(orders))->stops, stops);
  }
  for (const char* text : {"- - #", "- - #x", "- - @0 0 0 #99999999999999999999"}) EXPECT_FALSE(ordersIn(text)) << text;
}

}  // namespace
}  // namespace frontier_pilot
