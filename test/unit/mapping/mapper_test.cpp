#include "frontier_pilot/mapping/mapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

LaserScan2 ring(double seconds, float range = 1.0F) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 90.0;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.ranges.assign(90, range);
  return scan;
}

/// The same with so many beams that the wall around has no gaps.
LaserScan2 denseRing(double seconds, float range) {
  LaserScan2 scan = ring(seconds);
  scan.angle_increment = 2.0 * kPi / 720.0;
  scan.ranges.assign(720, range);
  return scan;
}

mapping::MapperParameters trustingOdometry() {
  mapping::MapperParameters parameters;
  parameters.trust_odometry = true;
  return parameters;
}

class MapperTest : public ::testing::Test {
 protected:
  mapping::ScanVerdict insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base = Pose2()) {
    return mapper.insert(scan, T_odom_base, scan.stamp);
  }
  /// Expects that `scan` is dropped for `reason`, is counted, and changes nothing.
  void expectDrop(const LaserScan2& scan, const std::optional<Pose2>& pose, double now, mapping::ScanVerdict reason) {
    const auto before = mapper.grid().cells();
    const auto count = mapper.counts()[reason];
    EXPECT_EQ(mapper.insert(scan, pose, timeFromSeconds(now)), reason) << toString(reason);
    EXPECT_EQ(mapper.counts()[reason], count + 1);
    EXPECT_TRUE(mapper.grid().cells() == before) << "nothing mapped may be lost";
  }

  mapping::Mapper mapper{trustingOdometry()};
};

