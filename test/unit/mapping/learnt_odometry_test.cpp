// What was learnt of odometry's errors places the beams of a rolling scan, on a known map too.

#include <gtest/gtest.h>

#include "frontier_pilot/localization/map_localization.h"
#include "known_rooms.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"
#include "unlike_rooms.h"

namespace frontier_pilot::test {
namespace {

using Use = localization::MapLocalization::Use;

/// A metre by odometry without its errors, after a robot whose odometry counts a tenth too much has driven to and fro
/// on a known map.
double metreAfterADrive(Use use) {
  const AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  Scanner scanner(world.solid(), 0.01);
  occupancy::OccupancyMap map = knownMapOf(world);
  const Pose2 start(3.4, 0.9, 0.0);
  const scan_matching::PoseWithCovariance belief{start, Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal()};
  localization::MapLocalization correction(use, {}, map, {}, belief);
  for (int i = 0; i < 240; ++i) {
    const double way = 0.05 * (i / 60 % 2 == 0 ? i % 60 : 60 - i % 60);
    const LaserScan2 scan = scanner.scan(start * Pose2(way, 0.0, 0.0), timeFromSeconds(1.0 + 0.25 * i));
    const Pose2 T_odom_base(1.1 * way, 0.0, 0.0);
    EXPECT_TRUE(correction.correct(surfaces::readScan(scan), T_odom_base, map).located) << i;
  }
  return correction.withoutErrors({1.0, 0.0, 0.0}).x;
}

// [SCN-1] [MAP-5]
TEST(LearntOdometry, IsUsedOnAKnownMapWhetherItStaysAsItIsOrNot_SCN_1_MAP_5) {
  EXPECT_NEAR(metreAfterADrive(Use::kLocalizeOnly), 1.0 / 1.1, 0.03);
  EXPECT_NEAR(metreAfterADrive(Use::kGoOnMapping), 1.0 / 1.1, 0.03);
}

// [SCN-1] [MAP-5]
TEST(LearntOdometry, ThatIsTrustedHasNoErrors_SCN_1_MAP_5) { EXPECT_EQ(metreAfterADrive(Use::kTrustOdometry), 1.0); }

}  // namespace
}  // namespace frontier_pilot::test
