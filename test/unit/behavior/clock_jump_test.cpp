#include <gtest/gtest.h>

#include "behavior_loop.h"
#include "frontier_pilot/behavior/timed_behavior.h"

namespace frontier_pilot {
namespace {

using test::BehaviorLoop;

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

TEST(BehaviorClock, ASpinEndsWhenTheClockJumpsBack) {
  BehaviorLoop loop;
  loop.start({behavior::BehaviorKind::kSpin, 2.0, 0.0, 0.0, true});
  loop.run(1.0);
  const behavior::BehaviorOutput output = loop.behavior.update(loop.inputs, loop.base.now() - fromSeconds(1.0));
  EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kPoseLost);
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
}

}  // namespace
}  // namespace frontier_pilot
