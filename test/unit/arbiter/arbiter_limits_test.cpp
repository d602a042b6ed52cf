// Limits that change while the robot is driven.
#include "arbiter_fixture.h"

namespace frontier_pilot {
namespace {

RobotLimits limits(double linear, double angular) {
  RobotLimits made;
  made.max_linear = linear;
  made.max_angular = angular;
  return made;
}

// [ARB-5]
TEST_F(ArbiterTest, ALowerLimitHoldsAtOnceForTheCommandInForceAndForAllThatFollow_ARB_5) {
  send("nav", 0.2, 1.0);
  EXPECT_EQ(arbiter.setLimits(limits(0.1, 0.5), now), (Twist2{0.1, 0.5})) << "[ARB-5]";
  EXPECT_EQ(send("nav", -0.2, -1.0), (Twist2{-0.1, -0.5})) << "[ARB-5]";
}

// [ARB-5]
TEST_F(ArbiterTest, AHigherLimitSpeedsUpNothingUntilASourceAsksForIt_ARB_5) {
  send("nav", 0.5);
  EXPECT_EQ(arbiter.setLimits(limits(0.4, 1.0), now), std::nullopt);
  wait(0.1);
  EXPECT_EQ(wheels, (Twist2{0.22, 0.0})) << "the limit of the time when it was asked for";
  EXPECT_EQ(send("nav", 0.5), (Twist2{0.4, 0.0}));
}

// [ARB-7]
TEST_F(ArbiterTest, OtherLimitsLetNothingThroughAStop_ARB_7) {
  send("nav", 0.2);
  stop();
  published = 0;
  for (const double most : {0.05, 0.2, 1.0, 20.0}) {
    EXPECT_EQ(arbiter.setLimits(limits(most, most), now), std::nullopt) << "[ARB-7]";
    send("nav", most);
    wait(0.05);
    EXPECT_TRUE(wheels.isZero()) << "[ARB-7]";
  }
  EXPECT_TRUE(arbiter.stopped());
}

}  // namespace
}  // namespace frontier_pilot
