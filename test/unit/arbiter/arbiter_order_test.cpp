// Who holds the wheels: order, freshness, heartbeats, required sources, limits.
#include "arbiter_fixture.h"

namespace frontier_pilot {
namespace {

// [ARB-1]
TEST_F(ArbiterTest, TheHigherSourceWinsInTheOrderAvoidBehaviorPatrolNavManual_ARB_1) {
  double speed = 0.01;
  for (const char* name : {"manual", "nav", "patrol", "behavior", "avoid"}) {
    EXPECT_EQ(send(name, speed), (Twist2{speed, 0.0})) << name << " must take over at once [ARB-1]";
    EXPECT_EQ(arbiter.status(now).active_source, name);
    speed += 0.01;
  }
  for (const char* name : {"manual", "nav", "patrol", "behavior"}) {
    EXPECT_EQ(send(name, 0.2), std::nullopt) << name << " must not pass below avoid [ARB-1]";
  }
}

// [ARB-1]
TEST_F(ArbiterTest, ASourceCountsUpToItsTimeoutAndNotLonger_ARB_1) {
  wait(0.05);
  send("nav", 0.1);
  advance(1.0);
  arbiter.update(now);
  EXPECT_EQ(arbiter.status(now).active_source, "nav") << "exactly the timeout old still counts [ARB-1]";
  advance(1e-9);
  EXPECT_EQ(arbiter.update(now), Twist2{}) << "one nanosecond more is stale [ARB-1]";
  EXPECT_EQ(source("nav").state, arbiter::SourceState::kStale);
}

// [ARB-1]
TEST_F(ArbiterTest, NobodyWasEverHeardMeansNobodyDrives_ARB_1) {
  wait(0.1);
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kIdle);
  for (const arbiter::SourceStatus& status : arbiter.status(now).sources) {
    EXPECT_EQ(status.state, arbiter::SourceState::kNeverHeard) << status.name;
    EXPECT_FALSE(status.age);
  }
}

// [ARB-2]
TEST_F(ArbiterTest, EveryMessageOfTheWinnerIsForwardedAtOnceEvenAnEqualOne_ARB_2) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(send("nav", 0.1, 0.5), (Twist2{0.1, 0.5})) << "[ARB-2]";
}

// [ARB-2]
TEST_F(ArbiterTest, ZeroLeavesAtEveryTickWhileNobodyDrives_ARB_2) {
  wait(1.0);
  EXPECT_EQ(published, 20) << "20 Hz, never silent [ARB-2]";
  EXPECT_TRUE(wheels.isZero());
}

// [ARB-2]
TEST_F(ArbiterTest, TheTickCoversExpiryAndHandsOverToTheNextFreshSource_ARB_2) {
  send("nav", 0.2);
  wait(0.5);
  send("manual", 0.05);
  wait(0.5);
  EXPECT_EQ(wheels, (Twist2{0.2, 0.0}));
  wait(0.05);
  EXPECT_EQ(wheels, (Twist2{0.05, 0.0})) << "the next tick after expiry hands over [ARB-2]";
  wait(0.5);
  EXPECT_TRUE(wheels.isZero()) << "and then to nobody [ARB-2]";
}

// [ARB-2]
TEST_F(ArbiterTest, TheTickDoesNotRepeatACommandOfTheDriver_ARB_2) {
  send("nav", 0.2);
  wait(0.5);
  EXPECT_EQ(published, 1) << "what leaves while a source drives is its own messages [ARB-2]";
}

// [ARB-3]
TEST_F(ArbiterTest, AZeroOfAvoidKeepsItAliveButLeavesTheWheelsToTheOthers_ARB_3) {
  send("nav", 0.2);
  EXPECT_EQ(send("avoid", 0.0), std::nullopt);
  EXPECT_EQ(arbiter.status(now).active_source, "nav") << "[ARB-3]";
  EXPECT_EQ(source("avoid").state, arbiter::SourceState::kIdle);
}

// [ARB-3]
TEST_F(ArbiterTest, WhenAvoidFallsIdleTheNextSourceHasTheWheelsAtOnce_ARB_3) {
  send("avoid", -0.08);
  send("nav", 0.2);
  EXPECT_EQ(send("avoid", 0.0), (Twist2{0.2, 0.0})) << "[ARB-3]";
}

// [ARB-3] [AVO-5]
TEST_F(ArbiterTest, AHoldOfAvoidClaimsTheWheelsAlthoughItIsZero_ARB_3) {
  send("nav", 0.2);
  EXPECT_EQ(arbiter.onCommand(*arbiter.find("avoid"), {}, now, true), Twist2{});
  EXPECT_EQ(send("nav", 0.2), std::nullopt) << "a fault of the avoider holds the robot [AVO-5]";
  EXPECT_EQ(arbiter.status(now).active_source, "avoid");
}

// [ARB-3]
TEST_F(ArbiterTest, AZeroOfAnyOtherSourceHoldsTheWheels_ARB_3) {
  for (const char* name : {"nav", "patrol", "behavior"}) {
    send("manual", 0.2);
    EXPECT_EQ(send(name, 0.0), Twist2{}) << name;
    EXPECT_EQ(send("manual", 0.2), std::nullopt) << name << " holds with zero [ARB-3]";
  }
}

