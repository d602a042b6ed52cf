#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "explorer_fixture.h"
#include "narrow_door.h"

namespace frontier_pilot {
namespace {

using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;
using Event = exploration::GoalEvent::Kind;

class FallBacks : public test::ExplorerTest {
 protected:
  /// A room whose left end is unknown, with the robot, and a closed one beside it.
  static constexpr const char* kCutOff = R"(
    ????############################################
    ????.......................#...................#
    ????.......................#...................#
    ????.......................#...................#
    ????.......................#...................#
    ????................r......#...................#
    ????.......................#...................#
    ????.......................#...................#
    ????.......................#...................#
    ????.......................#...................#
    ????############################################
  )";
  /// The robot begins at the start of `kCutOff`, is paused, and goes on in the closed room.
  exploration::ExplorerOutput goOnBehindTheWall() {
    tick();
    inputs.enabled = false;
    tick();
    inputs.enabled = true;
    pose = Pose2(1.85, pose.y, 0.0);
    return tick();
  }
  /// Where in the history the first transition with this reason is; its end if there is none.
  std::ptrdiff_t firstWith(Reason reason) const {
    return std::find_if(history.begin(), history.end(),
                        [&](const exploration::ExplorerProgress& p) { return p.reason == reason; }) -
           history.begin();
  }
  static bool ends(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  }
};

TEST_F(FallBacks, AGapThatOnlyJustFitsIsTakenWhenNothingElseIsLeftAndTheTextSaysSo) {
  show(test::kNarrowDoor);
  const exploration::ExplorerOutput output = tick();
  ASSERT_EQ(output.status.state, State::kNavigating);
  EXPECT_GT(sent.goal.x, 0.8);
  EXPECT_TRUE(ends(output.status.reason_text, ", by tight ways")) << output.status.reason_text;
}

TEST_F(FallBacks, AnOrdinaryGoalNeedsNone) {
  show(kRoom);
  const std::string text = tick().status.reason_text;
  EXPECT_EQ(text.find(", by "), std::string::npos) << text;
}

TEST_F(FallBacks, ARobotThatIsCutOffIsSentToWhatItsStartCanReach) {
  show(kCutOff);
  const exploration::ExplorerOutput output = goOnBehindTheWall();
  ASSERT_EQ(output.status.state, State::kNavigating);
  EXPECT_LT(sent.goal.x, 1.3);
  EXPECT_TRUE(ends(output.status.reason_text, ", by ways from the start")) << output.status.reason_text;
}

// [EXP-10]
TEST_F(FallBacks, ARobotThatWallsCutOffIsSentThereAlsoIfThereAreBoundsElsewhere_EXP_10) {
  show(kCutOff);
  exploration::ExplorationBounds bounds;
  bounds.keep_out = {{{2.1, 0.3}, {2.3, 0.3}, {2.3, 0.4}, {2.1, 0.4}}};
  explorer.setBounds(bounds, world.map);
  const exploration::ExplorerOutput output = goOnBehindTheWall();
  ASSERT_EQ(output.status.state, State::kNavigating);
  EXPECT_TRUE(ends(output.status.reason_text, ", by ways from the start")) << output.status.reason_text;
}

/// A closed room, and one beside it with the robot, whose right end is unknown.
constexpr const char* kBehindTheStart = R"(
  ########################################################
  #..........#...................................????????#
  #..........#...................................????????#
  #..........#...................................????????#
  #..........#...................................????????#
  #....r.....#...................................????????#
  #..........#...................................????????#
  #..........#...................................????????#
  #..........#...................................????????#
  #..........#...................................????????#
  ########################################################
)";

// [EXP-1] [EXP-5]
TEST_F(FallBacks, WhatIsBlacklistedIsTriedOnceMoreAlsoByARobotThatIsCutOffFromItsStart_EXP_1_EXP_5) {
  show(kBehindTheStart);
  explorer.setStart(pose);
  pose.x = 1.0;
  exploration::ExplorerOutput output = tick();
  ASSERT_EQ(output.status.state, State::kNavigating);
  for (int i = 0; i < 40 && output.status.state != State::kDone; ++i) {
    if (output.status.state == State::kNavigating) goalEnds(Event::kAborted, "blocked");
    output = tickFor(1.0);
  }
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kBlacklistSaturated));
}

// [EXP-1] [EXP-5]
TEST_F(FallBacks, CoverageComesBeforeAnotherTryOfWhatIsBlacklisted_EXP_1_EXP_5) {
  show(kRoom);
  exploration::ExplorerOutput output = tick();
  for (int i = 0; i < 40 && output.status.state != State::kDone; ++i) {
    if (output.status.state == State::kNavigating) goalEnds(Event::kAborted, "blocked");
    output = tickFor(1.0);
  }
  ASSERT_EQ(output.status.state, State::kDone);
  ASSERT_EQ(output.status.reason, Reason::kAllBlacklisted);
  EXPECT_LT(firstWith(Reason::kRichFrontiersExhausted), firstWith(Reason::kBlacklistSaturated));
  EXPECT_LT(firstWith(Reason::kBlacklistSaturated), firstWith(Reason::kAllBlacklisted));
}

}  // namespace
}  // namespace frontier_pilot
