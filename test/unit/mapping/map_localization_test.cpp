#include "frontier_pilot/localization/map_localization.h"

#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/mapper.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"
#include "unlike_rooms.h"

namespace frontier_pilot::test {
namespace {

/// The rooms, a scanner in them, and a mapper that gets no more than a real robot provides.
class MapLocalizationTest : public ::testing::Test {
 protected:
  MapLocalizationTest() : world(drawWorld(kUnlikeRooms, 0.2)), scanner(world.solid(), 0.01) {}

  void scan(mapping::Mapper& mapper) {
    const auto stamp = timeFromSeconds(seconds += 0.6);
    verdict = mapper.insert(scanner.scan(T_world_base, stamp), T_odom_base, stamp);
    mapper.reviseNow();
  }
  /// The robot goes from one pose to the other, in steps of 5 cm; odometry begins at zero at the start.
  void drive(mapping::Mapper& mapper, const Pose2& from, const Pose2& to) {
    const double length = (to.position() - from.position()).norm();
    const int steps = std::max(5, static_cast<int>(length / 0.05));
    for (int i = 0; i <= steps; ++i) {
      T_world_base = interpolate(from, to, static_cast<double>(i) / steps);
      T_odom_base = from.inverse() * T_world_base;
      scan(mapper);
    }
  }
  /// The robot goes on by a metre along x.
  void goOn(mapping::Mapper& mapper) {
    const Pose2 T_world_odom = T_world_base * T_odom_base.inverse();
    for (int i = 0; i < 20; ++i) {
      T_world_base.x += 0.05;
      T_odom_base = T_world_odom.inverse() * T_world_base;
      scan(mapper);
    }
  }
  /// A mapper that knows the rooms; its map begins where the world does.
  mapping::Mapper knowing(bool localize_only, bool trust_odometry = false) {
    mapping::MapperParameters parameters;
    parameters.localize_only = localize_only;
    parameters.trust_odometry = trust_odometry;
    mapping::Mapper mapper(parameters);
    occupancy::OccupancyMap map(parameters.map);
    EXPECT_EQ(map.reserve({0.0, 0.0}, 0.2 * Vec2(world.map.width(), world.map.height())), occupancy::MapRoom::kEnough);
    for (int certainty = 0; certainty < 10; ++certainty) draw(map);
    EXPECT_TRUE(mapper.load(map));
    return mapper;
  }
  void draw(occupancy::OccupancyMap& rooms) const {
    rooms.beginScan();
    for (int y = 0; y < 4 * world.map.height(); ++y) {
      for (int x = 0; x < 4 * world.map.width(); ++x) {
        const Cell cell = rooms.geometry().cellAt({0.05 * (x + 0.5), 0.05 * (y + 0.5)});
        world.map[Cell{x / 4, y / 4}] == kOccupied ? rooms.hit(cell) : rooms.miss(cell);
      }
    }
  }
  static scan_matching::PoseWithCovariance about(const Pose2& pose) {
    return {pose, Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal()};
  }
  void expectKnown(const mapping::Mapper& mapper, double distance) const {
    const Pose2 T_map_base = mapper.T_map_odom() * T_odom_base;
    EXPECT_TRUE(mapper.isLocalized() && !isJump(T_world_base, T_map_base, distance, 0.03))
        << T_map_base.x << " " << T_map_base.y << " " << T_map_base.yaw;
  }

