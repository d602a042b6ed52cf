// Parameters that change while a behaviour runs.
#include <gtest/gtest.h>

#include "behavior_loop.h"

namespace frontier_pilot {
namespace {

TEST(ChangedLimits, HoldFromTheNextCycleOnAndTheSpinStillEndsWhereItShould) {
  test::BehaviorLoop loop;
  loop.start({behavior::BehaviorKind::kSpin, 2.0 * kPi, 0.0, 0.0, true});
  loop.run(2.0);
  EXPECT_NEAR(loop.base.twist().angular, 1.0, 0.01);
  behavior::BehaviorParameters slower = test::BehaviorLoop::parameters(10.0);
  slower.robot.limits.max_angular = 0.5;
  loop.behavior.setParameters(slower);
  EXPECT_EQ(loop.cycle().command->angular, 0.5);
  EXPECT_EQ(loop.run(30.0).outcome, behavior::BehaviorOutcome::kSucceeded);
  EXPECT_NEAR(loop.base.pose().yaw, 0.0, 0.05);
}

}  // namespace
}  // namespace frontier_pilot
