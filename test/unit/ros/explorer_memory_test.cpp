#include "ros/frontier_explorer/explorer_memory.h"

#include <gtest/gtest.h>

#include <string>

namespace frontier_pilot {
namespace {

// [EXP-10] [FLT-2]
TEST(ExplorerMemory, WritesBoundsSoThatTheyAreReadAsTheyWere_EXP_10_FLT_2) {
  exploration::ExplorationBounds bounds;
  EXPECT_TRUE(boundsIn(toText(bounds))->empty());
  bounds.stay_within = {{0.1, -2.0}, {1.0 / 3.0, 0.0}, {5.0, 7.25}};
  bounds.keep_out = {{{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}}, {{3.0, 3.0}, {4.0, 3.0}, {4.0, 4.0}, {3.0, 4.0}}};
  const auto read = boundsIn(toText(bounds));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->stay_within, bounds.stay_within);
  EXPECT_EQ(read->keep_out, bounds.keep_out);
}

// [FLT-1] The robot must not explore without the bounds that somebody has set.
TEST(ExplorerMemory, TakesNothingThatIsDamagedForBounds_FLT_1) {
  for (const char* text : {"", "x", "3 0 0 1 0", "0", "0 1", "0 99999999999999999999", "2 0 0 1 0 0", "0 0 more",
                           "3 0 0 1 0 nan 1 0", "3 0 0 1e300 0 1 1 0", "-1 0"}) {
    EXPECT_FALSE(boundsIn(text)) << text;
  }
}

}  // namespace
}  // namespace frontier_pilot
