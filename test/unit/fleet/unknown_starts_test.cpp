// When the map merger looks for the places of robots whose starts nobody knows, and what it believes.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "fleet/place/place_search.h"
#include "frontier_pilot/fleet/map_merger.h"
#include "unit/fleet/furnished_hall.h"
#include "unit/fleet/seen_from.h"

namespace frontier_pilot {
namespace {

using fleet::MapMerger;
using fleet::MergeState;
using fleet::PlaceMatch;
using fleet::PlaceSearch;
using test::expectNear;
using test::fill;
using test::furnished;
using test::kFirstStart;
using test::kSecondStart;

class UnknownStarts : public ::testing::Test {
 protected:
  static fleet::MapMergerParameters parameters(std::size_t count) {
    fleet::MapMergerParameters parameters;
    for (std::size_t i = 0; i < count; ++i) parameters.robots.push_back({"robot_" + std::to_string(i), 0.0, 0.0, 0.0});
    parameters.known_starts = false;
    return parameters;
  }
  void give(std::size_t robot, const OccupancyGrid& map) { merger_.setMap(robot, map, map.geometry().rect(), now_); }
  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      now_ += std::chrono::seconds(1);
      if (const auto work = merger_.takeWork(now_)) merger_.accept((*work)(), now_);
      merger_.update(now_);
    }
  }
  /// Gives both maps, and says whether they are merged after some searches.
  bool merge(const OccupancyGrid& one, const OccupancyGrid& two) {
    give(0, one);
    give(1, two);
    run(8);
    return merger_.status(1).state == MergeState::kMerged;
  }

  OccupancyGrid world_ = furnished(5);
  OccupancyGrid one_ = test::seenFrom(world_, kFirstStart, 6.0);
  OccupancyGrid two_ = test::seenFrom(world_, kSecondStart, 6.0);
  MapMerger merger_{parameters(2)};
  Time now_{std::chrono::seconds(100)};
};

// [MUL-1]
TEST_F(UnknownStarts, AreFoundOnceTheMapsOverlap) {
  const OccupancyGrid apart = test::seenFrom(world_, {17.0, 12.0, 1.0}, 2.0);
  give(0, one_);
  give(1, apart);
  run(5);
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
  ASSERT_TRUE(merge(one_, two_));
  expectNear(*merger_.place(1), kFirstStart.inverse() * kSecondStart);
}

// [MUL-1] A place at which nearly everything fits is not believed before more is known. Where rooms are alike but for
// their furniture, it is the wrong one.
TEST_F(UnknownStarts, AreNotFoundWhereAFewWallsLieInTheOthersFreeSpace) {
  const std::optional<PlaceMatch> exact = PlaceSearch(one_, two_).refine(kFirstStart.inverse() * kSecondStart);
  ASSERT_TRUE(exact);
  EXPECT_LT(exact->agreement.contradictedShare(), 0.005);
  OccupancyGrid refurnished = world_;
  fill(refurnished, {205, 150, 7, 7});
  const OccupancyGrid later = test::seenFrom(refurnished, kSecondStart, 6.0);
  const std::optional<PlaceMatch> match = PlaceSearch(one_, later).refine(kFirstStart.inverse() * kSecondStart);
  ASSERT_TRUE(match);
  ASSERT_GT(match->agreement.contradictedShare(), 0.01);
  EXPECT_FALSE(merge(one_, later));
}

// [MUL-1] The maps change as loops are closed, and a place with them.
TEST_F(UnknownStarts, AreCorrectedAsTheMapsAre) {
  const Pose2 corrected = kSecondStart * Pose2(0.06, -0.05, 0.02);
  const OccupancyGrid later = test::seenFrom(world_, corrected, 6.0);
  ASSERT_TRUE(merge(one_, two_));
  give(1, later);
  run(3);
  expectNear(*merger_.place(1), kFirstStart.inverse() * corrected);
}

// [MUL-1]
TEST_F(UnknownStarts, ArePartOfTheSearchAgainAfterAMergeWasGivenUp) {
  const OccupancyGrid elsewhere = test::seenFrom(furnished(6), kSecondStart, 6.0);
  ASSERT_TRUE(merge(one_, two_));
  give(1, elsewhere);
  run(3);
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
  EXPECT_TRUE(merge(one_, two_));
}

