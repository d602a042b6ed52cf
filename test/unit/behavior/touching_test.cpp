#include <gtest/gtest.h>

#include "behavior_loop.h"

namespace frontier_pilot {
namespace {

// [SPN-3] [SPN-4]
TEST(Touching, WhatTouchesTheFootprintAlreadyIsToldApart) {
  test::BehaviorLoop loop;
  loop.points = {{-0.1, 0.09}};
  loop.start({behavior::BehaviorKind::kSpin, 1.0, 0.0, 0.0, true});
  const behavior::BehaviorOutput output = loop.cycle();
  EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kCollisionAhead);
  EXPECT_EQ(output.message, "an obstacle touches the footprint; move away first");
}

// [SPN-3] [SPN-4] Backwards, the half of the footprint behind the origin leads.
TEST(Touching, WhatTouchesTheLeadingHalfIsToldApartBackwardsAsWell) {
  using Kind = behavior::BehaviorKind;
  for (const behavior::BehaviorGoal& goal : {behavior::BehaviorGoal{Kind::kBackUp, 0.3, 0.0, 0.0, true},
                                             behavior::BehaviorGoal{Kind::kDriveOnHeading, -0.3, 0.0, 0.0, true}}) {
    test::BehaviorLoop loop;
    loop.points = {{-0.1, 0.09}};
    loop.start(goal);
    const behavior::BehaviorOutput output = loop.cycle();
    EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kCollisionAhead);
    EXPECT_EQ(output.message, "an obstacle touches the footprint; move away first") << toString(goal.kind);
  }
}

// [SPN-3] [SPN-4] What a motion leaves behind does not prevent it, so it is not the reason either.
TEST(Touching, WhatIsLeftBehindBackwardsIsNotTheReason) {
  using Kind = behavior::BehaviorKind;
  for (const behavior::BehaviorGoal& goal : {behavior::BehaviorGoal{Kind::kBackUp, 0.3, 0.0, 0.0, true},
                                             behavior::BehaviorGoal{Kind::kDriveOnHeading, -0.3, 0.0, 0.0, true}}) {
    test::BehaviorLoop loop;
    loop.points = {{0.03, 0.09}, {-0.16, 0.0}};
    loop.start(goal);
    const behavior::BehaviorOutput output = loop.cycle();
    EXPECT_EQ(output.outcome, behavior::BehaviorOutcome::kCollisionAhead);
    EXPECT_EQ(output.message, "not free ahead: an obstacle") << toString(goal.kind);
  }
}

}  // namespace
}  // namespace frontier_pilot
