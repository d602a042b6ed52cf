#include <algorithm>
#include <regex>

#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;
using ExplorerInputsTest = ExplorerTest;

// [EXP-8]
TEST_F(ExplorerInputsTest, SaysEveryFiveSecondsWhichInputIsMissing_EXP_8) {
  pose_comes = odometry_comes = inputs.navigation_available = false;
  const exploration::ExplorerOutput output = tickFor(11.0);
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, Reason::kWaitingForInputs);
  EXPECT_EQ(notesWith("map, odometry, TF from map to base, move_base"), 3U) << "[EXP-8] at 0, 5 and 10 s";
}

// [EXP-8]
TEST_F(ExplorerInputsTest, NamesOnlyWhatIsMissingAndStartsWhenAllIsThere_EXP_8) {
  show(kRoom);
  inputs.navigation_available = false;
  EXPECT_EQ(tick().status.reason_text, "missing: move_base");
  inputs.navigation_available = true;
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kInputsComplete));
}

struct Loss {
  const char* name;
  Reason reason;
};

class ExplorerLosses : public ExplorerTest, public ::testing::WithParamInterface<Loss> {
 protected:
  void set(bool there) {
    switch (GetParam().reason) {
      case Reason::kMapGone:
        inputs.map_available = there;
        break;
      case Reason::kOdometryGone:
        odometry_comes = there;
        break;
      case Reason::kPoseGone:
        pose_comes = there;
        break;
      case Reason::kNotLocalized:
        inputs.localized = there;
        break;
      case Reason::kNavigationDisabled:
        inputs.navigation_refused = there ? "" : "its source nav is disabled";
        break;
      default:
        inputs.navigation_available = there;
        break;
    }
  }
};

// [EXP-8]
TEST_P(ExplorerLosses, StopsSaysSoAndResumes_EXP_8) {
  show(kRoom);
  tick();
  const exploration::GoalCommand first = sent;
  set(false);
  bool cancelled = false;
  exploration::ExplorerOutput output;
  for (int i = 0; i < 30; ++i) {
    output = tick();
    cancelled = cancelled || (output.command.kind == exploration::GoalCommand::Kind::kCancel &&
                              output.command.goal_id == first.goal_id);
  }
  EXPECT_TRUE(cancelled) << "[EXP-8]";
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, GetParam().reason);
  EXPECT_EQ(notesWith("exploration waits for"), 1U);
  set(true);
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_NE(sent.goal_id, first.goal_id);
  EXPECT_TRUE(explorer.blacklist().empty());
}

INSTANTIATE_TEST_SUITE_P(EachInput, ExplorerLosses,
                         ::testing::Values(Loss{"Map", Reason::kMapGone}, Loss{"Odometry", Reason::kOdometryGone},
                                           Loss{"Pose", Reason::kPoseGone}, Loss{"Place", Reason::kNotLocalized},
                                           Loss{"Navigation", Reason::kNavigationGone},
                                           Loss{"LeaveOfTheArbiter", Reason::kNavigationDisabled}),
                         [](const auto& loss) { return loss.param.name; });

// [EXP-8]
TEST_F(ExplorerInputsTest, OdometryWhoseAgeVariesAboutTheGreatestIsWaitedForUntilItIsFresh_EXP_8) {
  show(kRoom);
  tick();
  odometry_age = std::chrono::milliseconds(1600);
  EXPECT_EQ(tick().status.reason, Reason::kOdometryGone);
  odometry_age = std::chrono::milliseconds(1400);
  EXPECT_EQ(tickFor(2.0).status.reason, Reason::kOdometryGone) << "no goal is sent and taken back again and again";
  odometry_age = std::chrono::milliseconds(700);
  EXPECT_EQ(tick().status.state, State::kNavigating);
}

// [EXP-5] [EXP-8]
TEST_F(ExplorerInputsTest, ANavigationThatCanDriveNowhereIsWaitedForAndNoFaultOfThePlaces_EXP_8) {
  show(kTwoEnds);
  exploration::ExplorerOutput output;
  for (const Time end = now + std::chrono::seconds(300); now < end;) {
    output = tick();
    ASSERT_NE(output.status.state, State::kDone);
    if (output.status.state == State::kNavigating) goalEnds(exploration::GoalEvent::Kind::kUnable, "no scan");
  }
  EXPECT_TRUE(explorer.blacklist().empty());
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, Reason::kNavigationUnable);
  EXPECT_NE(output.status.reason_text.find("no scan"), std::string::npos) << output.status.reason_text;
  EXPECT_FALSE(explorer.goal());
  EXPECT_EQ(output.status.goals_failed, 0U);
  EXPECT_GE(output.status.goals_sent, 50U) << "it is tried every five seconds";
  EXPECT_LE(output.status.goals_sent, 60U) << "and not more often";
  EXPECT_EQ(tickFor(6.0).status.state, State::kNavigating) << "it goes on once goals do not end so";
}

