// Switches, the emergency stop, and clocks that misbehave.
#include "arbiter_fixture.h"

namespace frontier_pilot {
namespace {

// [ARB-6]
TEST_F(ArbiterTest, DisablingTakesTheWheelsBeforeItAnswersAndForgetsTheCommand_ARB_6) {
  send("nav", 0.2);
  const arbiter::ArbiterAnswer answer = enable("nav", false);
  EXPECT_EQ(answer.publish, Twist2{}) << "the zero is part of the answer [ARB-6]";
  EXPECT_EQ(answer.message, "nav disabled");
  EXPECT_EQ(send("nav", 0.2), std::nullopt) << "[ARB-6]";
  EXPECT_EQ(enable("nav", true).publish, std::nullopt);
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kIdle) << "no revival: a new message is needed [ARB-6]";
  EXPECT_EQ(send("nav", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-6]
TEST_F(ArbiterTest, SwitchingTwiceAnswersThatNothingChangedAndKeepsTheCommand_ARB_6) {
  send("nav", 0.2);
  const arbiter::ArbiterAnswer answer = enable("nav", true);
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "nav enabled already: nothing changed") << "[ARB-6]";
  EXPECT_EQ(answer.publish, std::nullopt);
  EXPECT_EQ(arbiter.status(now).active_source, "nav");
  enable("nav", false);
  EXPECT_EQ(enable("nav", false).message, "nav disabled already: nothing changed") << "[ARB-6]";
}

// [ARB-7]
TEST_F(ArbiterTest, AStopPutsOutZeroAndWhateverArrivesOnlyZeroLeavesAtTheTick_ARB_7) {
  send("avoid", 0.2);
  EXPECT_EQ(stop().publish, Twist2{}) << "zero before the answer [ARB-7]";
  published = 0;
  for (int i = 0; i < 20; ++i) {
    for (const char* name : {"avoid", "behavior", "patrol", "nav", "manual"}) {
      EXPECT_EQ(send(name, 0.1 + 0.001 * i), std::nullopt) << "[ARB-7]";
    }
    wait(0.05);
    EXPECT_TRUE(wheels.isZero()) << "[ARB-7]";
  }
  EXPECT_EQ(published, 20) << "zero at 20 Hz [ARB-7]";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kEmergencyStop);
}

// [ARB-7]
TEST_F(ArbiterTest, StoppingTwiceIsOneLatchThatKeepsItsFirstCause_ARB_7) {
  arbiter.stop("first", now);
  const arbiter::ArbiterAnswer second = arbiter.stop("second", now);
  EXPECT_TRUE(second.success);
  EXPECT_EQ(second.publish, Twist2{}) << "a zero leaves for every call [ARB-7]";
  EXPECT_EQ(arbiter.stopCause(), "first");
  EXPECT_EQ(arbiter.status(now).stops, 2U) << "the operator's window can tell that another stop has come";
  advance(0.1);
  EXPECT_TRUE(clear().success);
  EXPECT_FALSE(arbiter.stopped()) << "one clear undoes two stops [ARB-7]";
}

// [FLT-2]
TEST_F(ArbiterTest, TheStopsOfTheArbiterBeforeItCountAndTheOneThatWasLatchedThenCountsOnTop_FLT_2) {
  stop();
  arbiter.countStopsFrom(3);
  EXPECT_EQ(arbiter.stops(), 4U) << "it may not have been counted any more";
  stop();
  EXPECT_EQ(arbiter.stops(), 5U);
}

// [ARB-8]
TEST_F(ArbiterTest, ClearingDropsEveryCommandAndNeverMovesTheRobot_ARB_8) {
  send("nav", 0.2);
  stop();
  wait(0.45);
  send("manual", 0.0);
  wait(0.1);
  const arbiter::ArbiterAnswer answer = clear();
  EXPECT_TRUE(answer.success) << answer.message;
  EXPECT_TRUE(wheels.isZero());
  wait(0.5);
  EXPECT_TRUE(wheels.isZero()) << "nav's command of before the stop must not come back [ARB-8]";
  for (const arbiter::SourceStatus& status : arbiter.status(now).sources) {
    EXPECT_EQ(status.state, arbiter::SourceState::kNeverHeard) << status.name << " [ARB-8]";
  }
  EXPECT_EQ(send("nav", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-8]
TEST_F(ArbiterTest, ClearingIsRefusedWhileAnEnabledSourceAsksToMove_ARB_8) {
  stop();
  wait(1.0);
  send("nav", 0.0, 0.1);
  wait(0.5);
  const arbiter::ArbiterAnswer refused = clear();
  EXPECT_FALSE(refused.success) << "0.5 s is not yet quiet [ARB-8]";
  EXPECT_EQ(refused.message, "refused: nav asked to move 500 ms ago; end what drives it, then clear");
  EXPECT_TRUE(arbiter.stopped());
  advance(1e-9);
  EXPECT_TRUE(clear().success) << "[ARB-8]";
}

// [ARB-8]
TEST_F(ArbiterTest, ADisabledSourceOrAZeroDoesNotHinderClearing_ARB_8) {
  stop();
  enable("nav", false);
  wait(1.0);
  send("nav", 0.2);
  send("patrol", 0.0);
  EXPECT_TRUE(clear().success) << "[ARB-8]";
}

// [ARB-8]
TEST_F(ArbiterTest, ClearingWhatIsNotStoppedSucceedsAndChangesNothing_ARB_8) {
  send("nav", 0.2);
  const arbiter::ArbiterAnswer answer = clear();
  EXPECT_TRUE(answer.success) << "[ARB-8]";
  EXPECT_EQ(answer.publish, std::nullopt);
  EXPECT_EQ(arbiter.status(now).active_source, "nav") << "not even the commands are dropped";
}

// [ARB-8]
TEST_F(ArbiterTest, AStopThatWasGivenWhileAClearWasUnderWayWins_ARB_8) {
  stop();
  wait(1.0);
  const SteadyTime called = now.steady;
  advance(0.001);
  stop();
  advance(0.001);
  const arbiter::ArbiterAnswer answer = arbiter.clear(called, now);
  EXPECT_FALSE(answer.success) << "[ARB-8]";
  EXPECT_EQ(answer.message, "refused: a stop was given while this call was under way");
  EXPECT_TRUE(arbiter.stopped());
  EXPECT_TRUE(clear().success) << "a clear that is called after the stop counts";
}

// [ARB-8]
TEST_F(ArbiterTest, AClearThatCameBeforeTheAnswerToAStopIsRefusedForNobodyKnewOfTheStop_ARB_8) {
  wait(1.0);
  stop();
  advance(0.001);
  const SteadyTime called = now.steady;
  advance(0.001);
  arbiter.answerStop(now.steady);
  EXPECT_FALSE(arbiter.clear(called, now).success) << "[ARB-8]";
  advance(0.001);
  EXPECT_TRUE(clear().success);
}

// [ARB-9]
TEST_F(ArbiterTest, AStandingClockStopsTheRobotAndNothingRevivesWithoutANewMessage_ARB_9) {
  wait(0.1);
  send("nav", 0.2);
  waitWithStoppedClock(0.45);
  EXPECT_EQ(wheels, (Twist2{0.2, 0.0}));
  waitWithStoppedClock(0.05);
  EXPECT_TRUE(wheels.isZero()) << "0.5 s of standing ROS time [ARB-9]";
  EXPECT_EQ(arbiter.status(now).state, arbiter::ArbiterState::kClockStopped);
  EXPECT_EQ(send("nav", 0.2), std::nullopt) << "a message while time stands does not count [ARB-9]";
  published = 0;
  waitWithStoppedClock(1.0);
  EXPECT_EQ(published, 20) << "zeros go on by the steady clock [ARB-9]";
  wait(0.1);
  EXPECT_TRUE(wheels.isZero()) << "time goes on: still no new message [ARB-9]";
  EXPECT_EQ(send("nav", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-9]
TEST_F(ArbiterTest, ABackwardJumpMakesEverySourceStaleForGood_ARB_9) {
  send("nav", 0.2);
  send("manual", 0.2);
  wait(0.1);
  jump(-10.0);
  EXPECT_EQ(arbiter.tick(now), Twist2{}) << "[ARB-9]";
  jump(10.0);
  EXPECT_EQ(arbiter.tick(now), Twist2{}) << "jumping forth again revives nothing [ARB-9]";
  EXPECT_EQ(source("nav").state, arbiter::SourceState::kNeverHeard);
  EXPECT_EQ(send("manual", 0.1), (Twist2{0.1, 0.0}));
}

// [ARB-9]
TEST_F(ArbiterTest, TheMessageThatComesWithABackwardJumpCountsAloneAndTheOthersAreGone_ARB_9) {
  send("patrol", 0.2);
  jump(-1.0);
  EXPECT_EQ(send("manual", 0.1), (Twist2{0.1, 0.0})) << "[ARB-9]";
}

// [ARB-9]
TEST_F(ArbiterTest, AForwardJumpPastTheTimeoutIsExpiryAndJumpingBackDoesNotUndoIt_ARB_9) {
  send("nav", 0.2);
  jump(3600.0);
  EXPECT_EQ(arbiter.update(now), Twist2{});
  jump(-3600.0);
  EXPECT_EQ(arbiter.tick(now), Twist2{}) << "[ARB-9]";
}

}  // namespace
}  // namespace frontier_pilot
