#include <gtest/gtest.h>

#include "frontier_pilot/navigation/navigator.h"
#include "support/floors/driven_robot.h"
#include "support/floors/room.h"

namespace frontier_pilot {
namespace {

using test::DrivenRobot;
using test::room;

// [NAV-1]
TEST(ReplacedMap, EndsTheGoalThatWasMeantForTheMapOfBefore_NAV_1) {
  DrivenRobot robot(room(), {1.0, 1.5, 0.0});
  robot.send({5.0, 1.0});
  robot.run(5.0);
  robot.replaceMap();
  const navigation::NavigatorOutput& output = robot.tick();
  EXPECT_EQ(output.command, Twist2{});
  ASSERT_EQ(output.finished.size(), 1U);
  EXPECT_EQ(output.finished[0].result, navigation::NavResult::kAborted);
  EXPECT_STREQ(toString(output.finished[0].reason), "the map was replaced");
  robot.run(0.5);
  EXPECT_EQ(robot.speed(), 0.0);
}

}  // namespace
}  // namespace frontier_pilot
