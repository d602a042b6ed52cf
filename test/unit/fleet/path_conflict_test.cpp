#include "fleet/path_conflict.h"

#include <gtest/gtest.h>

#include "fleet/bay_search.h"
#include "support/ascii_world.h"

namespace frontier_pilot::fleet {
namespace {

/// A corridor of 0.6 m between two rooms, in cells of 10 cm.
const char* const kCorridor = R"(
  ##############################
  #........############........#
  #........############........#
  #........############........#
  #............................#
  #............................#
  #............................#
  #............................#
  #............................#
  #............................#
  #........############........#
  #........############........#
  #........############........#
  ##############################)";

constexpr double kMiddle = 0.7;  // [m]: height of the corridor's middle
const PassingRoom kBurgers{0.31, 0.87};

OccupancyGrid corridor() { return test::drawWorld(kCorridor, 0.1).map; }

// [MUL-3]
TEST(PathConflict, IsTheNarrowStretchThatBothWaysShareInOppositeDirections_MUL_3) {
  const auto met =
      findConflict({{0.5, kMiddle}, {2.5, kMiddle}}, {{2.5, kMiddle}, {0.5, kMiddle}}, kBurgers, corridor());
  ASSERT_TRUE(met.has_value());
  EXPECT_NEAR(met->own_entry, 0.4, 0.25);
  EXPECT_NEAR(met->own_exit, 1.6, 0.25);
  EXPECT_NEAR(met->other_exit, 1.6, 0.25);
}

// [MUL-3]
TEST(PathConflict, IsNoneOfRobotsThatFollowEachOther_MUL_3) {
  EXPECT_FALSE(findConflict({{0.5, kMiddle}, {2.5, kMiddle}}, {{1.0, kMiddle}, {2.5, kMiddle}}, kBurgers, corridor()));
}

// [MUL-3]
TEST(PathConflict, IsNoneWhereThereIsRoomForBoth_MUL_3) {
  const PassingRoom small{0.2, 0.5};
  EXPECT_FALSE(findConflict({{0.5, kMiddle}, {2.5, kMiddle}}, {{2.5, kMiddle}, {0.5, kMiddle}}, small, corridor()));
}

// [MUL-3]
TEST(PathConflict, IsNoneOfWaysThatDoNotMeet_MUL_3) {
  EXPECT_FALSE(findConflict({{0.3, 0.3}, {0.3, 1.1}}, {{2.5, kMiddle}, {1.2, kMiddle}}, kBurgers, corridor()));
}

// [MUL-3]
TEST(PathConflict, IsThereWhereARobotStandsInTheCorridor_MUL_3) {
  const auto met = findConflict({{0.5, kMiddle}, {2.5, kMiddle}}, {{1.5, kMiddle}}, kBurgers, corridor());
  ASSERT_TRUE(met.has_value());
  EXPECT_NEAR(met->own_entry, 0.8, 0.2);
}

TEST(PathConflict, WhatIsLeftOfAWayBeginsAtTheRobot) {
  const auto rest = remaining({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, {1.5, 0.1});
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0], Vec2(1.5, 0.1));
  EXPECT_EQ(rest[1], Vec2(2.0, 0.0));
}

// [MUL-3]
TEST(BaySearch, FindsTheNearestPlaceOffTheWay_MUL_3) {
  const std::vector<Vec2> way{{2.5, kMiddle}, {0.3, kMiddle}};
  const auto bay = findBay(corridor(), {1.2, kMiddle}, 0.1, {{way, 0.31}}, {});
  ASSERT_TRUE(bay.has_value());
  EXPECT_GE(distanceTo(way, *bay), 0.31);
  EXPECT_LT(bay->x(), 0.9) << "in the near room";
}

// [MUL-3]
TEST(BaySearch, FindsNoneBehindTheOtherRobotNorInUnknownSpace_MUL_3) {
  const std::vector<Vec2> way{{1.6, kMiddle}, {0.3, kMiddle}};
  EXPECT_FALSE(findBay(corridor(), {1.9, kMiddle}, 0.1, {{way, 5.0}}, {{{{1.6, kMiddle}}, 0.4}}));
  EXPECT_FALSE(findBay(OccupancyGrid(corridor().geometry(), kUnknown), {1.9, kMiddle}, 0.1, {{way, 0.3}}, {}));
}

// [FLT-1] Anybody can send the ways of a hundred robots.
TEST(BaySearch, MindsTheWaysOfTheTwentyNearestRobots_FLT_1) {
  const OccupancyGrid hall(GridGeometry{0.1, Vec2::Zero(), 300, 300}, kFree);
  const Vec2 here(15.0, 15.0);
  const std::vector<KeepOff> near(20, KeepOff{{here, {15.5, 15.0}}, 1.0});
  std::vector<KeepOff> all(80, KeepOff{{{20.0, 15.0}, {20.0, 16.0}}, 100.0});
  all.insert(all.begin() + 40, near.begin(), near.end());
  EXPECT_TRUE(findBay(hall, here, 0.1, near, {}));
  EXPECT_EQ(findBay(hall, here, 0.1, all, {}), findBay(hall, here, 0.1, near, {}));
}

// [FLT-1] In cells of 1 cm, each place costs a look at thousands of them.
TEST(BaySearch, LooksAtPlacesFiveCentimetresApartAndNotAtAnyNumberOfThem_FLT_1) {
  const OccupancyGrid hall(GridGeometry{0.01, Vec2::Zero(), 3000, 3000}, kFree);
  const Vec2 here(15.005, 15.005);
  const auto bay = findBay(hall, here, 0.1, {{{here}, 0.43}}, {});
  ASSERT_TRUE(bay);
  EXPECT_NEAR((*bay - here).norm(), 0.45, 1e-6) << "along an axis, in steps of 5 cm";
  EXPECT_TRUE(findBay(hall, here, 0.1, {{{here}, 4.0}}, {}));
  EXPECT_FALSE(findBay(hall, here, 0.1, {{{here}, 8.0}}, {})) << "beyond 40,000 places";
}

}  // namespace
}  // namespace frontier_pilot::fleet