// [ARB-4]
TEST_F(ArbiterTest, WithoutTheRequiredSourceTheLowerOnesMayOnlyTurnAndReverse_ARB_4) {
  configure(withRequiredAvoid());
  EXPECT_EQ(send("nav", 0.2, 0.5), (Twist2{0.0, 0.5})) << "no forward motion [ARB-4]";
  EXPECT_EQ(send("nav", -0.1, 0.5), (Twist2{-0.1, 0.5})) << "reverse and turn are free [ARB-4]";
  EXPECT_EQ(arbiter.status(now).missing_sources, std::vector<std::string>{"avoid"}) << "[ARB-4]";
  EXPECT_NE(summarize(arbiter.status(now)).find("avoid is required but silent"), std::string::npos);
}

// [ARB-4]
TEST_F(ArbiterTest, TheHeartbeatOfTheRequiredSourceFreesForwardMotionUntilItsTimeout_ARB_4) {
  configure(withRequiredAvoid());
  send("nav", 0.2);
  EXPECT_EQ(send("avoid", 0.0), (Twist2{0.2, 0.0})) << "heard: forward at once [ARB-4]";
  EXPECT_TRUE(arbiter.status(now).missing_sources.empty());
  wait(0.95);
  send("nav", 0.2);
  wait(0.1);
  EXPECT_TRUE(wheels.isZero()) << "silent past its timeout: forward ends [ARB-4]";
  EXPECT_EQ(arbiter.status(now).active_source, "nav");
}

// [ARB-4]
TEST_F(ArbiterTest, ADisabledRequiredSourceIsNotMissed_ARB_4) {
  configure(withRequiredAvoid());
  send("nav", 0.2);
  EXPECT_EQ(enable("avoid", false).publish, (Twist2{0.2, 0.0})) << "[ARB-4]";
  EXPECT_TRUE(arbiter.status(now).missing_sources.empty());
}

// [ARB-4]
TEST_F(ArbiterTest, ASilentRequiredSourceDoesNotHinderTheOnesAboveIt_ARB_4) {
  arbiter::ArbiterParameters parameters;
  parameters.sources[3].required = true;
  configure(parameters);
  EXPECT_EQ(send("patrol", 0.2), (Twist2{0.2, 0.0})) << "patrol is above nav [ARB-4]";
}

// [ARB-5]
TEST_F(ArbiterTest, ANonFiniteCommandMakesItsSourceStaleAtOnceAndIsCounted_ARB_5) {
  send("manual", 0.05);
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    send("nav", 0.2);
    EXPECT_EQ(send("nav", bad), (Twist2{0.05, 0.0})) << "the lower source takes over at once [ARB-5]";
    send("nav", 0.2);
    EXPECT_EQ(send("nav", 0.1, bad), (Twist2{0.05, 0.0})) << "either axis [ARB-5]";
  }
  EXPECT_EQ(source("nav").rejected, 6U);
  EXPECT_EQ(source("nav").state, arbiter::SourceState::kRejected);
  EXPECT_EQ(send("nav", 0.2), (Twist2{0.2, 0.0})) << "a good message heals it";
}

// [ARB-5]
TEST_F(ArbiterTest, FiniteCommandsAreClampedToTheLimitsOfTheRobot_ARB_5) {
  EXPECT_EQ(send("nav", 1e300, -1e300), (Twist2{0.22, -2.84})) << "[ARB-5]";
  EXPECT_EQ(send("nav", -0.23, 2.85), (Twist2{-0.22, 2.84})) << "[ARB-5]";
}

TEST_F(ArbiterTest, StatusSaysAgeAndRateOfEverySource) {
  wait(1.0);
  for (int i = 0; i < 40; ++i) {
    send("nav", 0.1);
    wait(0.05);
  }
  EXPECT_NEAR(source("nav").rate, 20.0, 1.0);
  EXPECT_NEAR(source("nav").age.value(), 0.05, 1e-9);
  EXPECT_EQ(source("manual").rate, 0.0);
  EXPECT_EQ(summarize(arbiter.status(now)), "nav drives");
  send("nav", 0.0);
  EXPECT_EQ(summarize(arbiter.status(now)), "nav holds the robot still");
}

TEST_F(ArbiterTest, TheSummaryNamesASourceThatAsksToMoveAlthoughItIsDisabled) {
  enable("nav", false);
  send("nav", 0.0);
  EXPECT_EQ(summarize(arbiter.status(now)), "nobody asks for the wheels: stopped") << "a zero is no motion";
  send("nav", 0.1);
  EXPECT_EQ(summarize(arbiter.status(now)), "nav asks to move, but is disabled (set_nav_enabled true): stopped");
  wait(2.5);
  EXPECT_EQ(summarize(arbiter.status(now)), "nobody asks for the wheels: stopped") << "it asks no longer";
  send("nav", 0.1);
  send("manual", 0.1);
  EXPECT_EQ(summarize(arbiter.status(now)), "manual drives");
  send("manual", 0.0);
  EXPECT_EQ(summarize(arbiter.status(now)),
            "manual holds the robot still; nav asks to move, but is disabled (set_nav_enabled true)")
      << "as the window does";
}

}  // namespace
}  // namespace frontier_pilot
