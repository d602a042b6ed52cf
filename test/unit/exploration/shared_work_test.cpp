#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

/// An explorer that hears of one other robot.
class SharedWorkTest : public test::ExplorerTest {
 protected:
  /// The middle of the left or right edge of the floor in kTwoEnds [m].
  Vec2 leftEnd() const { return world.map.geometry().centre({4, 5}); }
  Vec2 rightEnd() const { return world.map.geometry().centre({43 - 4, 5}); }

  void otherClaims(const std::vector<exploration::Claim>& claims, bool precedes = false) {
    exploration::Teammate other;
    other.name = "other";
    other.precedes = precedes;
    other.claims = claims;
    inputs.others = {other};
  }
  bool drivesLeft() const { return sent.goal.x < pose.x; }
  double ownCostOf(const Vec2& place) const {
    for (const exploration::Claim& claim : explorer.claims()) {
      if ((claim.place - place).norm() < 0.5) return claim.cost;
    }
    return -1.0;
  }
};

// [MUL-2]
TEST_F(SharedWorkTest, ARobotClaimsWhatItIsGoingToLookAtWithTheTimeUntilThen_MUL_2) {
  show(kTwoEnds);
  tick();
  ASSERT_EQ(explorer.claims().size(), 2U);
  EXPECT_TRUE(drivesLeft());
  const double left = ownCostOf(leftEnd()), right = ownCostOf(rightEnd());
  EXPECT_GT(left, 0.0);
  EXPECT_GT(right, left);
  tickFor(0.5);
  EXPECT_LT(ownCostOf(leftEnd()), left) << "the time that is left";
}

// [MUL-2]
TEST_F(SharedWorkTest, AFrontierThatAnotherRobotSeesSoonerIsLeftToIt_MUL_2) {
  show(kTwoEnds);
  otherClaims({{leftEnd(), 0.5}});
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_FALSE(drivesLeft());
  EXPECT_LT(ownCostOf(leftEnd()), 0.0);
}

// [MUL-2]
TEST_F(SharedWorkTest, AFrontierIsTakenOverFromAnotherRobotOnlyIfThisOneIsClearlyNearer_MUL_2) {
  show(kTwoEnds);
  tick();
  const double own = ownCostOf(leftEnd());
  exploration::Explorer newcomer(shortSighted());
  explorer = std::move(newcomer);
  show(kTwoEnds);
  otherClaims({{leftEnd(), own + 1.0}});
  tick();
  EXPECT_FALSE(drivesLeft()) << "a second sooner is not clearly sooner";
  EXPECT_LT(ownCostOf(leftEnd()), 0.0);
  otherClaims({{leftEnd(), own + 60.0}});
  tickFor(3.0);
  EXPECT_GT(ownCostOf(leftEnd()), 0.0);
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotKeepsWhatItHasClaimedUntilAnotherOneIsSooner_MUL_2) {
  show(kTwoEnds);
  tick();
  const double own = ownCostOf(leftEnd());
  otherClaims({{leftEnd(), own + 1.0}});
  tickFor(3.0);
  EXPECT_TRUE(drivesLeft());
  otherClaims({{leftEnd(), 0.1}});
  tickFor(3.0);
  EXPECT_FALSE(drivesLeft()) << "it leaves its goal";
}

// [MUL-2]
TEST_F(SharedWorkTest, OfEqualClaimsThatOfTheRobotWhoseNamePrecedesCounts_MUL_2) {
  for (const bool precedes : {false, true}) {
    explorer = exploration::Explorer(shortSighted());
    inputs.others.clear();
    show(kTwoEnds);
    tick();
    otherClaims({{leftEnd(), 0.0}}, precedes);
    inputs.others[0].claims[0].cost = ownCostOf(leftEnd());
    now += fromSeconds(1.5);
    pose = Pose2(world.point('r'), 0.0);
    tick();
    EXPECT_EQ(drivesLeft(), !precedes);
  }
}

// [MUL-2]
TEST_F(SharedWorkTest, WhatIsSeenFromTheOtherSideOfTheSameUnknownAreaCountsAsTheSame_MUL_2) {
  show(R"(
    ################????################
    #...............????...............#
    #...............????...............#
    #...............????...............#
    #...............????...............#
    #....r..........????...............#
    #...............????...............#
    #...............????...............#
    #...............????...............#
    ################????################
  )");
  const Vec2 other_side = world.map.geometry().centre({20, 5});
  otherClaims({{other_side, 0.5}});
  EXPECT_EQ(tick().status.reason, Reason::kLeftToOthers);
}

