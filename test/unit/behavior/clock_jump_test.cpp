#include <gtest/gtest.h>

#include "frontier_pilot/behavior/timed_behavior.h"

namespace frontier_pilot {
namespace {

// [FLT-1] No time is before that of a goal which came before the first /clock.
TEST(TimedBehavior, AClockThatJumpsEndsItAlsoWhenItBeganAtTimeZero) {
  TimedBehavior behavior{BehaviorParameters()};
  behavior.start(BehaviorGoal{BehaviorKind::kSpin, 2.0}, Time{});
  const BehaviorOutput output = behavior.abortByClockJump();
  EXPECT_EQ(output.outcome, BehaviorOutcome::kPoseLost);
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
  EXPECT_EQ(output.message, "the clock jumped");
  EXPECT_FALSE(behavior.abortByClockJump().command.has_value()) << "once";
}

}  // namespace
}  // namespace frontier_pilot