  AsciiWorld world;
  Scanner scanner;
  Pose2 T_world_base;
  Pose2 T_odom_base;
  double seconds = 1.0;
  mapping::ScanVerdict verdict = mapping::ScanVerdict::kInserted;
};

// [MAP-5]
TEST_F(MapLocalizationTest, FindsTheRobotNearWhereItIsSaidToBeAndLeavesTheMapAsItIs_MAP_5) {
  mapping::Mapper mapper = knowing(true);
  const auto before = mapper.grid().cells();
  mapper.locate(about({4.3, 1.0, -0.3}));
  drive(mapper, {4.0, 1.2, 0.0}, {6.5, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kLocalized);
  expectKnown(mapper, 0.05);
  EXPECT_TRUE(mapper.grid().cells() == before);
  EXPECT_EQ(mapper.counts()[mapping::ScanVerdict::kInserted], 0U);
}

// [MAP-5]
TEST_F(MapLocalizationTest, DoesNotFindItWhereItIsNot_MAP_5) {
  mapping::Mapper mapper = knowing(true);
  mapper.locate({{1.0, 2.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4});
  drive(mapper, {6.0, 0.8, 1.0}, {6.4, 0.8, 1.0});
  EXPECT_TRUE(verdict == mapping::ScanVerdict::kNotLocated && !mapper.isLocalized());
}

// [MAP-5]
TEST_F(MapLocalizationTest, WithoutAMapThereIsNothingToLocaliseOn_MAP_5) {
  mapping::MapperParameters parameters;
  parameters.localize_only = true;
  mapping::Mapper mapper(parameters);
  drive(mapper, {4.0, 1.2, 0.0}, {4.5, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated);
  EXPECT_TRUE(mapper.grid().empty());
}

// [MAP-5]
TEST_F(MapLocalizationTest, GoesOnMappingUponALoadedMapAndLosesNothing_MAP_5) {
  mapping::Mapper mapper = knowing(false);
  mapper.locate(about({4.3, 1.0, -0.2}));
  world.map[Cell{30, 4}] = kOccupied;  // something new
  scanner = Scanner(world.solid(), 0.01);
  drive(mapper, {4.0, 1.2, 0.0}, {5.2, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  expectKnown(mapper, 0.05);
  const auto valueAt = [&](const Vec2& point) { return mapper.grid()[mapper.grid().geometry().cellAt(point)]; };
  EXPECT_EQ(valueAt({6.02, 0.9}), kOccupied) << "what is new is in the map";
  EXPECT_EQ(valueAt({1.1, 1.3}), kFree) << "what was known stays";
  EXPECT_EQ(valueAt({0.9, 0.9}), kOccupied);
  EXPECT_FALSE(mapper.trajectory().empty());
}

// [MAP-5]
TEST_F(MapLocalizationTest, APoseThatIsSaidToBeCertainIsLookedForAllTheSame_MAP_5) {
  mapping::Mapper mapper = knowing(true);
  mapper.locate({{4.05, 1.17, 0.02}, Eigen::Matrix3d::Zero()});
  drive(mapper, {4.0, 1.2, 0.0}, {4.5, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kLocalized);
  expectKnown(mapper, 0.05);
}

// [MAP-5]
TEST_F(MapLocalizationTest, OdometryThatIsTrustedIsTrustedFromWhereTheRobotWasFound_MAP_5) {
  mapping::Mapper mapper = knowing(false, true);
  mapper.locate(about({4.3, 1.0, -0.2}));
  drive(mapper, {4.0, 1.2, 0.0}, {4.2, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  expectKnown(mapper, 0.05);
  const Pose2 found = mapper.T_map_odom();
  drive(mapper, {4.0, 1.2, 0.0}, {5.2, 1.2, 0.0});
  EXPECT_EQ(mapper.T_map_odom(), found);
  EXPECT_TRUE(mapper.trajectory().empty()) << "no graph";
}

// [MAP-5]
TEST_F(MapLocalizationTest, WithoutAnythingInTheMapThereIsNoPlaceToLookForTheRobotIn_MAP_5) {
  mapping::Mapper mapper;
  EXPECT_FALSE(mapper.locate(about({4.0, 1.2, 0.0})));
  drive(mapper, {4.0, 1.2, 0.0}, {4.5, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted) << "and mapping goes on";
  EXPECT_TRUE(mapper.locate(about({0.5, 0.0, 0.0})));
}

TEST_F(MapLocalizationTest, AResetForgetsAlsoWhatWasLoaded) {
  mapping::Mapper mapper = knowing(false);
  mapper.reset();
  drive(mapper, {4.0, 1.2, 0.0}, {4.5, 1.2, 0.0});
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  EXPECT_FALSE(isJump(mapper.T_map_odom(), Pose2(), 0.02, 0.02)) << "a map of its own, from where the robot is";
}

// [MAP-5]
TEST_F(MapLocalizationTest, ALoadedMapIsNoLargerThanItself_MAP_5) {
  mapping::Mapper mapper = knowing(false);
  const GridGeometry rooms = mapper.map().geometry();
  occupancy::OccupancyMap far_away;
  ASSERT_EQ(far_away.reserve({-301.0, -301.0}, {-299.0, -299.0}), occupancy::MapRoom::kEnough);
  far_away.beginScan();
  const Cell wall = far_away.geometry().cellAt({-300.0, -300.0});
  far_away.hit(wall);
  far_away.miss({wall.x + 1, wall.y});
  ASSERT_TRUE(mapper.load(far_away));
  EXPECT_LT(mapper.map().geometry().size(), 1'000'000U);
  mapping::Mapper again = knowing(false);
  ASSERT_TRUE(mapper.load(again.map()));
  EXPECT_EQ(mapper.map().geometry(), rooms);
}

TEST_F(MapLocalizationTest, WorkFromBeforeALoadedMapIsVoid_MAP_5) {
  mapping::Mapper mapper;
  drive(mapper, {4.0, 1.2, 0.0}, {4.2, 1.2, 0.0});
  seconds += 0.6;
  mapper.insert(scanner.scan({4.5, 1.2, 0.0}, timeFromSeconds(seconds)), Pose2(0.5, 0.0, 0.0),
                timeFromSeconds(seconds));
  const slam::RevisionWork work = mapper.takeWork();
  ASSERT_TRUE(work);
  mapping::Mapper other = knowing(false);
  ASSERT_TRUE(mapper.load(other.map()));
  slam::MapRevision revision = work();
  EXPECT_FALSE(mapper.revise(revision));
}

// [FLT-1]
TEST_F(MapLocalizationTest, KeepsScansToCloseLoopsWithUntilAMapIsLoadedAndNoneWhereItOnlyLocalises_FLT_1) {
  mapping::Mapper mapper;
  drive(mapper, {4.0, 1.2, 0.0}, {5.0, 1.2, 0.0});
  EXPECT_GE(mapper.keyframes(), 4U) << "one for each 0.2 m";
  EXPECT_EQ(mapper.keyframes(), mapper.trajectory().size());
  mapping::Mapper other = knowing(false);
  ASSERT_TRUE(mapper.load(other.map()));
  EXPECT_EQ(mapper.keyframes(), 0U);
  mapping::Mapper knows = knowing(true);
  drive(knows, {4.0, 1.2, 0.0}, {5.0, 1.2, 0.0});
  EXPECT_EQ(knows.keyframes(), 0U);
}

// [FLT-2]
TEST_F(MapLocalizationTest, AMapperThatIsStartedAgainGoesOnWithTheMapAndThePoseThatItHad_FLT_2) {
  mapping::Mapper first;
  drive(first, {1.0, 1.0, 0.0}, {2.0, 1.0, 0.0});
  occupancy::OccupancyMap kept(first.map().parameters());
  std::stringstream bytes;
  ASSERT_TRUE(first.map().write(bytes));
  std::string why;
  ASSERT_TRUE(kept.read(bytes.str(), why)) << why;
  const auto known = [](const mapping::Mapper& mapper) {
    const auto& cells = mapper.grid().cells();
    return std::count_if(cells.begin(), cells.end(), [](auto cell) { return !isUnknown(cell); });
  };
  const auto before = known(first);
  mapping::Mapper second;
  ASSERT_TRUE(second.resume(kept, first.T_map_odom(), T_odom_base, true));
  EXPECT_GE(known(second), before) << "[FLT-2]";
  goOn(second);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  // The first one's map begins where odometry does.
  EXPECT_FALSE(isJump(T_odom_base, second.T_map_odom() * T_odom_base, 0.05, 0.03));
}

// [FLT-2]
TEST_F(MapLocalizationTest, AMapperThatDiedBeforeItSawAnyWallGoesOnMapping_FLT_2) {
  for (const bool trust_odometry : {false, true}) {
    mapping::MapperParameters parameters;
    parameters.trust_odometry = trust_odometry;
    mapping::Mapper first(parameters);
    scanner = Scanner(Grid<std::uint8_t>(world.map.geometry(), 0), 0.01);
    drive(first, {1.0, 1.0, 0.0}, {2.0, 1.0, 0.0});
    ASSERT_TRUE(verdict == mapping::ScanVerdict::kInserted && !first.map().hasOccupied());
    mapping::Mapper second(parameters);
    ASSERT_TRUE(second.resume(first.map(), Pose2(0.5, 0.0, 0.0), T_odom_base, true)) << "another frame than odometry's";
    goOn(second);
    EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
    scanner = Scanner(world.solid(), 0.01);
    goOn(second);
    EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
    EXPECT_TRUE(second.map().hasOccupied());
    EXPECT_FALSE(isJump(second.T_map_odom(), Pose2(0.5, 0.0, 0.0), 0.1, 0.03)) << "from where the first one was";
  }
}

// [FLT-2]
TEST(KnownMap, WhoseBoxIsTooLargeToLocaliseInIsRefusedAsAWhole_FLT_2) {
  mapping::MapperParameters parameters;
  parameters.map.max_side = 1000.0;
  parameters.trust_odometry = true;
  mapping::Mapper mapper(parameters);
  occupancy::OccupancyMap large(parameters.map);
  ASSERT_EQ(large.reserve({-250.0, -250.0}, {250.0, 250.0}), occupancy::MapRoom::kEnough) << "100 million cells";
  EXPECT_FALSE(mapper.load(large));
  EXPECT_FALSE(mapper.resume(large, Pose2(1.0, 0.0, 0.0), Pose2(), true));
  EXPECT_LT(mapper.map().geometry().size(), large.geometry().size()) << "the map is as it was";
  EXPECT_TRUE(mapper.resume(large, Pose2(), Pose2(), true)) << "odometry is trusted, nobody localises";
}

// [MAP-5]
TEST_F(MapLocalizationTest, AMapWithoutWallsThatWasLoadedKeepsTheMapperNotFromMapping_MAP_5) {
  mapping::Mapper mapper;
  drive(mapper, {1.0, 1.0, 0.0}, {2.0, 1.0, 0.0});
  occupancy::OccupancyMap open(mapping::MapperParameters{}.map);
  ASSERT_EQ(open.reserve({0.0, 0.0}, {5.0, 5.0}), occupancy::MapRoom::kEnough);
  open.beginScan();
  for (int i = 0; i < 2500; ++i) open.miss({i % 50, i / 50});
  ASSERT_TRUE(mapper.load(open) && !mapper.map().hasOccupied());
  goOn(mapper);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  EXPECT_TRUE(mapper.map().hasOccupied());
}

// [FLT-1]
TEST(KnownMap, ThatIsNoiseIsRefusedAsAWhole_FLT_1) {
  mapping::Mapper mapper(mapping::MapperParameters{});
  occupancy::OccupancyMap noise(mapping::MapperParameters{}.map);
  ASSERT_EQ(noise.reserve({0.0, 0.0}, {55.0, 55.0}), occupancy::MapRoom::kEnough);
  for (int certainty = 0; certainty < 10; ++certainty) {
    noise.beginScan();
    for (int y = 0; y < 1050; ++y) {
      for (int x = 0; x < 1050; ++x) (x + y) % 2 == 0 ? noise.hit({x, y}) : noise.miss({x, y});
    }
  }
  EXPECT_FALSE(mapper.load(noise)) << "two million sides of walls";
  EXPECT_TRUE(mapper.map().isBlank());
}

}  // namespace
}  // namespace frontier_pilot::test
