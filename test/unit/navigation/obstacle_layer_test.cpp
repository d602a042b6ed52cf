#include "navigation/obstacle_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

/// A floor of 6 m x 6 m with a wall along its right edge and unknown cells along its upper one.
OccupancyGrid floorWithAWall() {
  OccupancyGrid grid(GridGeometry{0.05, Vec2::Zero(), 120, 120}, kFree);
  for (int i = 0; i < 120; ++i) {
    grid[Cell{119, i}] = kOccupied;
    grid[Cell{i, 119}] = kUnknown;
  }
  return grid;
}

/// One that sees nothing around itself, a beam for each degree.
LaserScan2 emptyScan() {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.ranges.assign(360, std::numeric_limits<float>::infinity());
  return scan;
}

class ObstacleLayerTest : public ::testing::Test {
 protected:
  bool see(const LaserScan2& scan, double seconds) {
    view = {scan, T_map_base};
    const bool changed = layer.update(view, navigation::scanPoints(scan, T_map_base, Outline::disc(0.105)), map,
                                      timeFromSeconds(seconds));
    map.refresh();
    return changed;
  }
  /// A scan with a surface `range` [m] away over five beams about `bearing` [degrees].
  LaserScan2 withObstacle(float range, int bearing = 0) const {
    LaserScan2 scan = emptyScan();
    for (int i = -2; i <= 2; ++i) scan.ranges[static_cast<std::size_t>((180 + bearing + i + 360) % 360)] = range;
    return scan;
  }
  bool isBlocked(const Vec2& point) const { return map.isOccupied(map.geometry().cellAt(point)); }

  planning::ClearanceMap map = test::clearanceOf(floorWithAWall());
  navigation::ObstacleLayer layer;
  navigation::ScanView view;  ///< of the scan that was seen last
  Pose2 T_map_base{3.01, 3.01, 0.0};
};

TEST_F(ObstacleLayerTest, MarksWhatTheMapLacksAndSaysWhetherThatIsNew) {
  EXPECT_FALSE(see(emptyScan(), 1.0));
  EXPECT_TRUE(layer.empty());
  EXPECT_TRUE(see(withObstacle(1.0F), 1.1));
  EXPECT_TRUE(isBlocked({4.01, 3.01}));
  const std::size_t size = layer.size();
  EXPECT_FALSE(see(withObstacle(1.0F), 1.2)) << "the same again";
  EXPECT_EQ(layer.size(), size);
}

TEST_F(ObstacleLayerTest, TakesAMarkAwayWhenBeamsGoThrough) {
  see(withObstacle(1.0F), 1.0);
  EXPECT_FALSE(see(withObstacle(1.1F), 1.1) && !isBlocked({4.01, 3.01})) << "a surface a little behind it is the same";
  EXPECT_TRUE(see(emptyScan(), 1.2));
  EXPECT_FALSE(isBlocked({4.01, 3.01}));
  EXPECT_TRUE(layer.empty());
}

TEST_F(ObstacleLayerTest, KeepsAMarkWhenASingleBeamIsLostOrSaysNothing) {
  see(withObstacle(1.0F), 1.0);
  LaserScan2 scan = withObstacle(1.0F);
  scan.ranges[180] = std::numeric_limits<float>::infinity();
  see(scan, 1.1);
  EXPECT_TRUE(isBlocked({4.01, 3.01}));
  for (float& range : scan.ranges) range = std::nanf("");
  see(scan, 1.2);
  EXPECT_TRUE(isBlocked({4.01, 3.01})) << "a covered scanner has not seen it go";
}

TEST_F(ObstacleLayerTest, ForgetsWhatIsOutOfSightAfterAWhile) {
  see(withObstacle(1.0F), 1.0);
  LaserScan2 blind = emptyScan();
  for (float& range : blind.ranges) range = std::nanf("");
  EXPECT_FALSE(see(blind, 30.9));
  EXPECT_TRUE(isBlocked({4.01, 3.01}));
  EXPECT_TRUE(see(blind, 31.1));
  EXPECT_FALSE(isBlocked({4.01, 3.01}));
}

// [NAV-1]
TEST_F(ObstacleLayerTest, KeepsWhatIsToBeKeptUntilThatIsReleased_NAV_1) {
  LaserScan2 both = withObstacle(1.0F);
  for (std::size_t beam = 268; beam <= 272; ++beam) both.ranges[beam] = 1.0F;
  see(both, 1.0);
  layer.keepNear({{3.9, 3.01}}, 0.3, map.geometry());
  EXPECT_TRUE(isBlocked({3.01, 4.01}));
  LaserScan2 blind = emptyScan();
  blind.ranges.assign(360, std::numeric_limits<float>::quiet_NaN());
  see(blind, 100.0);
  EXPECT_TRUE(isBlocked({4.01, 3.01}));
  EXPECT_FALSE(isBlocked({3.01, 4.01})) << "it is at another place";
  layer.releaseKept();
  see(blind, 100.1);
  EXPECT_FALSE(isBlocked({4.01, 3.01}));
}

