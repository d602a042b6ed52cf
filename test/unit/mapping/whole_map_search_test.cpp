#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/mapper.h"
#include "known_rooms.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"
#include "unlike_rooms.h"

namespace frontier_pilot::test {
namespace {

constexpr const char* kTwins = R"(
  #########################
  #...........#...........#
  #...........#...........#
  #...........#...........#
  #.....##....#.....##....#
  #...........#...........#
  #...........#...........#
  #########################
)";

/// `world` in cells of 5 cm.
OccupancyGrid fineMapOf(const AsciiWorld& world) {
  OccupancyGrid map(GridGeometry{0.05, {0.0, 0.0}, 4 * world.map.width(), 4 * world.map.height()}, kFree);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    map[i] = world.map[Cell{cell.x / 4, cell.y / 4}];
  }
  return map;
}

localization::WholeMapSearch searchFor(const AsciiWorld& world, const OccupancyGrid& map, const Pose2& T_map_base) {
  Scanner scanner(world.solid(), 0.01);
  const surfaces::SurfaceScan scan = surfaces::readScan(scanner.scan(T_map_base, Time{}));
  return localization::searchWholeMap(map, {{scan.points, Pose2()}}, {});
}

// [MAP-5]
TEST(WholeMapSearch, FindsTheRobotWhereverItStandsAndWhicheverWayItLooks_MAP_5) {
  const AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  const OccupancyGrid map = fineMapOf(world);
  for (const Pose2& pose : {Pose2(1.8, 1.0, 0.3), Pose2(3.2, 0.8, -2.8), Pose2(5.0, 1.4, 1.6), Pose2(7.3, 0.6, 3.1)}) {
    const localization::WholeMapSearch search = searchFor(world, map, pose);
    ASSERT_EQ(search.verdict, localization::SearchVerdict::kFound) << describe(search);
    EXPECT_FALSE(isJump(pose, search.best.T_map_base, 0.05, 0.02)) << describe(search);
    EXPECT_GT(search.best.inliers, 0.8);
  }
}

// [MAP-5]
TEST(WholeMapSearch, RefusesToChooseBetweenTwoPlacesThatLookAlike_MAP_5) {
  const AsciiWorld world = drawWorld(kTwins, 0.2);
  const localization::WholeMapSearch search = searchFor(world, fineMapOf(world), {0.8, 0.9, 0.5});
  EXPECT_EQ(search.verdict, localization::SearchVerdict::kAmbiguous);
  EXPECT_NE(describe(search).find("two places look alike"), std::string::npos) << describe(search);
  EXPECT_TRUE(isJump(search.best.T_map_base, search.rival.T_map_base, 0.5, 0.3));
}

// [MAP-5]
TEST(WholeMapSearch, SaysWhyItFindsNothing_MAP_5) {
  const AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  const AsciiWorld elsewhere = drawWorld(kTwins, 0.2);
  EXPECT_EQ(searchFor(elsewhere, fineMapOf(world), {1.0, 0.5, 0.0}).verdict, localization::SearchVerdict::kFitsNowhere);
  EXPECT_EQ(searchFor(world, OccupancyGrid(), {1.8, 1.0, 0.0}).verdict, localization::SearchVerdict::kNoMap);
  EXPECT_EQ(localization::searchWholeMap(fineMapOf(world), {}, {}).verdict, localization::SearchVerdict::kTooFew);
}

// [MAP-5]
TEST(WholeMapSearch, EndsWhenItIsStopped_MAP_5) {
  const AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  Scanner scanner(world.solid(), 0.01);
  const surfaces::SurfaceScan scan = surfaces::readScan(scanner.scan({1.8, 1.0, 0.3}, Time{}));
  const OccupancyGrid map = fineMapOf(world);
  int asked = 0;
  const auto after = [&asked](int most) { return [&asked, most] { return ++asked > most; }; };
  for (const int most : {0, 1, 1000}) {
    asked = 0;
    const auto search = localization::searchWholeMap(map, {{scan.points, Pose2()}}, {}, after(most));
    EXPECT_EQ(search.verdict, localization::SearchVerdict::kStopped) << describe(search);
    EXPECT_LE(asked, most + 4) << "each part of the search asks once more";
    EXPECT_NE(describe(search).find("took too long"), std::string::npos) << describe(search);
  }
}

// [MAP-5]
TEST(WholeMapSearch, IsRepeatable_MAP_5) {
  const AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  const OccupancyGrid map = fineMapOf(world);
  EXPECT_EQ(describe(searchFor(world, map, {5.0, 1.4, 1.6})), describe(searchFor(world, map, {5.0, 1.4, 1.6})));
}

/// A mapper that only localises on the rooms, of which it knows nothing but the map, and a robot in them.
class LostMapper : public ::testing::Test {
 protected:
  LostMapper() : world(drawWorld(kUnlikeRooms, 0.2)), scanner(world.solid(), 0.01), mapper(localizing()) {
    occupancy::OccupancyMap rooms = test::knownMapOf(world);
    EXPECT_TRUE(mapper.load(rooms));
  }
  static mapping::MapperParameters localizing() {
    mapping::MapperParameters parameters;
    parameters.localize_only = true;
    return parameters;
  }
  /// Drives `steps` times `step` [m] ahead; odometry begins at zero where the robot begins.
  void drive(int steps, double step = 0.05) {
    for (int i = 0; i < steps; ++i) {
      T_odom_base.x += step;
      seconds += 0.6;
      const Time now = timeFromSeconds(seconds);
      verdict = mapper.insert(scanner.scan(T_world_odom * T_odom_base, now), T_odom_base, now);
    }
  }

