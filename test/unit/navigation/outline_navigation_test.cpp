// A robot that is no disc on its way: it gets through where its outline fits, and touches nothing.

#include <gtest/gtest.h>

#include "support/floors/driven_robot.h"
#include "support/floors/zigzag.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

navigation::NavigatorParams forWaffle() {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot("waffle");
  return params;
}

// [ROB-1] [NAV-2]
TEST(OutlineNavigation, DrivesThroughTurnsInCorridorsThatOnlyTheOutlineFits) {
  // The circle around a Waffle is 0.51 m wide, and wants 0.045 m of room on either side on this map.
  for (const int width : {10, 11, 12}) {
    const double middle = 0.5 + 0.025 * width;
    test::DrivenRobot robot(test::zigzag(width), {0.8, middle, 0.0}, forWaffle());
    robot.send({5.4, 3.0 - 0.025 * width});
    const auto finished = robot.runUntilFinished(120.0);
    ASSERT_TRUE(finished) << width;
    EXPECT_EQ(finished->result, navigation::NavResult::kSucceeded) << width << ": " << toString(finished->reason);
    EXPECT_EQ(robot.contacts(), 0) << width;
  }
}

// [ROB-1] [NAV-1] [NAV-2]
TEST(OutlineNavigation, TurnsIntoTheGoalsDirectionOnlyWhereTheOutlineFits) {
  test::DrivenRobot roomy(test::zigzag(20), {0.8, 1.0, 0.0}, forWaffle());
  roomy.sendPose({2.0, 1.0, 0.5 * kPi}, true);
  const auto turned = roomy.runUntilFinished(60.0);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->result, navigation::NavResult::kSucceeded);
  EXPECT_EQ(roomy.contacts(), 0);

  test::DrivenRobot narrow(test::zigzag(8), {0.8, 0.7, 0.0}, forWaffle());
  narrow.sendPose({2.0, 0.7, 0.5 * kPi}, true);
  const auto blocked = narrow.runUntilFinished(120.0);
  ASSERT_TRUE(blocked);
  EXPECT_EQ(blocked->result, navigation::NavResult::kAborted);
  EXPECT_EQ(narrow.contacts(), 0);
}

// [ROB-1] [NAV-3] A goal behind a robot that cannot turn where it stands.
TEST(OutlineNavigation, TouchesNothingWhereItCannotTurn) {
  test::DrivenRobot robot(test::zigzag(8), {2.0, 0.7, 0.0}, forWaffle());
  robot.send({0.8, 0.7});
  EXPECT_TRUE(robot.runUntilFinished(120.0));
  EXPECT_EQ(robot.contacts(), 0);
}

}  // namespace
}  // namespace frontier_pilot
