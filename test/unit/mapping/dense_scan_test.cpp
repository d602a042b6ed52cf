#include <gtest/gtest.h>

#include <cstddef>
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

/// Processor time that `work` takes with so many beams [s].
template <class Work>
double secondsOf(const Work& work, std::size_t beams) {
  const std::clock_t start = std::clock();
  work(beams);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// How much longer `work` takes with as many beams as are accepted than with an eighth of them: about 8 if each beam
/// costs as much as any other, 64 if it costs as much as there are beams.
template <class Work>
double growthOf(const Work& work) {
  constexpr std::size_t kFew = bounds::kMostRanges / 8;
  constexpr int kRounds = 5;
  double few = 0.0;
  for (int i = 0; i < kRounds; ++i) few += secondsOf(work, kFew) / kRounds;
  return secondsOf(work, bounds::kMostRanges) / few;
}

constexpr double kMostGrowth = 45.0;  // up to 28 with rough walls, where more neighbours count

TEST(DenseScan, FLT_1_IsReadInTimeThatItsSizeBounds) {  // [FLT-1]
  for (const double roughness : {0.0, 0.01, 0.05}) {
    const auto read = [roughness](std::size_t beams) {
      EXPECT_GT(surfaces::thinned(surfaces::readScan(scanOfPot(beams, roughness)).points).size(), 2U);
    };
    EXPECT_LT(growthOf(read), kMostGrowth) << roughness;
  }
}

TEST(DenseScan, FLT_1_IsPutIntoTheMapInTimeThatItsSizeBounds) {  // [FLT-1]
  const auto insert = [](std::size_t beams) {
    LaserScan2 scan = scanOfPot(beams, 0.0);
    for (float& range : scan.ranges) range = 60.0F;
    occupancy::OccupancyMap map;
    occupancy::ScanInserter inserter;
    EXPECT_EQ(inserter.insert(surfaces::readScan(scan), Pose2(), map), occupancy::Insertion::kInserted);
  };
  EXPECT_LT(growthOf(insert), kMostGrowth);
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
