#include "exploration/tour/best_look.h"

#include <gtest/gtest.h>

namespace frontier_pilot::exploration {
namespace {

/// A scanner that sees 90 degrees, on a view of 120 rays, 3 degrees apart.
ViewParameters narrowView() {
  ViewParameters view;
  view.field_of_view = 0.5 * kPi;
  return view;
}

Glimpse glimpseAt(double degrees, float area) {
  return {0, area, static_cast<std::uint16_t>(std::lround((degrees < 0.0 ? degrees + 360.0 : degrees) / 3.0))};
}

double degrees(double radians) { return radians * 180.0 / kPi; }

TEST(BestLook, ARobotThatSeesAllAroundMayArriveAsItComes_EXP_4) {
  const Look look = bestLook({glimpseAt(90.0, 1.0F)}, ViewParameters{});
  EXPECT_EQ(nearestYaw(look, 1.234), 1.234);
}

TEST(BestLook, ANarrowScannerLooksWhereMostIsSeen_EXP_4) {
  const std::vector<Glimpse> glimpses{glimpseAt(-9.0, 0.5F), glimpseAt(9.0, 0.5F), glimpseAt(180.0, 0.7F)};
  const Look look = bestLook(glimpses, narrowView());
  EXPECT_NEAR(degrees(look.yaw), 0.0, 1e-6) << "around the x axis as well";
  EXPECT_NEAR(degrees(look.slack), 36.0, 1e-6) << "half of the 90 degrees without the 18 that it has to show";
}

TEST(BestLook, ItTurnsNoFartherThanItHasTo_EXP_9) {
  const Look look = bestLook({glimpseAt(90.0, 1.0F)}, narrowView());
  EXPECT_NEAR(degrees(nearestYaw(look, 1.5)), degrees(1.5), 1e-6) << "already in the field of view";
  EXPECT_NEAR(degrees(nearestYaw(look, 0.0)), 45.0, 1e-6);
  EXPECT_NEAR(degrees(nearestYaw(look, kPi)), 135.0, 1e-6);
}

TEST(BestLook, AScannerThatLooksBackwardsIsTurnedTowardsIt_EXP_4) {
  ViewParameters view = narrowView();
  view.direction = kPi;
  const Look look = bestLook({glimpseAt(90.0, 1.0F)}, view);
  EXPECT_NEAR(degrees(look.yaw), -90.0, 1e-6);
}

}  // namespace
}  // namespace frontier_pilot::exploration
