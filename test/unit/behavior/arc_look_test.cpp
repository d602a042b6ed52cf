#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "frontier_pilot/behavior/collision_check.h"

namespace frontier_pilot {
namespace {

using behavior::AxisMotion;
using behavior::SweepResult;

constexpr double kRadius = 0.187;  // of a TurtleBot2 with its margin [m]

/// The look ahead of a disc, at one obstacle.
behavior::LookAhead at(const Vec2& obstacle) {
  return [obstacle](const Pose2& T_odom_base, const AxisMotion& motion) {
    const double length = motion.axis == AxisMotion::Axis::kLine ? motion.amount : 0.0;
    const Vec2 there = T_odom_base.inverse() * obstacle;
    const double beside = std::clamp(there.x(), std::min(0.0, length), std::max(0.0, length));
    return (there - Vec2(beside, 0.0)).norm() < kRadius ? SweepResult::kObstacle : SweepResult::kClear;
  };
}

// [PAT-7]
TEST(ArcLook, FindsWhatTheBulgeOfACircleTouchesAndItsChordDoesNot_PAT_7) {
  const Twist2 arc{0.5, 1.0};
  const Vec2 obstacle(0.310, -0.068);
  EXPECT_EQ(at(obstacle)(Pose2(0.0, 0.0, 0.5), {AxisMotion::Axis::kLine, 0.48}), SweepResult::kClear) << "the chord";
  EXPECT_EQ(behavior::lookAlongArc(at(obstacle), Pose2(), arc), SweepResult::kObstacle);
  EXPECT_EQ(behavior::lookAlongArc(at({0.310, 0.068}), Pose2(), {0.5, -1.0}), SweepResult::kObstacle) << "to the right";
}

TEST(ArcLook, DoesNotFindWhatTheArcPasses) {
  const Vec2 centre(0.0, 0.5);
  for (double angle = 0.1; angle < 1.0; angle += 0.1) {
    const Vec2 outwards(std::sin(angle), -std::cos(angle));
    EXPECT_EQ(behavior::lookAlongArc(at(centre + (0.5 + kRadius + 0.006) * outwards), Pose2(), {0.5, 1.0}),
              SweepResult::kClear)
        << angle;
    EXPECT_EQ(behavior::lookAlongArc(at(centre + (0.5 + kRadius - 0.006) * outwards), Pose2(), {0.5, 1.0}),
              SweepResult::kObstacle)
        << angle;
  }
}

TEST(ArcLook, LooksAlongALineAndATurnOnTheSpotAtOnce) {
  EXPECT_EQ(behavior::lookAlongArc(at({0.6, 0.0}), Pose2(), {0.5, 0.0}), SweepResult::kObstacle);
  EXPECT_EQ(behavior::lookAlongArc(at({0.7, 0.0}), Pose2(), {0.5, 0.0}), SweepResult::kClear);
  EXPECT_EQ(behavior::lookAlongArc(at({0.1, 0.0}), Pose2(), {0.0, 3.0}), SweepResult::kObstacle);
}

}  // namespace
}  // namespace frontier_pilot
