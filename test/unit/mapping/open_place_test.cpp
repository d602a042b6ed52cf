// Places where hardly any beam returns, with each of the ways in which drivers report that: odometry carries the pose,
// and the map shows nothing that is not there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

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

class MappingOfAnOpenPlace : public ::testing::TestWithParam<std::tuple<NoReturn, double>> {
 protected:
  /// Drives with exact odometry, so that every error is one of the mapper.
  void run(const std::vector<Pose2>& poses) {
    const auto [convention, range_max] = GetParam();
    scanner.range_max = range_max;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      LaserScan2 scan = scanner.scan(poses[i], timeFromSeconds(100.0 + static_cast<double>(i) / kRate));
      const float nothing = rangeOf(convention, range_max);
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

INSTANTIATE_TEST_SUITE_P(ConventionsAndRanges, MappingOfAnOpenPlace,
                         ::testing::Values(std::tuple(NoReturn::kInfinite, 8.0), std::tuple(NoReturn::kZero, 8.0),
                                           std::tuple(NoReturn::kZero, 3.5), std::tuple(NoReturn::kMaximum, 8.0),
                                           std::tuple(NoReturn::kBeyond, 15.0)));

TEST_P(MappingOfAnOpenPlace, MAP_1_InventsNothingAndBelievesOdometry) {
  const std::vector<Pose2> poses = test::driveAlong(
      {{10.0, 10.0}, {16.0, 11.0}, {40.0, 40.0}, {64.0, 62.0}, {70.0, 70.0}, {52.0, 60.0}, {16.0, 11.0}}, 1.0, kRate);
  run(poses);
  constexpr double kLength = 190.0;  // [m]
  EXPECT_LT(worst, 0.02 * kLength) << "odometry is exact, but the mapper has to learn that from few matches";
  EXPECT_EQ(count("lost, new submap begun"), 0U);
  EXPECT_EQ(count("matched, contradicts odometry"), 0U);
  EXPECT_GT(count("little to match, position from odometry"), 300U);
  EXPECT_EQ(remarks.count("little to match, position from odometry"), 1U);
  EXPECT_LT(inventedShare(mapper.grid(), poses[0], test::openPlace(), 0.3 + worst), 0.001);
}

TEST(MappingOfOpenGround, MAP_1_KeepsItsFreeFloorWhenTheMapIsRenderedAgain) {
  mapping::Mapper mapper;
  test::Scanner scanner(test::openPlace(), 0.01);
  for (const Pose2& pose : test::driveAlong({{24.0, 34.0}, {30.0, 34.0}}, 1.0, kRate)) {
    const Time stamp = timeFromSeconds(100.0 + pose.x);
    mapper.insert(scanner.scan(pose, stamp), pose, stamp);
    mapper.reviseNow();
  }
  const std::vector<slam::KeyframePose> keyframes = mapper.trajectory();
  EXPECT_GT(keyframes.size(), 12U) << "what is rendered is what keyframes show";
}

}  // namespace
}  // namespace frontier_pilot
