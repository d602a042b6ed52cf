#include <gtest/gtest.h>

#include <cmath>

#include "frontier_pilot/occupancy/scan_inserter.h"

namespace frontier_pilot {
namespace {

/// A pane of glass 3 m ahead, of which some beams show what is 7 m ahead instead.
surfaces::SurfaceScan paneWithHoles(const std::vector<std::size_t>& holes) {
  LaserScan2 scan;
  scan.angle_min = -0.5;
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.12;
  scan.range_max = 10.0;
  for (std::size_t i = 0; i < 58; ++i) scan.ranges.push_back(static_cast<float>(3.0 / std::cos(scan.angle(i))));
  for (const std::size_t beam : holes) scan.ranges[beam] *= 7.0F / 3.0F;
  return surfaces::readScan(scan);
}

std::int8_t at(const occupancy::OccupancyMap& map, double x, double y) {
  return map.grid().get(map.geometry().cellAt({x, y}), kUnknown);
}

constexpr double kBeam30 = -0.5 + 30.0 * kPi / 180.0;

TEST(LoneReturns, MAP_1_BehindGlassMakeNeitherFloorNorWall) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter().insert(paneWithHoles({30}), Pose2(), map);
  EXPECT_EQ(at(map, 2.0, 2.0 * std::tan(kBeam30)), kFree) << "before the pane";
  for (double x = 3.15; x < 7.3; x += 0.05) EXPECT_EQ(at(map, x, x * std::tan(kBeam30)), kUnknown) << x;
}

TEST(LoneReturns, MAP_1_OfADoorThatSeveralBeamsPassOpenIt) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter().insert(paneWithHoles({29, 30, 31}), Pose2(), map);
  EXPECT_EQ(at(map, 5.0, 5.0 * std::tan(kBeam30)), kFree);
  EXPECT_EQ(at(map, 7.02, 7.02 * std::tan(kBeam30)), kOccupied);
}

TEST(LoneReturns, MAP_1_ThroughASlitOpenItWhenSeenFromElsewhereToo) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  // A slit on the way of beam 30, seen by another beam from the second pose.
  const double slit = 3.0 * std::tan(kBeam30);
  inserter.insert(paneWithHoles({30}), Pose2(), map);
  const auto beam = static_cast<std::size_t>(std::lround((std::atan2(slit - 0.5, 3.0) + 0.5) * 180.0 / kPi));
  inserter.insert(paneWithHoles({beam}), Pose2(0.0, 0.5, 0.0), map);
  const double slope = std::tan(-0.5 + static_cast<double>(beam) * kPi / 180.0);
  EXPECT_EQ(at(map, 5.0, 0.5 + 5.0 * slope), kFree);
}

TEST(LoneReturns, MAP_1_ThroughGlassStayShutWhereOtherBeamsHaveMetIt) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  for (int i = 0; i < 20; ++i) inserter.insert(paneWithHoles({}), Pose2(0.0, 0.04 * i, 0.0), map);
  for (int i = 0; i < 6; ++i) {
    const auto beam = static_cast<std::size_t>(25 + i);
    inserter.insert(paneWithHoles({beam}), Pose2(0.0, 0.1 * i, 0.0), map);
  }
  for (double side = -1.5; side < 2.5; side += 0.05) EXPECT_NE(at(map, 5.0, side), kFree) << side;
}

}  // namespace
}  // namespace frontier_pilot
