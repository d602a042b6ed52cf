#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/surfaces/surface_points.h"

/// Scans of as many beams as are accepted, each of which has all the others as neighbours. [FLT-1]
namespace frontier_pilot {
namespace {

/// A scan in a round pot whose wall is just beyond the least range, plus up to `roughness` [m].
LaserScan2 scanOfPot(std::size_t beams, double roughness) {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / static_cast<double>(beams);
  scan.range_min = 0.12;
  scan.range_max = bounds::kUsedRange;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> rough(0.0F, static_cast<float>(roughness));
  for (std::size_t i = 0; i < beams; ++i) scan.ranges.push_back(0.125F + rough(random));
  return scan;
}

/// Processor time that `work` takes [s].
template <class Work>
double secondsOf(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(DenseScan, FLT_1_IsReadInTimeThatItsSizeBounds) {  // [FLT-1]
  for (const double roughness : {0.0, 0.01, 0.05}) {
    const LaserScan2 scan = scanOfPot(bounds::kMostRanges, roughness);
    EXPECT_LT(secondsOf([&] { EXPECT_GT(surfaces::thinned(surfaces::readScan(scan).points).size(), 2U); }), 2.0)
        << roughness;
  }
}

TEST(DenseScan, FLT_1_IsPutIntoTheMapInTimeThatItsSizeBounds) {  // [FLT-1]
  LaserScan2 scan = scanOfPot(bounds::kMostRanges, 0.0);
  for (float& range : scan.ranges) range = 60.0F;
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  EXPECT_LT(secondsOf([&] {
              EXPECT_EQ(inserter.insert(surfaces::readScan(scan), Pose2(), map), occupancy::Insertion::kInserted);
            }),
            8.0);
}

OccupancyGrid mapOf(const LaserScan2& scan) {
  mapping::Mapper mapper;
  EXPECT_EQ(mapper.insert(scan, Pose2(), scan.stamp), mapping::ScanVerdict::kInserted);
  return mapper.grid();
}

TEST(DenseScan, FLT_1_IsMappedByNoMoreBeamsThanTheLimit) {  // [FLT-1]
  const LaserScan2 dense = scanOfPot(bounds::kMostRanges, 10.0);
  EXPECT_EQ(mapOf(dense).cells(), mapOf(withAtMost(bounds::kMostMappedBeams, dense)).cells());
  const LaserScan2 usual = scanOfPot(bounds::kMostMappedBeams, 10.0);
  EXPECT_NE(mapOf(usual).cells(), mapOf(withAtMost(bounds::kMostMappedBeams / 2, usual)).cells()) << "all are used";
}

}  // namespace
}  // namespace frontier_pilot