// [MUL-1] The third robot shares ground with the first one only; windows of its map and of that one are searched for
// by turns all the same.
TEST_F(UnknownStarts, AreFoundInTheMapOfOneOfSeveralRobots) {
  const Pose2 first(10.0, 7.0, 0.4), second(15.0, 8.0, 1.0), third(4.0, 7.0, -2.0);
  merger_ = MapMerger(parameters(3));
  give(0, test::seenFrom(world_, first, 12.0));
  give(1, test::seenFrom(world_, second, 5.0));
  run(12);
  ASSERT_EQ(merger_.status(1).state, MergeState::kMerged);
  give(2, test::seenFrom(world_, third, 5.0));
  run(24);
  ASSERT_EQ(merger_.status(2).state, MergeState::kMerged);
  expectNear(*merger_.place(2), first.inverse() * third);
}

// [MUL-1] A robot that was carried elsewhere and started again begins its map where it is then.
TEST_F(UnknownStarts, AreNotKnownAnyMoreOfARobotThatBeginsAnotherMap) {
  ASSERT_TRUE(merge(one_, two_));
  give(1, test::seenFrom(world_, {17.0, 12.0, 1.0}, 2.0));
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
  EXPECT_TRUE(merge(one_, two_));
  give(1, test::seenFrom(world_, kSecondStart, 6.5));
  EXPECT_EQ(merger_.status(1).state, MergeState::kMerged) << "it has grown";
  give(1, two_);
  EXPECT_EQ(merger_.status(1).state, MergeState::kMerged) << "drawn anew, it reaches a little less far";
}

/// `map` in the middle of a box of 20 m, in steps of which a mapper's map grows.
OccupancyGrid boxed(const OccupancyGrid& map) {
  OccupancyGrid box(GridGeometry{0.05, Vec2(-10.0, -10.0), 400, 400}, kUnknown);
  for (std::size_t i = 0; i < map.size(); ++i)
    box[box.geometry().cellAt(map.geometry().centre(map.geometry().cell(i)))] = map[i];
  return box;
}

// [MUL-1]
TEST_F(UnknownStarts, AreNotKnownAnyMoreOfARobotWhoseOtherMapHasTheSameExtent) {
  ASSERT_TRUE(merge(boxed(one_), boxed(two_)));
  give(1, boxed(test::seenFrom(world_, {17.0, 12.0, 1.0}, 6.0)));
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
}

// [MUL-1] All places are in the frame of the first robot's map.
TEST_F(UnknownStarts, AreAllUnknownOnceTheFirstRobotBeginsAnotherMap) {
  ASSERT_TRUE(merge(one_, two_));
  give(0, test::seenFrom(world_, {17.0, 12.0, 1.0}, 2.0));
  EXPECT_EQ(merger_.status(0).state, MergeState::kMerged);
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
}

/// `map` and, beside it, a copy of it.
OccupancyGrid twice(const OccupancyGrid& map) {
  const GridGeometry& geometry = map.geometry();
  OccupancyGrid both(GridGeometry{geometry.resolution, geometry.origin, 2 * geometry.width, geometry.height}, kUnknown);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = geometry.cell(i);
    both[cell] = both[Cell{cell.x + geometry.width, cell.y}] = map[i];
  }
  return both;
}

// [MUL-1] The second robot has been in two rooms that look like the one in which the first has been.
TEST_F(UnknownStarts, AreNotFoundByARoomThatIsThereTwice) { EXPECT_FALSE(merge(one_, twice(one_))); }

// [MUL-1] The first robot has been in two rooms that look like the one in which the second has been.
TEST_F(UnknownStarts, AreNotFoundInARoomThatIsThereTwice) { EXPECT_FALSE(merge(twice(one_), one_)); }

// [MUL-1]
TEST_F(UnknownStarts, AreNotLookedForTwiceAtATime) {
  give(0, one_);
  give(1, two_);
  const auto work = merger_.takeWork(now_);
  ASSERT_TRUE(work);
  EXPECT_FALSE(merger_.takeWork(now_ + std::chrono::seconds(5)));
  merger_.accept({}, now_);
  EXPECT_TRUE(merger_.takeWork(now_ + std::chrono::seconds(5)));
}

