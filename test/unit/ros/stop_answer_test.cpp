#include "ros/fleet_stop/stop_answer.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

const StopAnswer kConfirmed{StopOutcome::kConfirmed, "stopped"};

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

// [MUL-4]
TEST(StopAnswer, IsNoSuccessWithoutARobot_MUL_4) {
  EXPECT_FALSE(summarize({}).success);
  EXPECT_EQ(summarize({}).message, "no robot is listed or known");
}

}  // namespace
}  // namespace frontier_pilot
