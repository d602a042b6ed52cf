// Places that look alike, where a scan alone may take one for another.

#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/mapper.h"
#include "known_rooms.h"
#include "support/ascii_world.h"
#include "support/drives/drive.h"

namespace frontier_pilot::test {
namespace {

constexpr const char* kCorridor = R"(
  ##################################################
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  #................................................#
  ##################################################
)";

/// Whether a robot that stands at `T_world_base` in the corridor is found there, if it is looked for around `expected`.
bool isFound(const Pose2& T_world_base, const Pose2& expected) {
  const AsciiWorld world = drawWorld(kCorridor, 0.2);
  Scanner scanner(world.solid(), 0.01);
  mapping::MapperParameters parameters;
  parameters.localize_only = true;
  mapping::Mapper mapper(parameters);
  occupancy::OccupancyMap corridor = knownMapOf(world);
  EXPECT_TRUE(mapper.load(corridor));
  EXPECT_TRUE(mapper.locate({expected, Eigen::Vector3d(0.09, 0.09, 0.01).asDiagonal()}));
  for (double seconds = 1.0; seconds < 4.0; seconds += 0.6) {
    const Time stamp = timeFromSeconds(seconds);
    mapper.insert(scanner.scan(T_world_base, stamp), Pose2(), stamp);
  }
  EXPECT_TRUE(!mapper.isLocalized() || !isJump(T_world_base, mapper.T_map_odom(), 0.05, 0.03));
  return mapper.isLocalized();
}

// [MAP-5]
TEST(LikePlaces, InACorridorWhoseEndTheRobotSeesAreNotTakenForEachOther_MAP_5) {
  const Pose2 T_world_base(4.4, 1.2, 0.0);
  EXPECT_FALSE(isFound(T_world_base, {7.4, 1.2, 0.0}));
  EXPECT_TRUE(isFound(T_world_base, {4.9, 1.3, 0.1}));
}

}  // namespace
}  // namespace frontier_pilot::test
