#include "patrol/plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::string problem(double mode, double size, double laps) {
  return problemOf({mode, size, laps}, patrol::PatrolParameters()).value_or("");
}

// [PAT-1]
TEST(PatrolOrder, OnlyTheThreeModesAreKnown) {
  for (const double mode : {1.0, 2.0, 3.0}) EXPECT_EQ(problem(mode, 1.0, 1.0), "");
  for (const double mode : {0.0, 4.0, 1.5, -1.0, kNan, kInf}) {
    EXPECT_EQ(problem(mode, 1.0, 1.0), "invalid patrol mode") << mode;
  }
}

// [PAT-1]
TEST(PatrolOrder, ASideThatIsNotFinitePositiveAndShortEnoughIsNamed) {
  EXPECT_EQ(problem(1.0, 10.0, 1.0), "");
  EXPECT_EQ(problem(1.0, 10.5, 1.0), "invalid goal.y (side): must be finite, above 0 and at most 10 m, is 10.5");
  for (const double side : {0.0, -1.0, kNan, kInf, -kInf}) {
    EXPECT_NE(problem(1.0, side, 1.0).find("goal.y (side)"), std::string::npos) << side;
    EXPECT_NE(problem(3.0, side, 1.0).find("goal.y (radius)"), std::string::npos) << side;
  }
}

// [PAT-1]
TEST(PatrolOrder, LapsThatAreNotAWholeNumberInTheLimitsAreNamed) {
  EXPECT_EQ(problem(2.0, 1.0, 100.0), "");
  EXPECT_EQ(problem(2.0, 1.0, 2.5),
            "invalid goal.z (laps): must be a whole number, at least 1 and at most 100, is 2.5");
  for (const double laps : {0.0, -1.0, 101.0, kNan, kInf}) {
    EXPECT_NE(problem(2.0, 1.0, laps).find("goal.z (laps)"), std::string::npos) << laps;
  }
}

TEST(PatrolPlan, StepsFollowEachOtherAndEndWhereTheyBegan) {
  for (const double mode : {1.0, 2.0}) {
    const std::vector<patrol::PatrolStep> steps = patrol::planPatrol({mode, 1.5, 3.0});
    Pose2 pose;
    for (const patrol::PatrolStep& step : steps) {
      EXPECT_LT((pose.position() - step.start.position()).norm(), 1e-9);
      EXPECT_NEAR(angleDifference(pose.yaw, step.start.yaw), 0.0, 1e-9);
      pose = pose * (step.kind == patrol::PatrolStep::Kind::kLine ? Pose2(step.amount, 0.0, 0.0)
                                                                  : Pose2(0.0, 0.0, step.amount));
    }
    EXPECT_LT(pose.position().norm(), 1e-9);
    EXPECT_NEAR(angleDifference(pose.yaw, 0.0), 0.0, 1e-9);
  }
}

TEST(PatrolPlan, LegsAreNumberedFromOneOverAllLaps) {
  int leg = 0;
  for (const patrol::PatrolStep& step : patrol::planPatrol({2.0, 1.0, 2.0})) {
    if (step.leg > 0) {
      EXPECT_EQ(step.leg, ++leg);
    }
  }
  EXPECT_EQ(leg, 6);
  EXPECT_EQ(patrol::legsOf({2.0, 1.0, 2.0}), 6);
  EXPECT_EQ(patrol::legsOf({1.0, 1.0, 2.0}), 8);
  EXPECT_EQ(patrol::legsOf({3.0, 1.0, 2.0}), 2);
}

TEST(PatrolPlan, AllLapsOfACircleAreOneArc) {
  const std::vector<patrol::PatrolStep> steps = patrol::planPatrol({3.0, 0.7, 2.0});
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].kind, patrol::PatrolStep::Kind::kArc);
  EXPECT_DOUBLE_EQ(steps[0].amount, 4.0 * kPi);
  EXPECT_DOUBLE_EQ(steps[0].radius, 0.7);
}

}  // namespace
}  // namespace frontier_pilot
