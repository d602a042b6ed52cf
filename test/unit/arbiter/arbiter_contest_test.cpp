// Whether an emergency stop reaches the arbiter: another node that could answer in its place, callers that cannot
// connect.
#include "arbiter_fixture.h"

namespace frontier_pilot {
namespace {

// [ARB-12]
TEST_F(ArbiterTest, WhileContestedZeroLeavesAtOnceAndAtEveryTickWhateverArrives_ARB_12) {
  send("nav", 0.2);
  EXPECT_EQ(contest("/stranger"), Twist2{}) << "[ARB-12]";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kContested);
  published = 0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(send("nav", 0.1 + 0.001 * i), std::nullopt) << "[ARB-12]";
    wait(0.05);
    EXPECT_TRUE(wheels.isZero()) << "[ARB-12]";
  }
  EXPECT_EQ(published, 20) << "zero at 20 Hz";
}

// [ARB-12]
TEST_F(ArbiterTest, WhatWasCommandedWhileContestedIsForgottenWhenTheRivalIsGone_ARB_12) {
  contest("/stranger");
  send("nav", 0.2);
  EXPECT_EQ(contest(""), Twist2{}) << "[ARB-12]";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kIdle) << "no revival without a new message";
  EXPECT_EQ(send("nav", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-12]
TEST_F(ArbiterTest, TheStatusNamesTheRivalInWords_ARB_12) {
  contest("/stranger");
  EXPECT_NE(summarize(arbiter.status(now)).find("/stranger"), std::string::npos) << summarize(arbiter.status(now));
}

// [ARB-12]
TEST_F(ArbiterTest, TheSameRivalAgainChangesNothing_ARB_12) {
  contest("/stranger");
  EXPECT_EQ(contest("/stranger"), std::nullopt);
}

// [ARB-12] [ARB-7]
TEST_F(ArbiterTest, AStopGivenWhileContestedHoldsWhenTheRivalIsGone_ARB_12) {
  contest("/stranger");
  EXPECT_EQ(stop().publish, Twist2{});
  contest("");
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kEmergencyStop) << "[ARB-12]";
  EXPECT_EQ(send("nav", 0.1), std::nullopt);
}

// [ARB-12]
TEST_F(ArbiterTest, WhileNoStopCanBeCalledZerosLeaveAndAfterwardsOnlyANewCommandDrives_ARB_12) {
  send("nav", 0.2);
  EXPECT_EQ(setUnreachable("no socket is free"), Twist2{}) << "at once";
  EXPECT_EQ(setUnreachable("no socket is free"), std::nullopt) << "the same reason again changes nothing";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kUnreachable);
  EXPECT_EQ(summarize(arbiter.status(now)), "no emergency stop can be called, because no socket is free: stopped");
  EXPECT_EQ(send("nav", 0.2), std::nullopt);
  published = 0;
  wait(0.05);
  EXPECT_EQ(published, 1) << "zero at 20 Hz";
  setUnreachable("");
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kIdle);
  EXPECT_EQ(send("nav", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-12] [ARB-7]
TEST_F(ArbiterTest, AStopThatWasLatchedStaysLatchedWhileNoOtherCanBeCalled_ARB_12) {
  stop();
  setUnreachable("no socket is free");
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kEmergencyStop);
  setUnreachable("");
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kEmergencyStop);
}

// [ARB-12]
TEST_F(ArbiterTest, AParameterLetsTheRobotDriveOnBesideARival_ARB_12) {
  arbiter::ArbiterParameters tolerant;
  tolerant.stand_when_contested = false;
  configure(tolerant);
  send("nav", 0.2);
  EXPECT_EQ(contest("/stranger"), (Twist2{0.2, 0.0})) << "[ARB-12]";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kDriving);
}

}  // namespace
}  // namespace frontier_pilot
