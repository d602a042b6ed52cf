#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;
using Event = exploration::GoalEvent::Kind;

using ExplorerStates = ExplorerTest;

// [EXP-1]
TEST_F(ExplorerStates, GoFromIdleOverAGoalAndItsEvaluationToDone_EXP_1) {
  show(kRoom);
  EXPECT_EQ(tick().status.state, State::kNavigating);
  ASSERT_EQ(sent.kind, exploration::GoalCommand::Kind::kSend);
  pose = sent.goal;
  change({30, 0, 4, 11}, kOccupied);
  goalEnds(Event::kReached);
  tickFor(5.0);
  std::vector<State> states;
  for (const exploration::ExplorerProgress& p : history) {
    if (states.empty() || states.back() != p.state) states.push_back(p.state);
    EXPECT_FALSE(p.reason_text.empty()) << "every transition has its reason [EXP-1]";
  }
  EXPECT_EQ(states, (std::vector<State>{State::kSelectGoal, State::kNavigating, State::kEvaluate, State::kSelectGoal,
                                        State::kDone}));
  EXPECT_EQ(history.back().reason, Reason::kNoReachableFrontier) << "[EXP-7]";
  EXPECT_EQ(history.back().goals_reached, 1U);
}

// [EXP-5]
TEST_F(ExplorerStates, AGoalThatFailsTwiceIsBlacklistedAndNotSooner_EXP_5) {
  show(kTwoEnds);
  tick();
  const Pose2 first = sent.goal;
  goalEnds(Event::kAborted, "no path");
  tickFor(0.5);
  EXPECT_TRUE(explorer.blacklist().empty()) << "max_goal_retries 1 [EXP-5]";
  EXPECT_EQ(sent.goal, first);
  goalEnds(Event::kAborted, "no path");
  const exploration::ExplorerOutput output = tickFor(0.5);
  ASSERT_EQ(explorer.blacklist().size(), 1U);
  EXPECT_EQ(explorer.blacklist()[0].reason, "no path");
  EXPECT_GT((sent.goal.position() - first.position()).norm(), 0.6) << "[EXP-3] 0.60 m off blacklisted goals";
  EXPECT_EQ(output.status.goals_failed, 2U);
  EXPECT_GE(output.status.frontiers_blacklisted, 1U);
}

// [EXP-5]
TEST_F(ExplorerStates, ATimedOutGoalIsCancelledAndBlacklistedAtOnce_EXP_5) {
  show(kTwoEnds);
  tick();
  const exploration::GoalCommand first = sent;
  const exploration::ExplorerOutput output = tickFor(120.5);
  EXPECT_TRUE(wentThrough(State::kEvaluate, Reason::kGoalTimedOut));
  ASSERT_EQ(explorer.blacklist().size(), 1U);
  EXPECT_EQ(explorer.blacklist()[0].position, first.goal.position());
  EXPECT_NE(sent.goal_id, first.goal_id);
  EXPECT_EQ(output.status.state, State::kNavigating);
}

// [EXP-5]
TEST_F(ExplorerStates, AGoalReplacedByTheExplorerItselfIsNeverBlacklisted_EXP_5) {
  show(kTwoEnds);
  tick();
  const exploration::GoalCommand first = sent;
  change({0, 0, 4, 11}, kOccupied);  // the near end is seen to be a wall
  tickFor(1.0);
  ASSERT_NE(sent.goal_id, first.goal_id);
  inputs.goal_events = {{first.goal_id, Event::kPreempted, "a new goal"}, {first.goal_id, Event::kAborted, "late"}};
  const exploration::ExplorerOutput output = tickFor(1.0);
  EXPECT_TRUE(explorer.blacklist().empty());
  EXPECT_EQ(output.status.goals_failed, 0U);
  EXPECT_EQ(output.status.state, State::kNavigating);
}

// [EXP-6]
TEST_F(ExplorerStates, AGoalWithNothingLeftToSeeIsDroppedForABetterOneWithoutAStop_EXP_6) {
  show(kTwoEnds);
  tick();
  const exploration::GoalCommand first = sent;
  ASSERT_LT(first.goal.x, pose.x);
  change({0, 0, 4, 11}, kOccupied);
  bool cancelled = false;
  for (int i = 0; i < 10; ++i) cancelled = tick().command.kind == exploration::GoalCommand::Kind::kCancel || cancelled;
  EXPECT_FALSE(cancelled) << "[EXP-6] the new goal replaces the old one";
  EXPECT_GT(sent.goal.x, pose.x);
  EXPECT_TRUE(wentThrough(State::kNavigating, Reason::kInformationGone));
}

