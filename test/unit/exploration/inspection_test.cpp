#include "exploration/inspection/inspection_list.h"

#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using Event = exploration::GoalEvent::Kind;
using Reason = exploration::ExplorerReason;
using State = exploration::ExplorerState;

class Inspection : public test::ExplorerTest {
 protected:
  static exploration::ExplorerParameters parameters() {
    exploration::ExplorerParameters p = shortSighted();
    p.inspect.detour = 0.1;
    return p;
  }
  Inspection() : ExplorerTest(parameters()) {}

  /// The pose `dx`, `dy` [m] from the robot.
  Pose2 beside(double dx, double dy = 0.0) const { return {pose.x + dx, pose.y + dy, 1.0}; }
  bool inspects(const Pose2& wanted) const {
    return (sent.goal.position() - wanted.position()).norm() < 0.04 && sent.goal.yaw == wanted.yaw;
  }
};

// [EXP-10]
TEST_F(Inspection, APoseOnTheWayToTheNextGoalIsTakenFirst_EXP_10) {
  show(kTwoEnds);
  const Pose2 wanted = beside(-0.2);
  EXPECT_EQ(explorer.inspect(wanted), "");
  EXPECT_EQ(tick().status.reason, Reason::kInspecting);
  EXPECT_TRUE(inspects(wanted));
}

// [EXP-10]
TEST_F(Inspection, TheRobotStandsThereForTheTimeAskedForAndGoesOn_EXP_10) {
  show(kTwoEnds);
  const Pose2 wanted = beside(-0.2);
  explorer.inspect(wanted);
  tick();
  pose = sent.goal;
  goalEnds(Event::kReached);
  exploration::ExplorerOutput output = tickFor(2.9);
  EXPECT_EQ(output.status.state, State::kEvaluate);
  EXPECT_EQ(output.status.reason, Reason::kInspecting);
  EXPECT_EQ(output.status.inspected, 0U);
  output = tickFor(0.4);
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_EQ(output.status.inspected, 1U);
  EXPECT_FALSE(inspects(wanted)) << "the frontier is next";
  EXPECT_TRUE(explorer.inspections().empty());
}

// [EXP-10]
TEST_F(Inspection, APoseFarFromTheWayWaitsUntilNothingElseIsLeft_EXP_10) {
  show(kRoom);
  pose.x += 0.5;
  const Pose2 wanted = beside(-0.3);
  explorer.inspect(wanted);
  EXPECT_EQ(tick().status.reason, Reason::kGoalSent) << "a detour of 0.6 m";
  pose = sent.goal;
  change({30, 0, 4, 11}, kOccupied);
  goalEnds(Event::kReached);
  exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.reason, Reason::kInspecting);
  EXPECT_TRUE(inspects(wanted));
  goalEnds(Event::kReached);
  tickFor(3.5);
  output = tickFor(5.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
  EXPECT_EQ(output.status.inspected, 1U);
}

// [EXP-10]
TEST_F(Inspection, APoseThatCannotBeReachedIsGivenUpAtTheEndWithAWord_EXP_10) {
  show(kClosedRoom);
  explorer.inspect(beside(100.0));
  const exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.inspections_failed, 1U);
  EXPECT_EQ(notesWith("no way leads to"), 1U);
  EXPECT_TRUE(explorer.inspections().empty());
}

// [EXP-10]
TEST_F(Inspection, APoseToWhichTheNavigationFailsTwiceIsGivenUpAndNothingIsBlacklisted_EXP_10) {
  show(kTwoEnds);
  explorer.inspect(beside(-0.2));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(tickFor(0.5).status.reason, Reason::kInspecting);
    goalEnds(Event::kAborted, "blocked");
  }
  const exploration::ExplorerOutput output = tickFor(0.5);
  EXPECT_EQ(output.status.reason, Reason::kGoalSent);
  EXPECT_EQ(output.status.inspections_failed, 1U);
  EXPECT_TRUE(explorer.blacklist().empty());
}

// [EXP-10]
TEST_F(Inspection, WhatIsTakenBackIsNotDrivenToAnyMore_EXP_10) {
  show(kTwoEnds);
  explorer.inspect(beside(-0.2));
  tick();
  const Pose2 wanted = sent.goal;
  explorer.clearInspections();
  const exploration::ExplorerOutput output = tick();
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kInspectionsCleared));
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_FALSE(inspects(wanted));
}

// [MAP-5] [NAV-1]
TEST_F(Inspection, WhatWasChosenOnAMapThatIsReplacedIsNotDrivenToNorAnythingElseOnIt_MAP_5_NAV_1) {
  show(kTwoEnds);
  explorer.inspect(beside(-0.2));
  const std::size_t sent_before = tick().status.goals_sent;
  explorer.leaveMap();
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.reason, Reason::kNavigationUnable);
  EXPECT_TRUE(explorer.inspections().empty());
  EXPECT_EQ(tickFor(4.0).status.goals_sent, sent_before) << "the new map has not come yet";
  EXPECT_EQ(tickFor(3.0).status.reason, Reason::kGoalSent);
}

// [EXP-10]
TEST_F(Inspection, AnExplorationThatIsDoneGoesOnForAPose_EXP_10) {
  show(kClosedRoom);
  ASSERT_EQ(tickFor(5.0).status.state, State::kDone);
  const Pose2 wanted = beside(0.3);
  explorer.inspect(wanted);
  EXPECT_EQ(tickFor(5.0).status.state, State::kNavigating);
  EXPECT_TRUE(inspects(wanted));
}

// [EXP-10]
TEST_F(Inspection, APauseKeepsThePose_EXP_10) {
  show(kTwoEnds);
  const Pose2 wanted = beside(-0.2);
  explorer.inspect(wanted);
  tick();
  goalEnds(Event::kReached);
  tick();
  inputs.enabled = false;
  tick();
  inputs.enabled = true;
  EXPECT_EQ(tickFor(0.5).status.reason, Reason::kInspecting);
  EXPECT_EQ(explorer.inspections().size(), 1U);
}

// [EXP-10] [FLT-1]
TEST(InspectionList, RefusesWhatIsNotFiniteWhatWaitsAlreadyAndMoreThanItHolds_FLT_1) {
  exploration::InspectionList list;
  EXPECT_NE(list.add({NAN, 0.0, 0.0}), "");
  for (std::size_t i = 0; i < exploration::InspectionList::kMost; ++i) {
    EXPECT_EQ(list.add({static_cast<double>(i), 0.0, 0.0}), "");
    EXPECT_NE(list.add({static_cast<double>(i), 0.0, 0.0}), "");
  }
  EXPECT_NE(list.add({-1.0, 0.0, 0.0}), "");
  EXPECT_EQ(list.waiting().size(), exploration::InspectionList::kMost);
}

}  // namespace
}  // namespace frontier_pilot