// [EXP-7]
TEST_F(ExplorerInputsTest, APauseCancelsTheGoalAndIsItsOwnReason_EXP_7) {
  show(kRoom);
  tick();
  inputs.enabled = false;
  exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, Reason::kPaused);
  EXPECT_EQ(tickFor(10.0).status.reason, Reason::kPaused);
  EXPECT_EQ(notes.size(), 0U) << "a pause is not a complaint";
  inputs.enabled = true;
  EXPECT_EQ(tick().status.state, State::kNavigating);
}

// [ARB-8] A stop is no fault of the places that the robot does not reach, and no time of the exploration.
TEST_F(ExplorerInputsTest, WhileTheEmergencyStopIsLatchedNoGoalIsSentAndNoTimeCounts_ARB_8) {
  show(kRoom);
  tick();
  const double before = tick().status.exploring_time;
  inputs.stopped = true;
  exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  const exploration::GoalCommand last = sent;
  inputs.goal_events = {{sent.goal_id, exploration::GoalEvent::Kind::kAborted, "blocked"}};
  output = tickFor(100.0);
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, Reason::kEmergencyStop);
  EXPECT_EQ(sent.goal_id, last.goal_id);
  EXPECT_EQ(output.status.goals_failed, 0U);
  EXPECT_NEAR(output.status.exploring_time, before, 0.2);
  EXPECT_EQ(notes.size(), 0U) << "a stop is not a complaint";
  inputs.stopped = false;
  EXPECT_EQ(tick().status.state, State::kNavigating);
}

TEST_F(ExplorerInputsTest, WhatIsDoneStaysDoneWhileTheEmergencyStopIsLatched_ARB_8) {
  show(kClosedRoom);
  ASSERT_EQ(tickFor(60.0).status.state, State::kDone);
  inputs.stopped = true;
  show(kRoom);
  EXPECT_EQ(tickFor(5.0).status.state, State::kDone);
}

class ExplorationThatReturns : public ExplorerTest {
 protected:
  static exploration::ExplorerParameters parameters(double until_time) {
    exploration::ExplorerParameters p = shortSighted();
    p.return_to_start = true;
    if (until_time > 0.0) p.until.time = until_time;
    return p;
  }
  explicit ExplorationThatReturns(double until_time = 0.0) : ExplorerTest(parameters(until_time)) {}

  /// The robot is carried away once the exploration is done, and the clock jumps back.
  void expectItStaysDone() {
    pose.x += 0.7;
    const std::size_t goals = tick().status.goals_sent;
    history.clear();
    now -= std::chrono::seconds(50);
    const exploration::ExplorerOutput output = tickFor(20.0);
    EXPECT_EQ(output.status.state, State::kDone);
    EXPECT_EQ(output.status.goals_sent, goals);
    EXPECT_TRUE(history.empty()) << history.front().reason_text;
  }
};
// [EXP-8] [EXP-10]
TEST_F(ExplorationThatReturns, TheWayBackIsTriedAgainWhenTheNavigationCouldDriveNowhere_EXP_8_EXP_10) {
  show(kClosedRoom);
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  const exploration::GoalCommand first = sent;
  goalEnds(exploration::GoalEvent::Kind::kUnable, "lost pose");
  EXPECT_EQ(tickFor(1.0).status.reason, Reason::kNavigationUnable);
  EXPECT_EQ(tickFor(10.0).status.reason, Reason::kReturningToStart);
  EXPECT_NE(sent.goal_id, first.goal_id);
}

class ExplorationForATime : public ExplorationThatReturns {
 protected:
  ExplorationForATime() : ExplorationThatReturns(3.0) {}
};