// [EXP-6]
TEST_F(ExplorerStates, AGoalThatPromisesAndDisappointsByTurnsIsGivenUp_EXP_6) {
  show(kRoom);
  for (int i = 0; i < 60; ++i) {
    change({30, 1, 4, 9}, i % 2 == 0 ? kUnknown : kOccupied);
    tickFor(2.0);
  }
  EXPECT_GE(sent.goal_id, 3U);
  EXPECT_LE(sent.goal_id, 14U) << "of 30 times that there was something to see: the robot would swing for ever";
}

// [EXP-5] [EXP-7]
TEST_F(ExplorerStates, ASaturatedBlacklistIsReportedRetriedOnceAndThenTheReasonOfDone_EXP_5) {
  show(kRoom);
  exploration::ExplorerOutput output = tick();
  for (int i = 0; i < 40 && output.status.state != State::kDone; ++i) {
    if (output.status.state == State::kNavigating) goalEnds(Event::kAborted, "blocked");
    output = tickFor(1.0);
  }
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kAllBlacklisted);
  EXPECT_EQ(notesWith("blacklisted, trying once more"), 1U) << "[EXP-5]";
  EXPECT_EQ(output.status.goals_failed, 4U) << "twice, and twice more after the blacklist was cleared";
}

// [EXP-5]
TEST_F(ExplorerStates, ABlacklistEntryExpiresWhenTheMapAroundItChanges_EXP_5) {
  show(kTwoEnds);
  tick();
  const Pose2 first = sent.goal;
  for (int i = 0; i < 2; ++i) {
    goalEnds(Event::kAborted, "blocked");
    tickFor(0.5);
  }
  ASSERT_EQ(explorer.blacklist().size(), 1U);
  change({36, 1, 3, 2}, kOccupied);  // far away
  tickFor(3.0);
  EXPECT_EQ(explorer.blacklist().size(), 1U);
  change({1, 1, 2, 9}, kFree);
  goalEnds(Event::kReached);
  tickFor(3.0);
  EXPECT_TRUE(explorer.blacklist().empty()) << "[EXP-5]";
  EXPECT_LT((sent.goal.position() - first.position()).norm(), 0.6);
}

// [EXP-5]
TEST_F(ExplorerStates, AGoalTakenAwayByAnotherClientIsNotBlacklistedAndNotFoughtOver) {
  show(kRoom);
  tick();
  const exploration::GoalCommand first = sent;
  goalEnds(Event::kPreempted, "another goal");
  tickFor(2.0);
  EXPECT_EQ(sent.goal_id, first.goal_id);
  EXPECT_TRUE(explorer.blacklist().empty());
  EXPECT_EQ(tickFor(5.0).status.state, State::kNavigating);
}

// [EXP-7]
TEST_F(ExplorerStates, AnOpenedDoorWakesItAfterDone_EXP_7) {
  show(kClosedRoom);
  EXPECT_EQ(tickFor(6.0).status.state, State::kDone);
  change({30, 3, 4, 5}, kFree);
  change({33, 1, 1, 9}, kUnknown);
  const exploration::ExplorerOutput output = tickFor(4.0);
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kMapChanged));
  EXPECT_EQ(output.status.state, State::kNavigating);
}

// [EXP-7]
TEST_F(ExplorerStates, WhatWasReachedInVainIsNotTriedForEver_EXP_7) {
  show(kRoom);
  exploration::ExplorerOutput output = tick();
  for (int i = 0; i < 60 && output.status.state != State::kDone; ++i) {
    if (output.status.state == State::kNavigating) {
      pose = sent.goal;
      goalEnds(Event::kReached);
    }
    output = tickFor(2.0);
  }
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
}

