// Sectors as laws that hold for every scanner, and the reading of odd ranges.
#include <gtest/gtest.h>

#include "avoid/sector_reader.h"
#include "scan_maker.h"

namespace frontier_pilot {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

avoid::SectorDistances read(const LaserScan2& scan, const avoid::AvoiderParameters& parameters = {}) {
  return avoid::SectorReader(parameters).read(scan);
}

class EveryScanner : public ::testing::TestWithParam<ScannerLayout> {
 protected:
  LaserScan2 scan() const { return emptyScan(GetParam(), Time{}); }
};

// [AVO-1]
TEST_P(EveryScanner, SeesAnObstacleInTheSectorThatItsBearingLiesIn_AVO_1) {
  avoid::SectorReader reader{avoid::AvoiderParameters{}};
  for (int degree = -89; degree <= 89; degree += 2) {
    const double angle = degree * kPi / 180.0;
    LaserScan2 with_obstacle = scan();
    const std::size_t beam = beamAt(with_obstacle, angle);
    const double bearing_of_beam = bearingOf(with_obstacle, beam);
    if (std::abs(std::abs(bearing_of_beam) - kPi / 3.0) < 1e-3 || std::abs(bearing_of_beam) < 1e-3) continue;
    with_obstacle.ranges[beam] = 1.0F;
    const avoid::SectorDistances around = reader.read(with_obstacle);
    ASSERT_EQ(around.fault, "");
    const bool ahead = std::abs(bearing_of_beam) < kPi / 3.0;
    EXPECT_EQ(std::isfinite(around.front_left), ahead && bearing_of_beam > 0.0) << degree << " [AVO-1]";
    EXPECT_EQ(std::isfinite(around.front_right), ahead && bearing_of_beam < 0.0) << degree << " [AVO-1]";
    EXPECT_EQ(std::isfinite(around.obstacleDistance()), ahead) << degree;
  }
}

// [AVO-1]
TEST_P(EveryScanner, GivesTheSmallerOfTheTwoSectorMinima_AVO_1) {
  LaserScan2 both = scan();
  putObstacle(both, 0.5, 0.9);
  putObstacle(both, 0.8, 1.4);
  putObstacle(both, -0.5, 0.7);
  const avoid::SectorDistances around = read(both);
  EXPECT_NEAR(around.front_left, 0.9, 1e-6);
  EXPECT_NEAR(around.front_right, 0.7, 1e-6);
  EXPECT_EQ(around.obstacleDistance(), around.front_right) << "[AVO-1]";
}

// [AVO-1]
TEST_P(EveryScanner, MirroringTheWorldMirrorsTheSectors_AVO_1) {
  for (const double angle : {0.1, 0.4, 0.7, 1.0}) {
    LaserScan2 left = scan(), right = scan();
    putObstacle(left, angle, 0.6);
    putObstacle(right, -angle, 0.6);
    EXPECT_NEAR(read(left).front_left, read(right).front_right, 1e-6) << angle;
    EXPECT_EQ(read(left).front_right, read(right).front_left) << angle;
  }
}

std::vector<ScannerLayout> everyScanner() {
  std::vector<ScannerLayout> layouts;
  for (const int beams : {90, 91, 360, 720, 4000}) {
    for (const double width : {kPi, 1.5 * kPi, 2.0 * kPi}) {
      for (const bool upside_down : {false, true}) {
        for (const double yaw : {0.0, kPi, -kPi / 2.0, 3.0})
          layouts.push_back({beams, width, upside_down, {0, 0, yaw}});
      }
    }
  }
  return layouts;
}

std::string nameOf(const ::testing::TestParamInfo<ScannerLayout>& info) {
  const ScannerLayout& layout = info.param;
  return std::to_string(layout.beams) + "Beams" + std::to_string(std::lround(layout.width * 180.0 / kPi)) + "Wide" +
         (layout.upside_down ? "UpsideDown" : "Upright") + "No" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(AsBuilt, EveryScanner, ::testing::ValuesIn(everyScanner()), nameOf);

// [AVO-1]
TEST(SectorReader, AnObstacleStraightAheadOrOnABorderBelongsToItsSectors_AVO_1) {
  LaserScan2 scan = emptyScan({}, Time{});
  scan.ranges[180] = 1.0F;
  EXPECT_EQ(read(scan).front_left, read(scan).front_right) << "[AVO-1]";
  scan = emptyScan({}, Time{});
  scan.ranges[240] = 1.0F;
  EXPECT_NEAR(read(scan).front_left, 1.0, 1e-6) << "+60 degrees is inside [AVO-1]";
  scan.ranges[240] = kInf;
  scan.ranges[241] = 1.0F;
  EXPECT_EQ(read(scan).front_left, avoid::SectorDistances::kNothing) << "+61 degrees is not [AVO-1]";
}

// [AVO-1]
TEST(SectorReader, TheRearSectorWrapsAround_AVO_1) {
  for (const double angle : {kPi - 0.01, -kPi + 0.01, 2.2, -2.2}) {
    LaserScan2 scan = emptyScan({}, Time{});
    putObstacle(scan, angle, 0.4, 0.0);
    EXPECT_NEAR(read(scan).rear, 0.4, 1e-6) << angle;
    EXPECT_EQ(read(scan).obstacleDistance(), avoid::SectorDistances::kNothing) << angle;
  }
}

// [AVO-1]
TEST(SectorReader, SectorsAreParameters_AVO_1) {
  avoid::AvoiderParameters parameters;
  parameters.front_left = {0.2, 0.4};
  LaserScan2 scan = emptyScan({}, Time{});
  putObstacle(scan, 0.6, 0.5);
  EXPECT_EQ(read(scan, parameters).front_left, avoid::SectorDistances::kNothing);
  putObstacle(scan, 0.3, 0.5);
  EXPECT_NEAR(read(scan, parameters).front_left, 0.5, 1e-6) << "[AVO-1]";
}

// [AVO-1]
TEST(SectorReader, DistancesAndBearingsAreTheBasesNotTheScanners_AVO_1) {
  LaserScan2 scan = emptyScan({360, 2.0 * kPi, false, {0.3, 0.0, 0.0}}, Time{});
  putObstacle(scan, 0.0, 0.5, 0.0);
  EXPECT_NEAR(read(scan).obstacleDistance(), 0.8, 1e-6) << "a scanner 0.3 m ahead of the centre [AVO-1]";
  scan = emptyScan({360, 2.0 * kPi, false, {-0.25, 0.0, 0.0}}, Time{});
  putObstacle(scan, kPi / 2.0, 0.5, 0.0);
  EXPECT_EQ(read(scan).obstacleDistance(), avoid::SectorDistances::kNothing);
  EXPECT_EQ(read(scan).rear, avoid::SectorDistances::kNothing) << "beside the tail is neither ahead nor behind";
}

// [AVO-1]
TEST(SectorReader, ForgetsTheLayoutOfTheScanBefore_AVO_1) {
  avoid::SectorReader reader{avoid::AvoiderParameters{}};
  LaserScan2 scan = emptyScan({}, Time{});
  putObstacle(scan, 0.5, 1.0);
  EXPECT_NEAR(reader.read(scan).front_left, 1.0, 1e-6);
  LaserScan2 turned = scan;
  turned.T_base_sensor.yaw = kPi;
  EXPECT_EQ(reader.read(turned).front_left, avoid::SectorDistances::kNothing) << "another mount [AVO-1]";
  LaserScan2 mirrored = scan;
  mirrored.angle_min = -scan.angle_min;
  mirrored.angle_increment = -scan.angle_increment;
  EXPECT_NEAR(reader.read(mirrored).front_right, 1.0, 1e-6) << "another sense of rotation [AVO-1]";
}

// [AVO-4]
TEST(SectorReader, WhatTheTailWouldSweepCountsAsBehind_AVO_4) {
  LaserScan2 scan = emptyScan({}, Time{});
  putObstacle(scan, 115.0 * kPi / 180.0, 0.12, 0.0);
  EXPECT_NEAR(read(scan).rear, 0.12, 1e-6) << "beside the rear sector but in the lane [AVO-4]";
}

// [AVO-4]
TEST_P(EveryScanner, SeesWhatIsBehindOnlyIfItLooksAllAround_AVO_4) {
  EXPECT_EQ(read(scan()).sees_rear, GetParam().width > 1.9 * kPi);
}

// [AVO-4]
TEST(SectorReader, SeesBehindAsFarAsTheLaneOfTheBodyReaches_AVO_4) {
  LaserScan2 scan = emptyScan({}, Time{});
  putObstacle(scan, 110.0 * kPi / 180.0, std::numeric_limits<double>::quiet_NaN(), 0.2);
  EXPECT_TRUE(read(scan).sees_rear) << "beside the body, where it does not drive";
  putObstacle(scan, 140.0 * kPi / 180.0, std::numeric_limits<double>::quiet_NaN(), 0.2);
  EXPECT_FALSE(read(scan).sees_rear) << "where it would drive [AVO-4]";
}

// [AVO-2]
TEST(SectorReader, NaNAndZeroSayNothing_AVO_2) {
  LaserScan2 scan = emptyScan({}, Time{});
  scan.ranges[185] = kNaN;
  scan.ranges[186] = 0.0F;
  EXPECT_EQ(read(scan).obstacleDistance(), avoid::SectorDistances::kNothing) << "[AVO-2]";
}

// [AVO-2]
TEST(SectorReader, MinusInfinityAndTooNearAreAnObstacleAtRangeMin_AVO_2) {
  for (const float range : {-kInf, 0.001F, 0.0999F}) {
    LaserScan2 scan = emptyScan({}, Time{});
    scan.ranges[185] = range;
    EXPECT_NEAR(read(scan).obstacleDistance(), scan.range_min, 1e-9) << range << " [AVO-2]";
  }
}

// [AVO-2]
TEST(SectorReader, TooNearForAScannerThatSeesOnlyFarIsWithinTheStopDistance_AVO_2) {
  LaserScan2 scan = emptyScan({}, Time{});
  scan.range_min = 1.0;
  scan.ranges[185] = -kInf;
  EXPECT_LT(read(scan).obstacleDistance(), avoid::AvoiderDistances(avoid::AvoiderParameters()).stop);
}

// [AVO-2]
TEST(SectorReader, InfinityAndBeyondRangeMaxAreFree_AVO_2) {
  for (const float range : {kInf, 8.1F, 1e30F}) {
    LaserScan2 scan = emptyScan({}, Time{});
    scan.ranges[185] = range;
    EXPECT_EQ(read(scan).obstacleDistance(), avoid::SectorDistances::kNothing) << range << " [AVO-2]";
    EXPECT_EQ(read(scan).fault, "");
  }
}

// [AVO-5]
TEST(SectorReader, EmptyMalformedAndMostlyInvalidScansAreFaults_AVO_5) {
  LaserScan2 scan = emptyScan({100, kPi, false, {}}, Time{});
  for (std::size_t i = 0; i < 90; ++i) scan.ranges[i < 45 ? i : i + 10] = kNaN;
  EXPECT_EQ(read(scan).fault, "") << "90 % is still good [AVO-5]";
  scan.ranges[45] = 0.0F;
  EXPECT_EQ(read(scan).fault, "91 of 100 beams are invalid") << "[AVO-5]";
  scan.ranges.clear();
  EXPECT_EQ(read(scan).fault, "empty scan") << "[AVO-5]";
  scan = emptyScan({}, Time{});
  scan.angle_increment = 0.0;
  EXPECT_EQ(read(scan).fault, "malformed scan: angles") << "[AVO-5]";
  scan = emptyScan({}, Time{});
  scan.range_max = scan.range_min;
  EXPECT_EQ(read(scan).fault, "malformed scan: range limits") << "[AVO-5]";
}

// [AVO-5]
TEST(SectorReader, AScannerThatIsBlindOnOneSideAheadIsAFault_AVO_5) {
  LaserScan2 scan = emptyScan({360, kPi, false, {}}, Time{});
  scan.T_base_sensor.yaw = kPi / 2.0 + 0.1;
  EXPECT_EQ(read(scan).fault, "no valid beam looks ahead on the right") << "[AVO-5]";
  scan.T_base_sensor.yaw = -kPi / 2.0 - 0.1;
  EXPECT_EQ(read(scan).fault, "no valid beam looks ahead on the left") << "[AVO-5]";
}

TEST(SectorReader, OnlyWhatTheBodyWouldSweepCountsBesideTheSectors) {
  LaserScan2 scan = emptyScan({}, Time{});
  putObstacle(scan, 80.0 * kPi / 180.0, 0.12, 0.0);
  putObstacle(scan, -80.0 * kPi / 180.0, 0.3, 0.0);
  putObstacle(scan, 100.0 * kPi / 180.0, 0.2, 0.0);
  const avoid::SectorDistances around = read(scan);
  EXPECT_NEAR(around.lane_left, 0.12, 1e-6);
  EXPECT_EQ(around.lane_right, avoid::SectorDistances::kNothing);
  EXPECT_EQ(around.rear, avoid::SectorDistances::kNothing);
}

// [SCN-1]
TEST(SectorReader, PutsABeamWhereTheRobotWasWhenItWasMeasured_SCN_1) {
  LaserScan2 scan = emptyScan({}, Time{});
  const std::size_t beam = beamAt(scan, 0.3);
  scan.ranges[beam] = 1.0F;
  // The robot has since turned by 0.6 rad to the left and driven 0.1 m ahead.
  scan.moving_mounts.assign(scan.ranges.size(), Pose2(-0.1, 0.0, -0.6));
  const avoid::SectorDistances around = read(scan);
  EXPECT_EQ(around.front_left, avoid::SectorDistances::kNothing);
  EXPECT_NEAR(around.front_right, (Vec2(-0.1, 0.0) + direction(scan.angle(beam) - 0.6)).norm(), 1e-6);
}

}  // namespace
}  // namespace frontier_pilot
