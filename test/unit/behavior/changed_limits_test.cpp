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

// [SPN-5]
TEST(ChangedLimits, ARobotThatMayDriveFasterSeesFartherAndGoesOn) {
  test::BehaviorLoop loop(10.0, {0.8, 1.0, 2.5, 3.2});
  loop.start({behavior::BehaviorKind::kDriveOnHeading, 6.0, 0.8, 0.0, true});
  loop.run(2.0);
  behavior::BehaviorParameters faster = test::BehaviorLoop::parameters(10.0);
  faster.robot.limits.max_linear = 0.8;
  loop.behavior.setParameters(faster);
  loop.surroundings.setReach(faster.reach());
  const behavior::BehaviorOutput output = loop.run(30.0);
  EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kSucceeded) << output.message;
  EXPECT_NEAR(loop.base.pose().x, 6.0, 0.05);
}

}  // namespace
}  // namespace frontier_pilot