  AsciiWorld world;
  Scanner scanner;
  mapping::Mapper mapper;
  Pose2 T_world_odom{6.8, 0.8, 2.9};
  Pose2 T_odom_base;
  double seconds = 1.0;
  mapping::ScanVerdict verdict = mapping::ScanVerdict::kInserted;
};

// [MAP-5]
TEST_F(LostMapper, SaysThatItNeedsAPose_MAP_5) {
  mapper.locate({{1.0, 2.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4});  // where it is not
  drive(20);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated);
  const char* expected = "not localised: the scan fits nowhere on the map here; give a pose, or call mapper/localize";
  EXPECT_STREQ(toString(verdict), expected);
  const auto remark = mapper.remark(timeFromSeconds(seconds));
  ASSERT_TRUE(remark);
  EXPECT_EQ(remark->text, expected);
}

// [MAP-5]
TEST_F(LostMapper, GoesOnFromWhereTheSearchHasFoundTheRobotAlsoIfItHasDrivenOn_MAP_5) {
  drive(10);
  const auto work = mapper.searchWork();
  drive(15);
  const mapping::RobotSearch search = work();
  ASSERT_EQ(search.result.verdict, localization::SearchVerdict::kFound) << describe(search.result);
  ASSERT_TRUE(mapper.locate(search));
  drive(3);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kLocalized);
  EXPECT_FALSE(isJump(T_world_odom, mapper.T_map_odom(), 0.06, 0.03));
}

// [MAP-5] The scans from before fit well where the robot was, and odometry shows nothing.
TEST_F(LostMapper, IsFoundWhereItHasBeenCarriedToAndNotWhereItWas_MAP_5) {
  drive(80);
  ASSERT_EQ(mapper.searchWork()().result.verdict, localization::SearchVerdict::kFound);
  const Pose2 carried(1.8, 1.0, 0.3);
  T_world_odom = carried * T_odom_base.inverse();
  drive(3, 0.0);
  const localization::WholeMapSearch search = mapper.searchWork()().result;
  ASSERT_EQ(search.verdict, localization::SearchVerdict::kFound) << describe(search);
  EXPECT_FALSE(isJump(carried, search.best.T_map_base, 0.05, 0.02)) << describe(search);
}

// [MAP-5]
TEST_F(LostMapper, TakesOverNothingFromASearchOfAMapThatItHasForgottenSince_MAP_5) {
  mapper = mapping::Mapper();
  occupancy::OccupancyMap rooms = test::knownMapOf(world);
  ASSERT_TRUE(mapper.load(rooms));
  drive(10);
  const mapping::RobotSearch search = mapper.searchWork()();
  ASSERT_EQ(search.result.verdict, localization::SearchVerdict::kFound) << describe(search.result);
  EXPECT_EQ(search.generation, mapper.generation());
  mapper.reset();
  drive(1);
  ASSERT_EQ(verdict, mapping::ScanVerdict::kInserted) << "into a new map";
  EXPECT_FALSE(mapper.locate(search));
  EXPECT_NE(search.generation, mapper.generation()) << "why";
}

// [MAP-5]
TEST_F(LostMapper, TakesOverNothingWhileItHasNoScanSinceItsClockWasSetBack_MAP_5) {
  drive(10);
  const mapping::RobotSearch search = mapper.searchWork()();
  ASSERT_EQ(search.result.verdict, localization::SearchVerdict::kFound) << describe(search.result);
  mapper.insert({}, T_odom_base, timeFromSeconds(1.0));
  EXPECT_FALSE(mapper.locate(search));
  EXPECT_EQ(search.generation, mapper.generation()) << "the map is still the same";
}

// [MAP-5]
TEST_F(LostMapper, TakesOverNothingFromASearchOfAMapThatAnotherHasReplacedSince_MAP_5) {
  drive(10);
  const auto work = mapper.searchWork();
  occupancy::OccupancyMap another = test::knownMapOf(world);
  ASSERT_TRUE(mapper.load(another));
  drive(1);
  EXPECT_FALSE(mapper.locate(work()));
  occupancy::OccupancyMap third = test::knownMapOf(world);
  const auto second_work = mapper.searchWork();
  ASSERT_TRUE(mapper.resume(third, Pose2(), T_odom_base, true));
  drive(1);
  EXPECT_FALSE(mapper.locate(second_work()));
}

// [MAP-5]
TEST_F(LostMapper, TakesOverNothingFromASearchThatDidNotFindTheRobot_MAP_5) {
  const mapping::RobotSearch search = mapper.searchWork()();
  EXPECT_EQ(search.result.verdict, localization::SearchVerdict::kTooFew) << "there was no scan yet";
  EXPECT_FALSE(mapper.locate(search));
}

TEST(WholeMapSearch, SaysWhatCameOfIt) {
  using localization::SearchVerdict;
  localization::WholeMapSearch search;
  search.best.T_map_base = {1.0, 2.0, 0.0};
  const auto said = [&](SearchVerdict verdict) {
    search.verdict = verdict;
    return describe(search);
  };
  EXPECT_EQ(said(SearchVerdict::kFound).find("found the robot at "), 0U);
  EXPECT_EQ(said(SearchVerdict::kNoMap), "refused: there is no map to look on");
  EXPECT_EQ(said(SearchVerdict::kTooFew), "refused: there is no scan yet, or it has too few returns");
  EXPECT_EQ(said(SearchVerdict::kFitsNowhere), "refused: the scan fits nowhere on the map");
}

}  // namespace
}  // namespace frontier_pilot::test
