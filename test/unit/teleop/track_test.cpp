#include "teleop/track.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

TEST(Track, KeepsPointsThatAreFarEnoughApart) {
  teleop::Track track(0.1, 100);
  for (int i = 0; i <= 100; ++i) track.add({0.01 * i, 0.0});
  ASSERT_GE(track.points().size(), 10U);
  EXPECT_LE(track.points().size(), 11U);
  EXPECT_DOUBLE_EQ(track.points().front().x(), 0.0);
}

// [FLT-1]
TEST(Track, OfALongRunKeepsItsShapeInBoundedMemory) {
  teleop::Track track(0.1, 50);
  for (int i = 0; i < 100'000; ++i) track.add({0.1 * i, 0.0});
  EXPECT_LE(track.points().size(), 50U);
  EXPECT_GE(track.points().size(), 20U);
  EXPECT_DOUBLE_EQ(track.points().front().x(), 0.0) << "it still begins at the start";
  EXPECT_GT(track.points().back().x(), 9000.0) << "and ends near the robot";
  track.clear();
  track.add({0.0, 0.0});
  track.add({0.15, 0.0});
  EXPECT_EQ(track.points().size(), 2U) << "a new track is as fine as the first";
}

// [FLT-1]
TEST(Track, LeavesOutWhatIsNoPlace) {
  teleop::Track track;
  track.add({std::numeric_limits<double>::quiet_NaN(), 0.0});
  track.add({0.0, std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(track.points().empty());
}

}  // namespace
}  // namespace frontier_pilot