// [EXP-10]
TEST_F(ExplorationThatReturns, StaysDoneWithoutDrivingToItsStartOnceMoreWhenTheClockJumpsBack_EXP_10) {
  show(kClosedRoom);
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  goalEnds(exploration::GoalEvent::Kind::kReached);
  ASSERT_EQ(tickFor(0.5).status.state, State::kDone);
  expectItStaysDone();
}

// [EXP-10]
TEST_F(ExplorationForATime, StaysEndedWithoutDrivingToItsStartOnceMoreWhenTheClockJumpsBack_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(4.0).status.reason, Reason::kReturningToStart);
  goalEnds(exploration::GoalEvent::Kind::kReached);
  ASSERT_EQ(tickFor(0.5).status.reason, Reason::kUntilTime);
  expectItStaysDone();
}

// [EXP-8] [EXP-10]
TEST_F(ExplorationForATime, TheWayBackIsNotTriedInEveryTickWhereTheNavigationCanDriveNowhere_EXP_8_EXP_10) {
  show(kRoom);
  const std::size_t before = tickFor(4.0).status.goals_sent;
  for (int i = 0; i < 100; ++i) {
    goalEnds(exploration::GoalEvent::Kind::kUnable, "internal error");
    tick();
  }
  const exploration::ExplorerOutput output = tickFor(6.0);
  EXPECT_EQ(output.status.reason, Reason::kReturningToStart);
  EXPECT_LE(output.status.goals_sent, before + 3);
}

TEST_F(ExplorerInputsTest, ResetForgetsBlacklistAndPhase) {
  show(kTwoEnds);
  tick();
  for (int i = 0; i < 2; ++i) {
    inputs.goal_events = {{sent.goal_id, exploration::GoalEvent::Kind::kRejected, "no"}};
    tickFor(0.5);
  }
  ASSERT_FALSE(explorer.blacklist().empty());
  inputs.reset = true;
  const exploration::ExplorerOutput output = tick();
  EXPECT_TRUE(explorer.blacklist().empty());
  const auto reset = std::find_if(history.begin(), history.end(),
                                  [](const exploration::ExplorerProgress& p) { return p.reason == Reason::kReset; });
  ASSERT_NE(reset, history.end());
  EXPECT_EQ(reset->phase, exploration::ExplorerPhase::kRich);
  EXPECT_EQ(output.status.state, State::kNavigating);
}

// [EXP-5]
TEST_F(ExplorerInputsTest, AMapOfAnotherSizeKeepsTheBlacklistWhereItShowsTheSame_EXP_5) {
  show(kTwoEnds);
  tick();
  for (int i = 0; i < 2; ++i) {
    inputs.goal_events = {{sent.goal_id, exploration::GoalEvent::Kind::kAborted, "no"}};
    tickFor(0.5);
  }
  ASSERT_EQ(explorer.blacklist().size(), 1U);
  show(std::regex_replace(kTwoEnds, std::regex("\\?\n"), "?????\n"));
  EXPECT_EQ(tickFor(0.5).status.state, State::kNavigating);
  EXPECT_EQ(explorer.blacklist().size(), 1U);
  show(kRoom);                   // whose left end is a wall
  pose = Pose2(0.3, 0.27, 0.0);  // far enough from the new frontier
  EXPECT_EQ(tickFor(3.0).status.state, State::kNavigating);
  EXPECT_TRUE(explorer.blacklist().empty());
}

TEST_F(ExplorerInputsTest, TheDistanceTravelledIsThatOfThePoseWithoutItsJumps) {
  show(kRoom);
  for (int i = 0; i < 10; ++i) {
    pose.x += 0.02;
    tick();
  }
  pose.x += 30.0;
  EXPECT_NEAR(tick().status.distance_travelled, 0.18, 1e-9);
}

// [EXP-10]
TEST_F(ExplorerInputsTest, WhatIsDrivenDuringALongDecisionCountsAndACorrectionThenDoesNot_EXP_10) {
  show(kRoom);
  tick();
  const double before = tick().status.distance_travelled;
  now += std::chrono::seconds(20);
  pose.x += 3.0;  // a Burger drives 4.4 m in that time
  EXPECT_NEAR(tick().status.distance_travelled, before + 3.0, 1e-9);
  now += std::chrono::seconds(10);
  pose.x += 5.0;
  EXPECT_NEAR(tick().status.distance_travelled, before + 3.0, 1e-9);
}

}  // namespace
}  // namespace frontier_pilot
