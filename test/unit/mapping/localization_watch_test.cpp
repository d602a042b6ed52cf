#include "mapping/localization_watch.h"

#include <gtest/gtest.h>

namespace frontier_pilot::mapping {
namespace {

Pose2 at(double x) { return {x, 0.0, 0.0}; }

// [MAP-5]
TEST(LocalizationWatch, IsOnlySureOfARobotThatIsLookedForOnceAScanFits_MAP_5) {
  for (bool keeps_map : {true, false}) {
    LocalizationWatch watch(keeps_map);
    EXPECT_TRUE(watch.isLocalized()) << "a new map begins where it is";
    watch.lookFor(true);
    EXPECT_FALSE(watch.isLocalized());
    watch.take(false, at(0.0));
    EXPECT_FALSE(watch.isLocalized());
    watch.take(true, at(0.1));
    EXPECT_TRUE(watch.isLocalized());
    watch.lookFor(true);
    EXPECT_FALSE(watch.isLocalized()) << "what fitted before does not count";
    watch.reset();
    EXPECT_TRUE(watch.isLocalized());
  }
}

// [MAP-5]
TEST(LocalizationWatch, TakesARobotToBeWhereItIsSaidToBeOnAMapWithoutWalls_MAP_5) {
  LocalizationWatch watch(true);
  watch.lookFor(false);
  watch.take(false, at(0.0));
  EXPECT_TRUE(watch.isLocalized());
  watch.lookFor(true);
  watch.take(false, at(0.0));
  EXPECT_FALSE(watch.isLocalized());
  LocalizationWatch draws_walls(false);
  draws_walls.lookFor(false);
  draws_walls.take(true, at(0.0));
  draws_walls.take(false, at(0.0));
  EXPECT_FALSE(draws_walls.isLocalized()) << "it was carried";
}

// [MAP-5] A robot whose map is drawn on was carried.
TEST(LocalizationWatch, IsNotSureOfAMappingRobotFromTheFirstScanThatDoesNotFit_MAP_5) {
  LocalizationWatch watch(false);
  watch.take(true, at(0.0));
  watch.take(false, at(0.0));
  EXPECT_FALSE(watch.isLocalized());
}

// [MAP-5] People who walk around the robot hide the walls of its map.
TEST(LocalizationWatch, ReliesOnOdometryForTwoMetresWhereTheMapStaysAsItIs_MAP_5) {
  LocalizationWatch watch(true);
  watch.lookFor(true);
  watch.take(true, at(1.0));
  for (double x : {1.0, 2.0, 2.9}) watch.take(false, at(x));
  EXPECT_TRUE(watch.isLocalized());
  watch.take(false, at(3.1));
  EXPECT_FALSE(watch.isLocalized());
  watch.take(false, at(1.0));
  EXPECT_FALSE(watch.isLocalized()) << "it may have been carried back and forth";
  watch.take(true, at(1.0));
  EXPECT_TRUE(watch.isLocalized());
}

// [MAP-5] Its odometry drifts by the way that it drives, not by how far it gets.
TEST(LocalizationWatch, CountsTheWayThatTheRobotDrivesToAndFro_MAP_5) {
  LocalizationWatch watch(true);
  watch.lookFor(true);
  watch.take(true, at(0.0));
  for (int i = 0; i < 1000; ++i) watch.take(false, at(0.01 * (i % 2)));
  EXPECT_TRUE(watch.isLocalized()) << "it stands";
  for (double x : {0.5, 1.0, 0.5, 0.0}) watch.take(false, at(x));
  EXPECT_TRUE(watch.isLocalized());
  watch.take(false, at(0.5));
  EXPECT_FALSE(watch.isLocalized());
}

}  // namespace
}  // namespace frontier_pilot::mapping
