#include "frontier_pilot/navigation/navigator_types.h"

#include <gtest/gtest.h>

#include <string>

namespace frontier_pilot::navigation {
namespace {

// [EXP-8] A client has nothing but the text of the result.
TEST(NavReason, TellsGoalsForWhichItCouldDriveNowhereFromPlacesThatItCannotReach_EXP_8) {
  EXPECT_TRUE(isUnableToDrive(NavReason::kNoScan));
  for (const std::string text : {"no scan", "lost pose", "no map", "not localised", "internal error"}) {
    EXPECT_TRUE(isUnableToDrive(text)) << text;
  }
  EXPECT_FALSE(isUnableToDrive(NavReason::kNoPath));
  for (const std::string text : {"no path", "blocked", "goal occupied", "start blocked", ""}) {
    EXPECT_FALSE(isUnableToDrive(text)) << text;
  }
}

}  // namespace
}  // namespace frontier_pilot::navigation
