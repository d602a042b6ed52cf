#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

using ExplorerClock = test::ExplorerTest;

TEST_F(ExplorerClock, ABackwardJumpCancelsTheGoalAndStartsOver) {
  show(kRoom);
  tick();
  now -= std::chrono::seconds(50);
  const exploration::ExplorerOutput output = tick();
  EXPECT_TRUE(wentThrough(State::kIdle, Reason::kClockJumpedBack));
  EXPECT_STREQ(toString(Reason::kClockJumpedBack), "the clock jumped");
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kSend);
}

// [EXP-5]
TEST_F(ExplorerClock, AForwardJumpIsNoTimeThatAGoalTook_EXP_5) {
  show(kRoom);
  tick();
  const std::uint32_t goal = sent.goal_id;
  now += std::chrono::hours(1);
  const exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_EQ(sent.goal_id, goal);
  EXPECT_TRUE(explorer.blacklist().empty());
}

class SlowDecisions : public test::ExplorerTest {
 protected:
  static exploration::ExplorerParameters aMinute() {
    exploration::ExplorerParameters parameters = shortSighted();
    parameters.until.time = 60.0;
    return parameters;
  }

  SlowDecisions() : test::ExplorerTest(aMinute()) {}
};

// [EXP-10]
TEST_F(SlowDecisions, CountForTheTimeOfTheExploration_EXP_10) {
  show(kRoom);
  int ticks = 0;
  while (tick().status.state != State::kDone && ++ticks < 100) now += std::chrono::seconds(2);
  EXPECT_LT(ticks, 35);
  EXPECT_GT(ticks, 25);
}

}  // namespace
}  // namespace frontier_pilot
