// Where a robot is whose start nobody knows, by what its map and another one have in common.
#include "fleet/place/place_search.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "unit/fleet/furnished_hall.h"
#include "unit/fleet/seen_from.h"

namespace frontier_pilot {
namespace {

using fleet::PlaceMatch;
using fleet::PlaceSearch;
using test::emptyHall;
using test::expectNear;
using test::fill;
using test::furnished;
using test::kFirstStart;
using test::kSecondStart;

std::vector<PlaceMatch> matchesOf(const OccupancyGrid& one, const OccupancyGrid& two) {
  fleet::WindowRound all{100, {}, {}};
  return PlaceSearch(one, two).search(all);
}

// [MUL-1]
TEST(PlaceSearch, FindsHowTwoMapsOfOneBuildingLieToEachOther) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const OccupancyGrid world = furnished(seed);
    const OccupancyGrid one = test::seenFrom(world, kFirstStart, 6.0);
    const OccupancyGrid two = test::seenFrom(world, kSecondStart, 6.0);
    const std::vector<PlaceMatch> matches = matchesOf(one, two);
    ASSERT_GE(matches.size(), 2U) << seed;
    for (const PlaceMatch& match : matches) expectNear(match.T_a_b, kFirstStart.inverse() * kSecondStart);
  }
}

TEST(PlaceSearch, FindsNothingWhereTwoMapsShowDifferentPlaces) {
  const OccupancyGrid one = test::seenFrom(furnished(1), kFirstStart, 6.0);
  const OccupancyGrid two = test::seenFrom(furnished(2), kSecondStart, 6.0);
  EXPECT_TRUE(matchesOf(one, two).empty());
}

TEST(PlaceSearch, FindsNothingInMapsWithoutWallsOrWithoutCells) {
  const OccupancyGrid open(GridGeometry{0.05, Vec2::Zero(), 100, 100}, kFree);
  EXPECT_TRUE(matchesOf(open, open).empty());
  EXPECT_TRUE(matchesOf(OccupancyGrid(), OccupancyGrid()).empty());
}

// [MUL-1] Pillars on a lattice look the same from many places.
TEST(PlaceSearch, RefusesAPlaceThatFitsTwice) {
  OccupancyGrid world = emptyHall();
  for (int x = 20; x < 380; x += 30) {
    for (int y = 20; y < 280; y += 30) fill(world, {x, y, 8, 8});
  }
  const OccupancyGrid one = test::seenFrom(world, {8.0, 7.0, 0.0}, 5.0);
  const OccupancyGrid two = test::seenFrom(world, {11.0, 7.0, 0.0}, 5.0);
  EXPECT_TRUE(matchesOf(one, two).empty());
}

// [MUL-1] One robot has seen a wall of 10 cm from this side, the other one from that side as well.
TEST(PlaceSearch, DoesNotTakeOneSideOfAThinWallForTheOther) {
  OccupancyGrid world = furnished(4);
  fill(world, {200, 0, 2, 300});
  OccupancyGrid one = test::seenFrom(world, {7.0, 7.0, 0.0}, 6.0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one.geometry().centre(one.geometry().cell(i)).x() > 3.05) one[i] = kUnknown;  // beyond its side of the wall
  }
  const OccupancyGrid two = test::seenFrom(world, {9.5, 8.0, 0.7}, 6.0);
  const Pose2 truth = Pose2(7.0, 7.0, 0.0).inverse() * Pose2(9.5, 8.0, 0.7);
  const auto match = PlaceSearch(one, two).refine(truth * Pose2(0.05, -0.04, 0.01));
  ASSERT_TRUE(match);
  EXPECT_LT((match->T_a_b.position() - truth.position()).norm(), 0.02);
}

// [MUL-1] The range of a scanner ends short of many a wall, whose place it then knows to be free.
TEST(PlaceSearch, ExpectsNoWallWhereTheOtherMapEnds) {
  OccupancyGrid world = furnished(4);
  fill(world, {200, 0, 2, 300});
  OccupancyGrid one = test::seenFrom(world, {7.0, 7.0, 0.0}, 6.0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one.geometry().centre(one.geometry().cell(i)).x() > 3.0) one[i] = kUnknown;  // that wall, and what is behind it
  }
  const OccupancyGrid two = test::seenFrom(world, {6.0, 8.0, 0.7}, 6.0);
  const Pose2 truth = Pose2(7.0, 7.0, 0.0).inverse() * Pose2(6.0, 8.0, 0.7);
  EXPECT_TRUE(PlaceSearch(one, two).refine(truth));
}

// [MUL-1] Wherever along a corridor a window is thought to be, refining it on all that is known leads to the same
// place.
TEST(PlaceSearch, DoesNotTakeAPlaceForARivalOfItself) {
  OccupancyGrid world = emptyHall();
  fill(world, {0, 0, 400, 120});
  fill(world, {0, 160, 400, 140});
  std::mt19937 random(5);
  for (int i = 0; i < 6; ++i) {
    const int x = 80 + static_cast<int>(random() % 240U);
    const bool left = random() % 2U == 0;
    const int width = 3 + static_cast<int>(random() % 10U);
    fill(world, {x, left ? 152 : 120, width, 4 + static_cast<int>(random() % 5U)});
  }
  const Pose2 first(7.5, 7.0, 0.0);
  const Pose2 second(10.5, 7.1, 3.0);
  const OccupancyGrid one = test::seenFrom(world, first, 6.0);
  const OccupancyGrid two = test::seenFrom(world, second, 6.0);
  const std::vector<PlaceMatch> matches = matchesOf(one, two);
  EXPECT_GE(matches.size(), 8U);
  for (const PlaceMatch& match : matches) expectNear(match.T_a_b, first.inverse() * second);
}

}  // namespace
}  // namespace frontier_pilot