TEST_F(MapperTest, MapsInOdometrysFrameAsLongAsNothingCorrectsIt) {
  EXPECT_EQ(insert(ring(1.0), Pose2(4.0, 2.0, 0.3)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(mapper.T_map_odom(), Pose2());
  EXPECT_EQ(mapper.grid()[mapper.grid().geometry().cellAt({4.01, 2.01})], kFree);
}

// [MAP-4]
TEST_F(MapperTest, DropsAndCountsStaleScans_MAP_4) {
  ASSERT_EQ(insert(ring(10.0)), mapping::ScanVerdict::kInserted);
  expectDrop(ring(10.0), Pose2(1.0, 0.0, 0.0), 10.1, mapping::ScanVerdict::kStale);
  expectDrop(ring(10.5), Pose2(1.0, 0.0, 0.0), 11.6, mapping::ScanVerdict::kStale);
  expectDrop(ring(13.0), Pose2(1.0, 0.0, 0.0), 11.7, mapping::ScanVerdict::kFuture);
  EXPECT_EQ(mapper.counts().dropped(), 3U);
}

// [MAP-4] [FLT-1]
TEST_F(MapperTest, KeepsTheWallsThatACoveredScannerDoesNotSee_MAP_4_FLT_1) {
  ASSERT_EQ(insert(denseRing(1.0, 2.0F)), mapping::ScanVerdict::kInserted);
  for (const float nothing : {std::numeric_limits<float>::infinity(), 8.0F}) {
    expectDrop(denseRing(2.0, nothing), Pose2(0.3, 0.0, 0.0), 2.0, mapping::ScanVerdict::kBlind);
  }
  expectDrop(denseRing(2.0, 0.0F), Pose2(0.3, 0.0, 0.0), 2.0, mapping::ScanVerdict::kAllInvalid);
  EXPECT_EQ(insert(denseRing(3.0, 2.0F), Pose2(0.3, 0.0, 0.0)), mapping::ScanVerdict::kInserted);
}

// [MAP-4]
TEST_F(MapperTest, DropsAndCountsMalformedScans_MAP_4) {
  ASSERT_EQ(insert(ring(1.0)), mapping::ScanVerdict::kInserted);
  const Pose2 moved(1.0, 0.0, 0.0);
  LaserScan2 scan = ring(2.0);
  scan.angle_increment = 0.0;
  expectDrop(scan, moved, 2.0, mapping::ScanVerdict::kMalformed);
  scan = ring(2.0);
  scan.angle_min = std::nan("");
  expectDrop(scan, moved, 2.0, mapping::ScanVerdict::kMalformed);
  scan = ring(2.0);
  scan.range_max = scan.range_min;
  expectDrop(scan, moved, 2.0, mapping::ScanVerdict::kMalformed);
  scan = ring(2.0);
  scan.ranges.clear();
  expectDrop(scan, moved, 2.0, mapping::ScanVerdict::kMalformed);
  scan = ring(2.0);
  scan.T_base_sensor.x = std::nan("");
  expectDrop(scan, moved, 2.0, mapping::ScanVerdict::kMalformed);
}

// [FLT-1] These distances size the grids that a scan is matched in: 10^9 m had them written beyond their ends.
TEST_F(MapperTest, DropsScansFromImpossiblyFarAway_FLT_1) {
  ASSERT_EQ(insert(ring(1.0)), mapping::ScanVerdict::kInserted);
  for (const double far : {11.0, 5e4, 1e9, 1e300}) {
    LaserScan2 scan = ring(2.0);
    scan.T_base_sensor = Pose2(-far, far, 1.0);
    expectDrop(scan, Pose2(1.0, 0.0, 0.0), 2.0, mapping::ScanVerdict::kMalformed);
  }
  for (const double far : {101.0, 5e4, 4e9}) {
    LaserScan2 scan = ring(2.0, static_cast<float>(far / 2));
    scan.range_max = far;
    expectDrop(scan, Pose2(1.0, 0.0, 0.0), 2.0, mapping::ScanVerdict::kMalformed);
  }
  for (const double far : {1.1e6, 1e9, 1e300}) {
    expectDrop(ring(2.0), Pose2(0.0, -far, 0.0), 2.0, mapping::ScanVerdict::kNoOdometry);
  }
  EXPECT_EQ(insert(ring(2.0), Pose2(1.0, 0.0, 0.0)), mapping::ScanVerdict::kInserted);
}

// [MAP-4]
TEST_F(MapperTest, DropsAndCountsScansThatSayNothingOrCannotBePlaced_MAP_4) {
  ASSERT_EQ(insert(ring(1.0)), mapping::ScanVerdict::kInserted);
  expectDrop(ring(2.0, std::nanf("")), Pose2(1.0, 0.0, 0.0), 2.0, mapping::ScanVerdict::kAllInvalid);
  expectDrop(ring(2.0), Pose2(std::nan(""), 0.0, 0.0), 2.0, mapping::ScanVerdict::kNoOdometry);
  expectDrop(ring(2.0), std::nullopt, 2.0, mapping::ScanVerdict::kNoOdometry);
  expectDrop(ring(2.0), Pose2(1e5, 0.0, 0.0), 2.0, mapping::ScanVerdict::kOutOfBounds);
  mapper.reject(mapping::ScanVerdict::kWrongFrame, timeFromSeconds(2.0));
  EXPECT_EQ(mapper.counts()[mapping::ScanVerdict::kWrongFrame], 1U);
  EXPECT_EQ(mapper.counts().dropped(), 5U);
  EXPECT_EQ(insert(ring(2.0), Pose2(1.0, 0.0, 0.0)), mapping::ScanVerdict::kInserted)
      << "and the next good one goes in";
}

// [MAP-4] As with odometry that counts from the origin of a country's coordinates.
TEST_F(MapperTest, SaysThatTheRobotIsTooFarAwayAndNotThatTheMapIsTooLarge_MAP_4) {
  EXPECT_EQ(insert(ring(1.0), Pose2(5e5, 0.0, 0.0)), mapping::ScanVerdict::kTooFar);
}

// [MAP-4] Maps of hundreds of metres
TEST_F(MapperTest, GoesOnWithWhatItKnowsWhenTheMemoryOfTheMapIsUsedUpAndSaysWhatToDo_MAP_4) {
  mapping::MapperParameters parameters;
  parameters.trust_odometry = true;
  parameters.map.max_memory = 1.0;
  mapping::Mapper small(parameters);
  double seconds = 1.0;
  const auto drive = [&](double from, double to, double step) {
    for (double x = from; step > 0.0 ? x < to : x > to; x += step, seconds += 1.0) {
      ASSERT_EQ(small.insert(ring(seconds), Pose2(x, 0.0, 0.0), timeFromSeconds(seconds)),
                mapping::ScanVerdict::kInserted);
    }
  };
  drive(0.0, 400.0, 1.0);
  EXPECT_LT(small.map().memory(), 10'000'000U);
  const std::optional<mapping::ScanRemark> remark = small.remark(timeFromSeconds(seconds));
  ASSERT_TRUE(remark.has_value());
  for (const char* word : {"max_memory", "resolution", "max_clear_range"}) {
    EXPECT_NE(remark->text.find(word), std::string::npos) << remark->text;
  }
  EXPECT_EQ(small.counts().dropped(), 0U);
  EXPECT_EQ(small.map().projection()[small.map().geometry().cellAt({399.0, 0.0})], kUnknown);
}

TEST_F(MapperTest, LooksSeldomWhileTheRobotStandsAndStillSeesWhatComes) {
  ASSERT_EQ(insert(ring(1.0)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(insert(ring(1.1)), mapping::ScanVerdict::kNotMoved);
  EXPECT_EQ(insert(ring(1.2), Pose2(0.02, 0.0, 0.0)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(insert(ring(1.3), Pose2(0.02, 0.0, 0.02)), mapping::ScanVerdict::kInserted) << "turning is moving";
  int inserted = 0;
  for (int i = 1; i <= 100; ++i) {
    LaserScan2 scan = ring(1.3 + 0.1 * i);
    std::fill(scan.ranges.begin() + 30, scan.ranges.begin() + 60, 0.5F);
    inserted += insert(scan, Pose2(0.02, 0.0, 0.02)) == mapping::ScanVerdict::kInserted ? 1 : 0;
  }
  EXPECT_EQ(inserted, 50) << "five a second";
  EXPECT_EQ(mapper.grid()[mapper.grid().geometry().cellAt({0.53, 0.01})], kOccupied) << "someone came near";
  EXPECT_EQ(mapper.counts().dropped(), 0U);
}

TEST_F(MapperTest, GoesOnAfterTheClockWasSetBackAndKeepsTheMap) {
  ASSERT_EQ(insert(ring(100.0)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(insert(ring(5.0), Pose2(1.0, 0.0, 0.0)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(mapper.grid()[mapper.grid().geometry().cellAt({-0.5, 0.01})], kFree);
}

TEST_F(MapperTest, ForgetsOnResetAndStartsAnew) {
  ASSERT_EQ(insert(ring(1.0)), mapping::ScanVerdict::kInserted);
  const GridGeometry geometry = mapper.grid().geometry();
  mapper.takeChanges();
  mapper.reset();
  EXPECT_EQ(mapper.takeChanges().cells, geometry.rect());
  for (const std::int8_t value : mapper.grid().cells()) ASSERT_EQ(value, kUnknown);
  EXPECT_EQ(insert(ring(1.1)), mapping::ScanVerdict::kInserted) << "at once, though the robot has not moved";
  EXPECT_EQ(mapper.grid().geometry(), geometry) << "a map never shrinks";
}

/// Says that odometry's frame lies a metre to the left.
class Shift final : public slam::PoseCorrection {
 public:
  slam::CorrectedScan correct(const surfaces::SurfaceScan&, const Pose2&, const occupancy::OccupancyMap&) override {
    return {Pose2(0.0, 1.0, 0.0), true, "shifted"};
  }
  void reset() override {}
};

TEST(Mapper, PutsScansWhereTheCorrectionSays) {
  mapping::Mapper mapper({}, std::make_unique<Shift>());
  ASSERT_EQ(mapper.insert(ring(1.0), Pose2(2.0, 0.0, 0.0), timeFromSeconds(1.0)), mapping::ScanVerdict::kInserted);
  EXPECT_EQ(mapper.T_map_odom(), Pose2(0.0, 1.0, 0.0));
  EXPECT_EQ(mapper.grid()[mapper.grid().geometry().cellAt({2.01, 1.9})], kFree);
  EXPECT_EQ(mapper.grid()[mapper.grid().geometry().cellAt({2.01, -0.2})], kUnknown);
}

TEST(MapperParameters, RefuseNonsenseByName) {
  mapping::MapperParameters parameters;
  const Problems problems = loadParameters(parseYaml("{max_age: 0, map: {resolution: -1}, colour: red}"), parameters);
  EXPECT_EQ(problems.size(), 3U);
}

TEST(ScanVerdict, HasAWordForEach) {
  for (std::size_t i = 0; i < mapping::kScanVerdicts; ++i) {
    EXPECT_STRNE(toString(static_cast<mapping::ScanVerdict>(i)), "unknown");
  }
}

// [ROB-1]
TEST(MapperRobot, StandsOnFreeFloorOfItsSize_ROB_1) {
  LaserScan2 ahead = ring(1.0);
  ahead.angle_min = 0.0;
  ahead.angle_increment = 0.01;
  ahead.ranges.resize(5);
  for (const auto& [name, radius] :
       {std::pair("burger", 0.105), std::pair("waffle", 0.077), std::pair("turtlebot2", 0.177)}) {
    mapping::MapperParameters parameters = trustingOdometry();
    parameters.map.resolution = 0.01;
    parameters.robot = test::shippedRobot(name);
    mapping::Mapper mapper(parameters);
    ASSERT_EQ(mapper.insert(ahead, Pose2(), ahead.stamp), mapping::ScanVerdict::kInserted);
    const auto behind = [&](double x) { return mapper.grid()[mapper.grid().geometry().cellAt({-x, 0.0})]; };
    EXPECT_EQ(behind(radius - 0.015), kFree) << name;
    EXPECT_EQ(behind(radius + 0.015), kUnknown) << name;
  }
}

TEST(MapperRobot, IsNamedByTheErrorOfItsOldRadius) {
  mapping::MapperParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("insertion: {robot_radius: 0.2}"), parameters),
            (Problems{"insertion/robot_radius: is called robot/disc_radius or robot/outline now"}));
}

}  // namespace
}  // namespace frontier_pilot
