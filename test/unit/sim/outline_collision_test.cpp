// Outlines against squares and discs, exactly.

#include "sim/collision/outline_collision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace frontier_pilot::sim {
namespace {

// A square of two metres, and one that lacks its upper right quarter but for a strip of half a metre along the axes.
Outline block() { return Outline::polygon({{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}); }
Outline angle() {
  return Outline::polygon({{1.0, 0.5}, {0.5, 0.5}, {0.5, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}});
}

// [SIM-3]
TEST(PlacedOutlines, TouchASquareWithoutOverlappingIt_SIM_3) {
  const Outline outline = block();
  const PlacedOutline placed(outline, {3.0, 5.0, 0.0});
  EXPECT_FALSE(placed.overlapsSquare({4.5, 5.0}, 0.5)) << "side to side";
  EXPECT_TRUE(placed.overlapsSquare({4.5 - 1e-9, 5.0}, 0.5));
  EXPECT_FALSE(placed.overlapsSquare({4.5, 6.5}, 0.5)) << "corner to corner";
  EXPECT_TRUE(placed.overlapsSquare({4.5 - 1e-9, 6.5 - 1e-9}, 0.5));
}

// [SIM-3]
TEST(PlacedOutlines, OverlapWhatLiesInsideAndWhatTheyLieIn_SIM_3) {
  const Outline outline = block();
  const PlacedOutline placed(outline, {3.0, 5.0, 0.4});
  EXPECT_TRUE(placed.overlapsSquare({3.2, 4.9}, 0.1));
  EXPECT_TRUE(placed.overlapsSquare({3.2, 4.9}, 10.0));
  EXPECT_TRUE(placed.overlapsDisc({{3.2, 4.9}, 0.1}));
  EXPECT_TRUE(placed.overlapsDisc({{3.2, 4.9}, 10.0}));
}

// [SIM-3] an outline need not be convex
TEST(PlacedOutlines, LeaveRoomInTheirNotches_SIM_3) {
  const Outline outline = angle();
  const PlacedOutline placed(outline, {});
  EXPECT_FALSE(placed.overlapsSquare({0.75, 0.75}, 0.25));
  EXPECT_TRUE(placed.overlapsSquare({0.75, 0.75}, 0.2501));
  EXPECT_FALSE(placed.overlapsDisc({{0.75, 0.75}, 0.25}));
  EXPECT_TRUE(placed.overlapsDisc({{0.75, 0.75}, 0.2501}));
}

// [SIM-3]
TEST(PlacedOutlines, TouchEachOtherWithoutOverlapping_SIM_3) {
  const Outline outline = block();
  const PlacedOutline placed(outline, {3.0, 5.0, 0.0});
  const auto overlaps = [&](const Pose2& pose) {
    const PlacedOutline other(outline, pose);
    EXPECT_EQ(placed.overlaps(other), other.overlaps(placed));
    return placed.overlaps(other);
  };
  EXPECT_FALSE(overlaps({5.0, 5.0, 0.0})) << "side to side";
  EXPECT_TRUE(overlaps({5.0 - 1e-9, 5.0, 0.0}));
  EXPECT_TRUE(overlaps({3.0, 5.0, 0.0})) << "one on the other";
  EXPECT_FALSE(overlaps({5.0, 7.0, 0.0})) << "corner to corner";
  EXPECT_TRUE(overlaps({4.9, 6.9, 0.0}));
  EXPECT_FALSE(overlaps({4.0 + std::sqrt(2.0) + 1e-9, 5.0, 0.25 * kPi})) << "a corner at a side";
  EXPECT_TRUE(overlaps({4.0 + std::sqrt(2.0) - 1e-9, 5.0, 0.25 * kPi}));
  EXPECT_FALSE(overlaps({4.8, 6.8, 0.25 * kPi})) << "the discs around them overlap";
}

// [SIM-3]
TEST(PlacedOutlines, OverlapDiscsOfRobotsExactly_SIM_3) {
  const Outline outline = block(), round = Outline::disc(0.5);
  const PlacedOutline placed(outline, {3.0, 5.0, 0.0}), touching(round, {4.5, 5.0, 1.0}),
      beyond(round, {4.4, 6.4, 1.0});
  EXPECT_FALSE(placed.overlaps(touching) || touching.overlaps(placed));
  EXPECT_FALSE(placed.overlaps(beyond) || beyond.overlaps(placed)) << "beside the corner";
  const PlacedOutline nearer(round, {4.49, 5.0, 1.0});
  EXPECT_TRUE(placed.overlaps(nearer) && nearer.overlaps(placed) && nearer.overlaps(touching));
}

// [SIM-3] against points of the squares and discs, thousands of each
TEST(PlacedOutlines, OverlapAsTheirPointsSay_SIM_3) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  constexpr int kPoints = 60;  // along a side
  int overlaps = 0;
  for (int i = 0; i < 2000; ++i) {
    const Outline outline = i % 2 == 0 ? block() : angle();
    const Pose2 pose(place(random), place(random), 2.0 * place(random));
    const Vec2 middle(place(random), place(random));
    const double half = 0.3 + 0.1 * place(random);
    double square = 1.0;
    double disc = 1.0;  // nearest to the outline, negative inside
    for (int x = 0; x <= kPoints; ++x) {
      for (int y = 0; y <= kPoints; ++y) {
        const Vec2 off = half * (Vec2(x, y) * 2.0 / kPoints - Vec2::Ones());
        const double distance = outline.distance(pose.inverse() * (middle + off));
        square = std::min(square, distance);
        if (off.norm() <= half) disc = std::min(disc, distance);
      }
    }
    const PlacedOutline placed(outline, pose);
    const double grain = half / kPoints;
    EXPECT_TRUE(square >= 0.0 || placed.overlapsSquare(middle, half)) << i;
    EXPECT_FALSE(square > grain && placed.overlapsSquare(middle, half)) << i;
    EXPECT_TRUE(disc >= 0.0 || placed.overlapsDisc({middle, half})) << i;
    EXPECT_FALSE(disc > 2.0 * grain && placed.overlapsDisc({middle, half})) << i;
    overlaps += square < 0.0 ? 1 : 0;
  }
  EXPECT_GT(overlaps, 500);
  EXPECT_LT(overlaps, 1500);
}

}  // namespace
}  // namespace frontier_pilot::sim
