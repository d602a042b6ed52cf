#include "ros/fleet_stop/stop_answer.h"

#include <gtest/gtest.h>

#include "ros/common/messages/stop_words.h"

namespace frontier_pilot {
namespace {

const StopAnswer kConfirmed{StopOutcome::kConfirmed, "stopped (answered by /robot1/cmd_vel_arbiter)"};

// [MUL-4]
TEST(StopAnswer, IsASuccessOnlyIfEveryRobotHasConfirmed_MUL_4) {
  const FleetAnswer all = summarize({{"/robot1/emergency_stop", kConfirmed}, {"/robot2/emergency_stop", kConfirmed}});
  EXPECT_TRUE(all.success);
  EXPECT_EQ(all.message, "2 of 2 robots stopped");
}

// [MUL-4]
TEST(StopAnswer, NamesEachRobotThatHasNotConfirmedWithTheReason_MUL_4) {
  const FleetAnswer answer = summarize({{"/robot1/emergency_stop", kConfirmed},
                                        {"/robot2/emergency_stop", {StopOutcome::kSilent, {}}},
                                        {"/floor/robot3/emergency_stop", {StopOutcome::kNoService, {}}},
                                        {"/emergency_stop", {StopOutcome::kRefused, "not now"}}});
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.message,
            "1 of 4 robots stopped; not confirmed by robot2: silent; not confirmed by floor/robot3: no service; "
            "not confirmed by /: refused: not now");
}

// [ARB-7] [MUL-4] It is latched, so that it is a success; but nobody may take it for a robot that stands.
TEST(StopAnswer, SaysOfEachRobotWhetherItsZeroMayNotHaveBeenSentYet_ARB_7_MUL_4) {
  const std::string late = answerOfStop("stopped", false);
  EXPECT_EQ(late, "stopped, but the zero velocity may not have been sent yet: make sure that the robot stands");
  EXPECT_EQ(answerOfStop("stopped", true), "stopped");
  EXPECT_TRUE(mayBeUnsent(late));
  EXPECT_FALSE(mayBeUnsent("stopped already: emergency_stop called by /me"));
  const FleetAnswer answer =
      summarize({{"/robot1/emergency_stop", kConfirmed}, {"/robot2/emergency_stop", {StopOutcome::kConfirmed, late}}});
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "2 of 2 robots stopped; robot2: " + late);
}

// [ARB-12]
TEST(StopAnswer, IsSignedByTheArbiter_ARB_12) {
  const std::string answer = "refused: nav asked to move " + signatureOf("/robot1/cmd_vel_arbiter");
  EXPECT_EQ(answer, "refused: nav asked to move (answered by /robot1/cmd_vel_arbiter)");
  EXPECT_TRUE(isSigned(answer));
  EXPECT_EQ(withoutSignature(answer), "refused: nav asked to move");
  EXPECT_EQ(withoutSignature("refused"), "refused");
  EXPECT_FALSE(leavesDoubt(answer));
  EXPECT_TRUE(leavesDoubt(unsignedAnswerOf("robot1")));
}

// [ARB-12] [MUL-4]
TEST(StopAnswer, SaysOfEachRobotWhetherAnArbiterHasAnswered_ARB_12_MUL_4) {
  const FleetAnswer answer = summarize(
      {{"/robot1/emergency_stop", kConfirmed}, {"/robot2/emergency_stop", {StopOutcome::kConfirmed, "stopped"}}});
  EXPECT_EQ(answer.message,
            "2 of 2 robots stopped; the answer of robot2 is not signed by an arbiter: make sure that the robot stands");
}

// [MUL-4]
TEST(StopAnswer, IsNoSuccessWithoutARobot_MUL_4) {
  EXPECT_FALSE(summarize({}).success);
  EXPECT_EQ(summarize({}).message, "no robot is listed or known");
}

}  // namespace
}  // namespace frontier_pilot