/// What the view from the best goal is expected to show, and where that goal is.
exploration::Frontier frontierSeenBy(double scanner_range, double view_range) {
  exploration::ExplorerParameters parameters;
  parameters.robot.scanner.range_max = scanner_range;
  parameters.frontier.view.sensor_range = view_range;
  class Seen : public ExplorerTest {
   public:
    explicit Seen(const exploration::ExplorerParameters& p) : ExplorerTest(p) {
      show(kTwoEnds);
      tick();
    }
    void TestBody() override {}
    exploration::Frontier frontier() const { return explorer.frontiers().front(); }
  };
  return Seen(parameters).frontier();
}

// [EXP-4]
TEST(Explorer, ExpectsToSeeNoFartherThanTheScannerMeasures_EXP_4) {
  EXPECT_EQ(frontierSeenBy(1.0, 8.0).info.area, frontierSeenBy(8.0, 1.0).info.area);
  EXPECT_LT(frontierSeenBy(1.0, 8.0).info.area, frontierSeenBy(8.0, 8.0).info.area);
}

class ReturnToStart : public ExplorerTest {
 protected:
  static exploration::ExplorerParameters parameters() {
    exploration::ExplorerParameters p = shortSighted();
    p.return_to_start = true;
    return p;
  }
  ReturnToStart() : ExplorerTest(parameters()) {}
};

// [EXP-7]
TEST_F(ReturnToStart, DrivesBackBeforeItIsDone_EXP_7) {
  show(kRoom);
  const Pose2 start = pose;
  tick();
  pose = sent.goal;
  change({30, 0, 4, 11}, kOccupied);
  goalEnds(Event::kReached);
  exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_EQ(output.status.reason, Reason::kReturningToStart);
  EXPECT_EQ(sent.goal, start);
  goalEnds(Event::kReached);
  output = tickFor(0.5);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
  EXPECT_FALSE(explorer.goal()) << "the start is no goal any more";
}

// [EXP-10]
TEST_F(ReturnToStart, TheStartIsWhereTheExplorationBeginsAndNotWhereTheRobotWasBefore_EXP_10) {
  show(kClosedRoom);
  inputs.enabled = false;
  tick();  // as before it has been localised
  pose = Pose2(1.1, pose.y, 0.0);
  inputs.enabled = true;
  EXPECT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  EXPECT_EQ(sent.goal, pose);
}

// [EXP-10] [FLT-2]
TEST_F(ReturnToStart, TheStartIsThatOfTheExplorerBeforeItIfThatDied_EXP_10_FLT_2) {
  show(kClosedRoom);
  EXPECT_FALSE(explorer.start());
  const Pose2 before(0.5, pose.y, 1.0);
  explorer.setStart(before);
  EXPECT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  EXPECT_EQ(sent.goal, before);
  EXPECT_EQ(explorer.start(), before);
}

// [EXP-7]
TEST_F(ExplorerStates, IsDoneAlsoWhereItsStartHasTurnedOutToBeAWall_EXP_7) {
  show(kClosedRoom);
  tick();
  const Cell start = world.map.geometry().cellAt(pose.position());
  pose = Pose2(1.1, pose.y, 0.0);
  change(CellRect{start.x, start.y, 1, 1}.grown(3), kOccupied);
  const exploration::ExplorerOutput output = tickFor(10.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
}

TEST_F(ExplorerStates, ARobotOnUnknownGroundWaitsAndIsNotDone_EXP_7) {
  show("..............................??????????????????????????????");
  pose = Pose2(2.9, 0.02, 0.0);
  const exploration::ExplorerOutput output = tickFor(20.0);
  EXPECT_EQ(output.status.state, State::kSelectGoal);
  EXPECT_EQ(output.status.reason, Reason::kRobotOffKnownGround);
}

// [EXP-9]
TEST_F(ExplorerStates, SaysInWordsWhyThisGoalAndWhatComesNext_EXP_9) {
  EXPECT_EQ(explorer.explain(), "IDLE: waiting for inputs.");
  show(kTwoEnds);
  tick();
  const std::string words = explorer.explain();
  EXPECT_NE(words.find("The goal is ("), std::string::npos) << words;
  EXPECT_NE(words.find("first of 2 stops"), std::string::npos) << words;
  EXPECT_NE(words.find("Then: ("), std::string::npos) << words;
  ASSERT_EQ(explorer.tour().size(), 2U);
  EXPECT_EQ(explorer.tour().front(), explorer.goal()->position());
}

}  // namespace
}  // namespace frontier_pilot