// [MUL-2]
TEST_F(SharedWorkTest, AClaimBehindAWallIsAnotherMatter_MUL_2) {
  show(R"(
    ##################################################
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #....r........????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    #.............????????????#????????..............#
    ##################################################
  )");
  otherClaims({{world.map.geometry().centre({35, 6}), 0.5}});
  EXPECT_NE(tick().status.reason, Reason::kLeftToOthers);
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotStandsAsideWhileAllThatIsLeftIsAnothersAndTakesItUpWhenThatOneFallsSilent_MUL_2) {
  show(kTwoEnds);
  otherClaims({{leftEnd(), 0.5}, {rightEnd(), 0.5}});
  const exploration::ExplorerOutput aside = tickFor(10.0);
  EXPECT_EQ(aside.status.state, State::kSelectGoal);
  EXPECT_EQ(aside.status.reason, Reason::kLeftToOthers);
  EXPECT_EQ(aside.status.reason_text, "what is left is another robot's");
  EXPECT_EQ(aside.command.kind, exploration::GoalCommand::Kind::kNone);
  EXPECT_TRUE(explorer.claims().empty());
  inputs.others.clear();
  EXPECT_EQ(tickFor(1.0).status.state, State::kNavigating);
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotStopsAndStandsAsideWhenAnotherOneIsSoonerAtAllThatIsLeft_MUL_2) {
  show(kRoom);
  tick();
  ASSERT_EQ(sent.kind, exploration::GoalCommand::Kind::kSend);
  otherClaims({{world.map.geometry().centre({30, 5}), 0.0}});
  const exploration::ExplorerOutput output = tickFor(3.0);
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.reason, Reason::kLeftToOthers);
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotIsDoneOnlyWhenNothingIsLeftForTheOthersEither_MUL_2) {
  show(kClosedRoom);
  otherClaims({{Vec2(20.0, 20.0), 5.0}});
  EXPECT_EQ(tickFor(10.0).status.reason, Reason::kLeftToOthers);
  otherClaims({});
  const exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotThatStoodAsideIsDoneAlsoWhileItsMapChanges_MUL_2) {
  show(kClosedRoom);
  otherClaims({{Vec2(20.0, 20.0), 5.0}});
  EXPECT_EQ(tickFor(10.0).status.reason, Reason::kLeftToOthers);
  otherClaims({});
  const Cell here = world.map.geometry().cellAt(pose.position());
  for (int i = 0; i < 100; ++i) {
    change({here.x + 3, here.y, 1, 1}, i % 2 == 0 ? 100 : 0);  // by noise
    tick();
  }
  EXPECT_TRUE(wentThrough(State::kDone, Reason::kNoReachableFrontier));
}

// [MUL-2]
TEST_F(SharedWorkTest, ARobotThatHasEndedClaimsNothing_MUL_2) {
  show(kTwoEnds);
  tick();
  inputs.enabled = false;
  tick();
  EXPECT_TRUE(explorer.claims().empty());
}

// [MUL-2] [EXP-8] [EXP-10]
TEST_F(SharedWorkTest, ARobotThatCannotDriveClaimsNothingAndItsTimeDoesNotCountUntilItHasDriven_MUL_2_EXP_8) {
  show(kTwoEnds);
  const double before = tickFor(1.0).status.exploring_time;
  ASSERT_EQ(explorer.claims().size(), 2U);
  for (int attempt = 0; attempt < 2; ++attempt) {
    goalEnds(exploration::GoalEvent::Kind::kUnable, "no scan");
    const exploration::ExplorerOutput output = tickFor(20.0);  // it waits for a while, and tries again
    ASSERT_EQ(output.status.state, State::kNavigating);
    EXPECT_TRUE(explorer.claims().empty());
    EXPECT_NEAR(output.status.exploring_time, before, 0.2);
  }
  pose.x -= 0.2;
  EXPECT_GT(tickFor(1.0).status.exploring_time, before + 0.8);
  EXPECT_EQ(explorer.claims().size(), 2U);
}

}  // namespace
}  // namespace frontier_pilot
