#include "frontier_pilot/core/motion.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

TEST(TurnCounter, CountsAcrossTheSeamInBothDirectionsAndPastAWholeTurn) {
  TurnCounter left;
  TurnCounter right;
  left.restart(3.0);
  right.restart(-3.0);
  for (int i = 1; i <= 80; ++i) {
    left.add(normalizeAngle(3.0 + 0.1 * i));
    right.add(normalizeAngle(-3.0 - 0.1 * i));
  }
  EXPECT_NEAR(left.total(), 8.0, 1e-9);
  EXPECT_NEAR(right.total(), -8.0, 1e-9);
}

TEST(BrakingSpeed, UsesUpExactlyTheDistanceWithTheReactionCounted) {
  for (const double distance : {0.001, 0.1, 2.0}) {
    for (const double reaction : {0.0, 0.1, 0.5}) {
      const double v = brakingSpeed(distance, 0.4, reaction);
      EXPECT_NEAR(v * reaction + v * v / 0.8, distance, 1e-12);
    }
  }
  EXPECT_EQ(brakingSpeed(0.0, 0.4, 0.1), 0.0);
  EXPECT_EQ(brakingSpeed(-1.0, 0.4), 0.0);
}

TEST(IsJump, LooksAtBothDistanceAndAngleTheShortWayRound) {
  EXPECT_FALSE(isJump({0.0, 0.0, 3.1}, {0.3, 0.3, -3.1}, 0.5, 1.0));
  EXPECT_TRUE(isJump({0.0, 0.0, 0.0}, {0.4, 0.4, 0.0}, 0.5, 1.0));
  EXPECT_TRUE(isJump({0.0, 0.0, 0.0}, {0.0, 0.0, -1.1}, 0.5, 1.0));
}

}  // namespace
}  // namespace frontier_pilot
