#include "ros/common/messages/robot_speakers.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime steadyAt(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

TEST(RobotSpeakers, OfTwoNodesTheOneThatWasHeardFirstSpeaksForARobot_FLT_1) {
  RobotSpeakers speakers;
  EXPECT_EQ(speakers.insteadOf("/navigator_2", "robot2", steadyAt(0.0)), "");
  speakers.heard("/navigator_2", "robot2", steadyAt(0.0));
  EXPECT_EQ(speakers.insteadOf("/navigator_2", "robot2", steadyAt(0.5)), "");
  EXPECT_EQ(speakers.insteadOf("/play", "robot2", steadyAt(0.5)), "/navigator_2");
  EXPECT_EQ(speakers.insteadOf("/play", "robot3", steadyAt(0.5)), "") << "a relay may speak for several robots";
}

TEST(RobotSpeakers, TheNodeInTheNamespaceOfTheRobotSpeaksForItWhoeverWasHeardFirst_FLT_1) {
  RobotSpeakers speakers;
  speakers.heard("/play", "robot2", steadyAt(0.0));
  EXPECT_EQ(speakers.insteadOf("/robot2/navigator", "robot2", steadyAt(0.5)), "");
  speakers.heard("/robot2/navigator", "robot2", steadyAt(0.5));
  EXPECT_EQ(speakers.insteadOf("/play", "robot2", steadyAt(1.0)), "/robot2/navigator");
  EXPECT_EQ(speakers.insteadOf("/robot22/navigator", "robot2", steadyAt(1.0)), "/robot2/navigator");
}

TEST(RobotSpeakers, ANodeThatIsSilentForTenSecondsSpeaksForNobodyAnyMore_FLT_1) {
  RobotSpeakers speakers;
  speakers.heard("/robot2/navigator", "robot2", steadyAt(0.0));
  EXPECT_EQ(speakers.insteadOf("/another", "robot2", steadyAt(9.9)), "/robot2/navigator");
  EXPECT_EQ(speakers.insteadOf("/another", "robot2", steadyAt(10.1)), "");
}

}  // namespace
}  // namespace frontier_pilot