// [MUL-1] A search of large maps takes longer than the time between two of small ones.
TEST_F(UnknownStarts, AreLookedForWithAPauseHoweverLongASearchTakes) {
  give(0, one_);
  give(1, two_);
  ASSERT_TRUE(merger_.takeWork(now_));
  merger_.accept({}, now_ + std::chrono::seconds(5));
  EXPECT_FALSE(merger_.takeWork(now_ + std::chrono::milliseconds(6900)));
  EXPECT_TRUE(merger_.takeWork(now_ + std::chrono::seconds(7)));
}

// [FLT-1] The end of a node does not wait for a search.
TEST_F(UnknownStarts, AreNoLongerLookedForOnceTheSearchIsStopped_FLT_1) {
  give(0, one_);
  give(1, two_);
  int asked = 0;
  const auto whole = merger_.takeWork(now_, [&] { return ++asked < 0; });
  ASSERT_TRUE(whole);
  EXPECT_FALSE((*whole)().matches.empty());
  EXPECT_GT(asked, 100);
  merger_.accept({}, now_);
  const int most = asked / 2;
  asked = 0;
  const auto stopped = merger_.takeWork(now_ + std::chrono::seconds(5), [&] { return ++asked > most; });
  ASSERT_TRUE(stopped);
  (*stopped)();
  EXPECT_GT(asked, most) << "it ended before it was stopped";
  EXPECT_LT(asked, most + 10);
}

/// A free map with a wall in each of two opposite corners; `side` and `cell` in metres.
OccupancyGrid wideMap(double side, double cell) {
  const int cells = static_cast<int>(std::lround(side / cell));
  OccupancyGrid map(GridGeometry{cell, Vec2::Zero(), cells, cells}, kFree);
  map[Cell{0, 0}] = map[Cell{cells - 1, cells - 1}] = kOccupied;
  return map;
}

// [FLT-1] The search needs memory for the ground between the walls, and a few cells of a map may be very large.
TEST_F(UnknownStarts, AreNotLookedForWhereTheWallsLieTooFarApart_FLT_1) {
  for (const std::size_t wide : {1U, 0U}) {
    give(wide, wideMap(400.0, 1.0));
    give(1 - wide, wideMap(20.0, 1.0));
    EXPECT_FALSE(merger_.takeWork(now_));
    EXPECT_EQ(merger_.status(1).state, MergeState::kTooLargeToSearch);
    give(1, merger_.view(1).map());
    EXPECT_EQ(merger_.status(1).state, MergeState::kTooLargeToSearch) << "until there is another one";
    now_ += std::chrono::seconds(5);
  }
  give(0, wideMap(300.0, 1.0));
  give(1, wideMap(300.0, 1.0));
  EXPECT_TRUE(merger_.takeWork(now_));
  EXPECT_EQ(merger_.status(1).state, MergeState::kPlaceUnknown);
}

// [FLT-1]
TEST_F(UnknownStarts, AreNotLookedForInAMapOfNoise_FLT_1) {
  OccupancyGrid noise(GridGeometry{0.05, Vec2::Zero(), 1500, 1500}, kFree);
  for (std::size_t i = 0; i < noise.size(); i += 2) noise[i] = kOccupied;
  give(0, one_);
  give(1, noise);
  EXPECT_FALSE(merger_.takeWork(now_));
  EXPECT_EQ(merger_.status(1).state, MergeState::kTooLargeToSearch);
}

// [MUL-1] Maps whose cells differ in size cannot be put together, wherever the robot is.
TEST_F(UnknownStarts, AreNotLookedForInCellsOfAnotherSize) {
  give(0, one_);
  give(1, wideMap(20.0, 0.1));
  EXPECT_FALSE(merger_.takeWork(now_));
  EXPECT_EQ(merger_.status(1).state, MergeState::kOtherResolution);
  EXPECT_TRUE(merge(one_, two_));
}

}  // namespace
}  // namespace frontier_pilot
