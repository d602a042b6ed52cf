#include <gtest/gtest.h>

#include "frontier_pilot/behavior/timed_behavior.h"

namespace frontier_pilot {
namespace {

// [FLT-1] No time is before that of a goal which came before the first /clock.
TEST(TimedBehavior, AClockThatJumpsEndsItAlsoWhenItBeganAtTimeZero) {
  behavior::TimedBehavior behavior{behavior::BehaviorParameters()};
  behavior.start(behavior::BehaviorGoal{behavior::BehaviorKind::kSpin, 2.0}, Time{});
  const behavior::BehaviorOutput output = behavior.abortByClockJump();
  EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kPoseLost);
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
  EXPECT_EQ(output.message, "the clock jumped");
  EXPECT_FALSE(behavior.abortByClockJump().command.has_value()) << "once";
}

}  // namespace
}  // namespace frontier_pilot
