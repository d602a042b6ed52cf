// A scanner that is away for a while, as when it is replugged or its driver is started again: odometry goes on.

#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/mapper.h"
#include "known_rooms.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"
#include "unlike_rooms.h"

namespace frontier_pilot::test {
namespace {

class AbsentScanner : public ::testing::Test {
 protected:
  void scan(mapping::Mapper& mapper) {
    const Time stamp = timeFromSeconds(seconds += 0.6);
    verdict = mapper.insert(scanner.scan(T_map_odom * T_odom_base, stamp), T_odom_base, stamp);
    mapper.reviseNow();
  }
  void expectFound(const mapping::Mapper& mapper) const {
    EXPECT_EQ(verdict, mapping::ScanVerdict::kInserted);
    EXPECT_TRUE(mapper.isLocalized());
    EXPECT_FALSE(isJump(T_map_odom, mapper.T_map_odom(), 0.05, 0.03));
  }

  AsciiWorld world = drawWorld(kUnlikeRooms, 0.2);
  Scanner scanner{world.solid(), 0.01};
  const Pose2 T_map_odom{3.4, 0.9, 0.1};
  Pose2 T_odom_base{0.2, 0.0, 0.0};
  double seconds = 1.0;
  mapping::ScanVerdict verdict = mapping::ScanVerdict::kNoOdometry;
};

// [FLT-2] [MAP-5]
TEST_F(AbsentScanner, OfAMapperThatDiedHasTheRobotLookedForWhereItHasDrivenSince_FLT_2_MAP_5) {
  mapping::Mapper mapper;
  occupancy::OccupancyMap kept = knownMapOf(world);
  ASSERT_TRUE(mapper.resume(kept, T_map_odom, T_odom_base, true));
  T_odom_base.x += 2.5;
  scan(mapper);
  expectFound(mapper);
}

// [MAP-5]
TEST_F(AbsentScanner, HasTheRobotLookedForOnALoadedMapWhereItHasDrivenSinceItsLastScan_MAP_5) {
  mapping::Mapper mapper;
  occupancy::OccupancyMap rooms = knownMapOf(world);
  ASSERT_TRUE(mapper.resume(rooms, T_map_odom, T_odom_base, true));
  scan(mapper);
  expectFound(mapper);
  occupancy::OccupancyMap loaded = knownMapOf(world);
  ASSERT_TRUE(mapper.load(loaded));
  T_odom_base.x += 2.5;
  scan(mapper);
  expectFound(mapper);
}

}  // namespace
}  // namespace frontier_pilot::test
