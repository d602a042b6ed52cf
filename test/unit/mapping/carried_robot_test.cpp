// A robot that somebody carries while it maps: its wheels do not turn, but its scanner shows another place.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/mapping/mapper.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"
#include "unlike_rooms.h"

namespace frontier_pilot::test {
namespace {

/// With `GetParam()` the mapper trusts odometry, otherwise it matches scans.
class CarriedRobot : public ::testing::TestWithParam<bool> {
 protected:
  CarriedRobot() : scanner(drawWorld(kUnlikeRooms, 0.2).solid(), 0.01), mapper(parameters()) {
    for (int i = 0; i < 40; ++i) driveOn();
    stand(10);
  }

  static mapping::MapperParameters parameters() {
    mapping::MapperParameters parameters;
    parameters.trust_odometry = GetParam();
    return parameters;
  }
  void scan() {
    const Time stamp = timeFromSeconds(seconds += 0.25);
    verdict = mapper.insert(scanner.scan(T_world_odom * T_odom_base, stamp), T_odom_base, stamp);
    mapper.reviseNow();
  }
  void driveOn() {
    T_odom_base = T_odom_base * Pose2(0.05, 0.0, 0.0);
    scan();
  }
  void stand(int scans) {
    for (int i = 0; i < scans; ++i) scan();
  }
  void carryTo(const Pose2& T_world_base) { T_world_odom = T_world_base * T_odom_base.inverse(); }
  std::uint64_t inserted() const { return mapper.counts()[mapping::ScanVerdict::kInserted]; }

  const Pose2 start{3.4, 0.9, 0.0};
  const Pose2 elsewhere{7.2, 0.9, 2.0};
  Scanner scanner;
  Pose2 T_world_odom = start;
  Pose2 T_odom_base;
  mapping::Mapper mapper;
  double seconds = 1.0;
  mapping::ScanVerdict verdict = mapping::ScanVerdict::kInserted;
};

// [MAP-5]
TEST_P(CarriedRobot, DoesNotDrawTheOtherPlaceOverItsMap_MAP_5) {
  ASSERT_EQ(verdict, mapping::ScanVerdict::kInserted);
  EXPECT_TRUE(mapper.isLocalized());
  const auto before = mapper.grid().cells();
  carryTo(elsewhere);
  stand(50);
  EXPECT_FALSE(mapper.isLocalized());
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated);
  EXPECT_NE(std::string(mapper.lastCorrection()).find("carried"), std::string::npos) << mapper.lastCorrection();
  for (int i = 0; i < 12; ++i) driveOn();
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated) << "by driving on it does not learn where it is";
  EXPECT_TRUE(mapper.grid().cells() == before);
}

// [MAP-5] Somebody lifts it while its wheels still turn a little.
TEST_P(CarriedRobot, DoesNotDrawItEitherIfItsWheelsTurnALittleMeanwhile_MAP_5) {
  const auto before = mapper.grid().cells();
  carryTo(elsewhere);
  T_odom_base = T_odom_base * Pose2(0.02, 0.0, 0.05);
  stand(50);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated);
  EXPECT_TRUE(mapper.grid().cells() == before);
}

// [MAP-5]
TEST_P(CarriedRobot, GoesOnMappingOnceItIsPutBack_MAP_5) {
  const Pose2 T_world_base = T_world_odom * T_odom_base;
  carryTo(elsewhere);
  stand(20);
  carryTo(T_world_base);
  const std::uint64_t before = inserted();
  stand(5);
  EXPECT_EQ(inserted(), before + 5);
  EXPECT_TRUE(mapper.isLocalized());
}

// [MAP-5]
TEST_P(CarriedRobot, GoesOnMappingFromWhereTheSearchOfItsMapHasFoundIt_MAP_5) {
  carryTo(elsewhere);
  stand(20);
  const mapping::RobotSearch search = mapper.searchWork()();
  ASSERT_EQ(search.result.verdict, localization::SearchVerdict::kFound) << describe(search.result);
  ASSERT_TRUE(mapper.locate(search));
  for (int i = 0; i < 10; ++i) driveOn();
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  const Pose2 T_world_base = T_world_odom * T_odom_base;
  EXPECT_FALSE(isJump(T_world_base, start * mapper.T_map_odom() * T_odom_base, 0.1, 0.05));
}

// [MAP-5] [FLT-2]
TEST_P(CarriedRobot, IsNotLocalisedByAMapperThatTakesOverFromOneThatDiedMeanwhile_MAP_5_FLT_2) {
  const Pose2 T_world_base = T_world_odom * T_odom_base;
  carryTo(elsewhere);
  stand(20);
  mapping::Mapper died = std::exchange(mapper, mapping::Mapper(parameters()));
  ASSERT_TRUE(mapper.resume(died.map(), died.T_map_odom(), T_odom_base, died.isLocalized()));
  EXPECT_FALSE(mapper.isLocalized());
  stand(20);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kNotLocated);
  EXPECT_FALSE(mapper.isLocalized());
  EXPECT_EQ(inserted(), 0U);
  carryTo(T_world_base);
  stand(5);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
  EXPECT_TRUE(mapper.isLocalized());
}

// [MAP-5]
TEST_P(CarriedRobot, BeginsAnewAfterAReset_MAP_5) {
  carryTo(elsewhere);
  stand(20);
  mapper.reset();
  EXPECT_TRUE(mapper.isLocalized());
  stand(5);
  EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
}

// A pallet before half of the scanner is no other place.
TEST_P(CarriedRobot, GoesOnWhileSomethingLargeStandsBeforeIt) {
  const std::uint64_t before = inserted();
  for (int i = 0; i < 20; ++i) {
    const Time stamp = timeFromSeconds(seconds += 0.25);
    LaserScan2 covered = scanner.scan(T_world_odom * T_odom_base, stamp);
    for (std::size_t beam = 120; beam < 240; ++beam) covered.ranges[beam] = std::min(covered.ranges[beam], 0.5F);
    mapper.insert(covered, T_odom_base, stamp);
  }
  EXPECT_EQ(inserted(), before + 20);
}

INSTANTIATE_TEST_SUITE_P(Odometry, CarriedRobot, ::testing::Values(true, false),
                         [](const auto& of) { return of.param ? "Trusted" : "Matched"; });

}  // namespace
}  // namespace frontier_pilot::test
