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

}  // namespace
}  // namespace frontier_pilot
