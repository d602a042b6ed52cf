#include "frontier_pilot/navigation/navigator_types.h"

#include <gtest/gtest.h>

#include <string>

namespace frontier_pilot::navigation {
namespace {

// [EXP-8] A client has nothing but the text of the result.
TEST(NavReason, TellsWhatIsNoFaultOfTheGoalFromPlacesThatItCannotReach_EXP_8) {
  EXPECT_TRUE(isNoFaultOfTheGoal(NavReason::kNoScan));
  for (const std::string text : {"no scan", "lost pose", "no map", "not localised", "the clock jumped",
                                 "internal error", "the map was replaced"}) {
    EXPECT_TRUE(isNoFaultOfTheGoal(text)) << text;
  }
  EXPECT_FALSE(isNoFaultOfTheGoal(NavReason::kNoPath));
  for (const std::string text : {"no path", "blocked", "goal occupied", "start blocked", ""}) {
    EXPECT_FALSE(isNoFaultOfTheGoal(text)) << text;
  }
}

}  // namespace
}  // namespace frontier_pilot::navigation
