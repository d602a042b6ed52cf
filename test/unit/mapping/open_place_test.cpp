// Places where hardly any beam returns, with each of the ways in which drivers report that: odometry carries the pose,
// and the map shows nothing that is not there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "frontier_pilot/mapping/mapper.h"
#include "support/drives/open_place.h"
#include "support/drives/tracked_drive.h"

namespace frontier_pilot {
namespace {

constexpr double kRate = 5.0;  // [Hz]

/// How a driver reports a beam without a return.
enum class NoReturn { kInfinite, kZero, kMaximum, kBeyond };

float rangeOf(NoReturn convention, double range_max) {
  switch (convention) {
    case NoReturn::kZero:
      return 0.0F;
    case NoReturn::kMaximum:
      return static_cast<float>(range_max);
    case NoReturn::kBeyond:
      return static_cast<float>(range_max) + 1.0F;
    case NoReturn::kInfinite:
      break;
  }
  return std::numeric_limits<float>::infinity();
}

/// The share of the map's occupied cells that are farther than `tolerance` [m] from everything solid.
double inventedShare(const OccupancyGrid& map, const Pose2& T_world_map, const Grid<std::uint8_t>& solid,
                     double tolerance) {
  const int reach = static_cast<int>(std::ceil(tolerance / solid.resolution()));
  std::size_t occupied = 0;
  std::size_t invented = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!isOccupied(map[i])) continue;
    ++occupied;
    const Cell at = solid.geometry().cellAt(T_world_map * map.geometry().centre(map.geometry().cell(i)));
    bool near = false;
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) near = near || solid.get({at.x + x, at.y + y}, 0) != 0;
    }
    if (!near) ++invented;
  }
  return occupied == 0 ? 0.0 : static_cast<double>(invented) / static_cast<double>(occupied);
}

/// A scanner, and what it can be mapped with.
struct Case {
  NoReturn convention;
  double range_max;   ///< [m]
  double most_error;  ///< greatest distance of the pose from the truth [m]
  double tolerance;   ///< of the map: greatest distance of an occupied cell from what is solid [m]
};

class MappingOfAnOpenPlace : public ::testing::TestWithParam<Case> {
 protected:
  /// Drives with exact odometry, so that every error is one of the mapper.
  void run(const std::vector<Pose2>& poses) {
    scanner.range_max = GetParam().range_max;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      LaserScan2 scan = scanner.scan(poses[i], timeFromSeconds(100.0 + static_cast<double>(i) / kRate));
      const float nothing = rangeOf(GetParam().convention, GetParam().range_max);
      std::replace_if(
          scan.ranges.begin(), scan.ranges.end(), [](float range) { return std::isinf(range); }, nothing);
      const Pose2 T_odom_base = poses[0].inverse() * poses[i];
      mapper.insert(scan, T_odom_base, scan.stamp);
      mapper.reviseNow();
      error = (T_odom_base.inverse() * (mapper.T_map_odom() * T_odom_base)).position().norm();
      worst = std::max(worst, error);
      if (const auto remark = mapper.remark(scan.stamp)) remarks.insert(remark->text);
    }
  }
  std::uint64_t count(const std::string& text) const {
    const auto found = mapper.correctionCounts().find(text);
    return found == mapper.correctionCounts().end() ? 0 : found->second;
  }

  test::Scanner scanner{test::openPlace(), 0.01};
  mapping::Mapper mapper;
  double error = 0.0, worst = 0.0;  ///< distance from the truth, at the end and the greatest [m]
  std::set<std::string> remarks;
};

// With 3.5 m nearly all of the way is out of sight of everything. The errors of odometry that were learnt from the
// first few matches bend it, and the map with it.
INSTANTIATE_TEST_SUITE_P(ConventionsAndRanges, MappingOfAnOpenPlace,
                         ::testing::Values(Case{NoReturn::kInfinite, 8.0, 0.8, 0.5},
                                           Case{NoReturn::kZero, 8.0, 0.8, 0.5}, Case{NoReturn::kZero, 3.5, 4.0, 4.0},
                                           Case{NoReturn::kMaximum, 8.0, 0.8, 0.5},
                                           Case{NoReturn::kBeyond, 15.0, 0.4, 0.5}));

TEST_P(MappingOfAnOpenPlace, MAP_1_InventsNothingAndBelievesOdometry) {
  const std::vector<Pose2> poses = test::driveAlong(
      {{10.0, 10.0}, {16.0, 11.0}, {40.0, 40.0}, {64.0, 62.0}, {70.0, 70.0}, {52.0, 60.0}, {16.0, 11.0}}, 1.0, kRate);
  run(poses);
  EXPECT_LT(worst, GetParam().most_error) << "odometry is exact, but the mapper has to learn that from few matches";
  EXPECT_EQ(count("lost, new submap begun"), 0U);
  EXPECT_EQ(count("matched, contradicts odometry"), 0U);
  EXPECT_GT(count("little to match, position from odometry"), 300U);
  EXPECT_EQ(remarks.count("little to match, position from odometry"), 1U);
  EXPECT_LT(inventedShare(mapper.grid(), poses[0], test::openPlace(), GetParam().tolerance), 0.001);
}

std::size_t freeCells(const OccupancyGrid& map) {
  return static_cast<std::size_t>(std::count(map.cells().begin(), map.cells().end(), kFree));
}

TEST(MappingOfOpenGround, MAP_1_KeepsItsFreeFloorWhenTheMapIsRenderedAgain) {
  mapping::Mapper mapper;
  test::Scanner scanner(test::openPlace(), 0.01);
  test::Wheels wheels;
  const std::vector<Pose2> poses = test::driveAlong(
      {{10.0, 10.0}, {16.0, 11.0}, {24.0, 34.0}, {16.0, 11.0}, {10.0, 10.0}, {10.0, 13.0}}, 1.0, kRate);
  double least = 1.0;  // share of the free cells that a rendering keeps
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Time stamp = timeFromSeconds(100.0 + static_cast<double>(i) / kRate);
    mapper.insert(scanner.scan(poses[i], stamp), wheels.move(poses[i == 0 ? 0 : i - 1], poses[i]), stamp);
    const auto before = static_cast<double>(freeCells(mapper.grid()));
    const std::uint64_t rendered = mapper.revisions().rendered;
    mapper.reviseNow();
    if (mapper.revisions().rendered == rendered) continue;
    const double kept = static_cast<double>(freeCells(mapper.grid())) / before;
    least = std::min(least, kept);
  }
  ASSERT_GT(mapper.revisions().rendered, 0U) << "on the way back into the yard loops are closed";
  EXPECT_GT(least, 0.94) << "scans between keyframes are not rendered";
}

}  // namespace
}  // namespace frontier_pilot