TEST_F(ObstacleLayerTest, LeavesToTheMapWhatTheMapHas) {
  EXPECT_FALSE(see(withObstacle(2.86F), 1.0)) << "a hit in front of the wall is the wall";
  EXPECT_FALSE(see(withObstacle(2.97F, 90), 1.1)) << "nobody may go where the map is unknown anyway";
  EXPECT_FALSE(see(withObstacle(3.3F, 180), 1.2)) << "beyond the range, and out of the map";
  EXPECT_TRUE(layer.empty());
}

TEST_F(ObstacleLayerTest, SeesBehindItselfAcrossTheSeamOfTheAngle) {
  for (const double heading : {0.0, 1.0, -2.5, kPi}) {
    T_map_base.yaw = heading;
    see(withObstacle(1.0F, 180), 1.0);
    const Vec2 obstacle = T_map_base * Vec2(-1.0, 0.0);
    EXPECT_TRUE(isBlocked(obstacle)) << heading;
    see(emptyScan(), 1.1);
    EXPECT_FALSE(isBlocked(obstacle)) << heading;
  }
}

TEST_F(ObstacleLayerTest, BelievesInWhatANarrowScannerDoesNotLookAt) {
  see(withObstacle(1.0F, 180), 1.0);
  LaserScan2 ahead = emptyScan();
  ahead.angle_min = -0.5 * kPi;
  ahead.ranges.resize(180);
  see(ahead, 1.1);
  EXPECT_TRUE(isBlocked({2.01, 3.01}));
}

TEST_F(ObstacleLayerTest, ReadsAScannerThatTurnsClockwise) {
  see(withObstacle(1.0F, 90), 1.0);
  ASSERT_TRUE(isBlocked({3.01, 4.01}));
  LaserScan2 scan = emptyScan();
  scan.angle_min = kPi;
  scan.angle_increment = -kPi / 180.0;
  for (std::size_t i = 85; i <= 95; ++i) scan.ranges[i] = 1.0F;
  see(scan, 1.1);
  EXPECT_TRUE(isBlocked({3.01, 4.01})) << "beam 90 looks to the left";
  see(withObstacle(1.0F, -90), 1.2);
  EXPECT_FALSE(isBlocked({3.01, 4.01}));
}

TEST_F(ObstacleLayerTest, ClearsAllMarksAndSaysWhetherThereWereAny) {
  EXPECT_FALSE(layer.clear(map));
  see(withObstacle(1.0F), 1.0);
  EXPECT_TRUE(layer.clear(map));
  map.refresh();
  EXPECT_FALSE(isBlocked({4.01, 3.01}));
  EXPECT_TRUE(layer.empty());
}

// [NAV-4] What has moved away is forgotten, and what has not must not be.
TEST_F(ObstacleLayerTest, ClearsOfAllMarksThoseThatTheScannerCanSeeAgain_NAV_4) {
  LaserScan2 both = withObstacle(1.0F, 180);
  for (std::size_t beam = 178; beam <= 182; ++beam) both.ranges[beam] = 1.0F;
  see(both, 1.0);
  LaserScan2 ahead = withObstacle(1.0F);
  EXPECT_FALSE(layer.clearInView({}, map)) << "nothing was scanned";
  for (std::size_t beam = 0; beam < ahead.ranges.size(); ++beam) {
    if (beam < 90 || beam >= 270 || beam == 180) ahead.ranges[beam] = std::nanf("");
  }
  see(ahead, 1.1);
  EXPECT_TRUE(layer.clearInView(view, map));
  map.refresh();
  EXPECT_FALSE(isBlocked({4.01, 3.01})) << "it is looked at, although one beam is lost";
  EXPECT_TRUE(isBlocked({2.01, 3.01})) << "it is behind a part of the robot";
  ahead.angle_min = -0.5 * kPi;
  ahead.ranges.assign(180, 8.0F);
  see(ahead, 1.2);
  EXPECT_FALSE(layer.clearInView(view, map));
  EXPECT_TRUE(isBlocked({2.01, 3.01})) << "it is behind the robot";
}

// [SCN-1] The robot turned by 0.6 rad while the beams were measured: those that pointed at the obstacle were others.
TEST_F(ObstacleLayerTest, MarksAndRemovesByBeamsThatWereMeasuredWhileTheRobotTurned_SCN_1) {
  const auto turning = [](LaserScan2 scan) {
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      const double left = 1.0 - static_cast<double>(beam) / static_cast<double>(scan.ranges.size() - 1);
      scan.moving_mounts.emplace_back(0.0, 0.0, -0.6 * left);
    }
    return scan;
  };
  see(withObstacle(1.0F), 1.0);
  ASSERT_TRUE(isBlocked({4.01, 3.01}));
  // It is seen along the x axis by the beam that pointed there when the robot had turned by about half of it.
  constexpr int kBeam = 15;
  LaserScan2 again = turning(withObstacle(1.0F, kBeam));
  const double bearing_now = again.angle(180 + kBeam) + again.mount(180 + kBeam).yaw;
  ASSERT_LT(std::abs(bearing_now), 0.03);
  see(again, 1.1);
  EXPECT_TRUE(isBlocked({4.01, 3.01}));
  see(turning(withObstacle(1.0F, 0)), 1.2);
  EXPECT_FALSE(isBlocked({4.01, 3.01})) << "what beam 0 saw lies elsewhere";
  EXPECT_FALSE(layer.empty());
}

}  // namespace
}  // namespace frontier_pilot
