#include <gtest/gtest.h>

#include "support/closed_loop/driven_fleet.h"

namespace frontier_pilot::test {
namespace {

constexpr double kNarrow = 0.6;  // [m]: two Burgers cannot pass each other

navigation::NavigatorParams fast() {
  navigation::NavigatorParams params;
  params.robot.limits.max_linear = 0.5;
  params.robot.limits.max_angular = 1.5;
  return params;
}

// [MUL-3]
TEST(Traffic, RobotsThatMeetInANarrowCorridorPassWithoutContact_MUL_3) {
  for (const int seed : {1, 2, 4, 8}) {
    const Meeting meeting = drawMeeting(seed, kNarrow);
    DrivenFleet fleet(meeting.map, meeting.starts, fast());
    for (std::size_t i = 0; i < 2; ++i) fleet.send(i, meeting.goals[i]);
    EXPECT_TRUE(fleet.run(180.0)) << "seed " << seed;
    EXPECT_EQ(fleet.contacts(), 0) << "seed " << seed;
    EXPECT_LT(fleet.longestStanding(), 30.0) << "seed " << seed;
  }
}

// [MUL-3]
TEST(Traffic, ARobotThatDiesInTheCorridorIsAnObstacleThatShutsItOff_MUL_3) {
  const Meeting meeting = drawMeeting(1, kNarrow);
  DrivenFleet fleet(meeting.map, {{2.0, 2.1, 0.0}, {9.0, 2.1, kPi}}, fast());
  fleet.setPowered(1, false);
  fleet.send(0, meeting.goals[0]);
  EXPECT_FALSE(fleet.run(60.0));
  EXPECT_GT(fleet.given_up(), 0) << "its navigator says that there is no path";
  EXPECT_TRUE(fleet.output(0).traffic.empty()) << "nobody waits for a robot that is not heard";
  EXPECT_EQ(fleet.contacts(), 0);
}

}  // namespace
}  // namespace frontier_pilot::test
