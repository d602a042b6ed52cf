#include "frontier_pilot/fleet/map_merger.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frontier_pilot {
namespace {

/// A room of 10 m x 8 m with a partition, as far as it is known.
OccupancyGrid partitionedRoom() {
  GridGeometry geometry;
  geometry.width = 200;
  geometry.height = 160;
  OccupancyGrid room(geometry, kFree);
  for (const int y : {0, 159}) std::fill_n(room.row(y), 200, kOccupied);
  for (int y = 0; y < 160; ++y) {
    room[Cell{0, y}] = room[Cell{199, y}] = kOccupied;
    if (y < 100) room[Cell{70, y}] = kOccupied;
  }
  return room;
}

/// `map` as a robot with another start would have it: `T_map_other` is where its frame lies.
OccupancyGrid seenFrom(const OccupancyGrid& map, const Pose2& T_map_other) {
  GridGeometry geometry;
  geometry.width = geometry.height = 500;
  geometry.origin = {-12.5, -12.5};
  OccupancyGrid seen(geometry, kUnknown);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i] = map.get(map.geometry().cellAt(T_map_other * geometry.centre(geometry.cell(i))), kUnknown);
  }
  return seen;
}

// [MUL-1]
TEST(Agreement, MapsOfOneRoomAgreeUnderTheRightTransform) {
  const OccupancyGrid room = partitionedRoom();
  const Pose2 T_room_other(3.0, 2.0, 0.65);
  const fleet::Agreement agreement = fleet::compare(room, seenFrom(room, T_room_other), T_room_other);
  EXPECT_NEAR(agreement.overlap, 80.0, 1.0);
  EXPECT_GT(agreement.agreeingShare(), 0.97);
  EXPECT_EQ(agreement.contradictedShare(), 0.0);
}

TEST(Agreement, AnErrorOfAFewCentimetresIsNoContradiction) {
  const OccupancyGrid room = partitionedRoom();
  const Pose2 T_room_other(3.0, 2.0, 0.65);
  const Pose2 error(0.05, -0.05, 0.0);
  const fleet::Agreement agreement = fleet::compare(room, seenFrom(room, T_room_other), error * T_room_other);
  EXPECT_LT(agreement.contradictedShare(), 0.05);
}

// [MUL-1]
TEST(Agreement, UnderAWrongTransformWallsLieInFreeSpace) {
  const OccupancyGrid room = partitionedRoom();
  const Pose2 T_room_other(3.0, 2.0, 0.65);
  const OccupancyGrid other = seenFrom(room, T_room_other);
  for (const Pose2& error : {Pose2(0.5, 0.4, 0.0), Pose2(0.0, 0.0, 0.3), Pose2(5.0, 3.0, kPi)}) {
    EXPECT_GT(fleet::compare(room, other, error * T_room_other).contradictedShare(), 0.25);
  }
}

TEST(Agreement, NothingInCommonAndFewWallsContradictNothing) {
  const OccupancyGrid room = partitionedRoom();
  const fleet::Agreement apart = fleet::compare(room, room, {100.0, 0.0, 0.0});
  EXPECT_EQ(apart.overlap, 0.0);
  EXPECT_EQ(apart.agreeingShare(), 1.0);
  EXPECT_EQ(apart.contradictedShare(), 0.0);
  OccupancyGrid free(room.geometry(), kFree);
  OccupancyGrid robot = free;
  for (int x = 50; x < 60; ++x) robot[Cell{x, 50}] = kOccupied;
  EXPECT_EQ(fleet::compare(free, robot, {}).contradictedShare(), 0.0);
}

}  // namespace
}  // namespace frontier_pilot
