#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;
using Event = exploration::GoalEvent::Kind;
using exploration::GoalCommand;

exploration::ExplorerParameters endingAfter(double area, double time, double distance, bool return_to_start = false) {
  exploration::ExplorerParameters parameters;
  parameters.frontier.view.sensor_range = 1.0;
  parameters.until.area = area;
  parameters.until.time = time;
  parameters.until.distance = distance;
  parameters.return_to_start = return_to_start;
  return parameters;
}

class UntilTime : public ExplorerTest {
 protected:
  UntilTime() : ExplorerTest(endingAfter(0.0, 10.0, 0.0)) {}
};

// [EXP-10]
TEST_F(UntilTime, EndsWithItsOwnReasonAndCancelsTheGoal_EXP_10) {
  show(kRoom);
  EXPECT_EQ(tickFor(9.5).status.state, State::kNavigating);
  const exploration::ExplorerOutput output = tickFor(1.0);
  EXPECT_EQ(output.command.kind, GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilTime);
  EXPECT_NEAR(output.status.exploring_time, 10.0, 0.11);
}

// [EXP-10]
TEST_F(UntilTime, IsNotWokenByAChangedMapButByAStart_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(11.0).status.state, State::kDone);
  change({30, 1, 2, 9}, kFree);
  EXPECT_EQ(tickFor(10.0).status.state, State::kDone);
  inputs.start = true;
  EXPECT_EQ(tick().status.state, State::kNavigating);
  inputs.start = false;
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kStartedAgain));
  EXPECT_EQ(tickFor(9.0).status.state, State::kNavigating) << "the time is counted anew";
  EXPECT_EQ(tickFor(2.0).status.reason, Reason::kUntilTime);
}

// [EXP-10]
TEST_F(UntilTime, AStartInTheMiddleOfAnExplorationChangesNothing_EXP_10) {
  show(kRoom);
  tickFor(5.0);
  inputs.start = true;
  const std::uint32_t id = sent.goal_id;
  tick();
  inputs.start = false;
  EXPECT_EQ(sent.goal_id, id);
  EXPECT_EQ(tickFor(5.5).status.reason, Reason::kUntilTime);
}

// [EXP-10]
TEST_F(UntilTime, PausesDoNotCount_EXP_10) {
  show(kRoom);
  tickFor(5.0);
  inputs.enabled = false;
  tickFor(60.0);
  inputs.enabled = true;
  EXPECT_EQ(tickFor(4.0).status.state, State::kNavigating);
  EXPECT_EQ(tickFor(2.0).status.state, State::kDone);
}

// [EXP-10]
TEST_F(UntilTime, AResetBeginsAnew_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(11.0).status.state, State::kDone);
  inputs.reset = true;
  EXPECT_EQ(tick().status.state, State::kNavigating);
}

// [EXP-10]
TEST_F(UntilTime, APauseAfterTheEndDoesNotUndoIt_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(11.0).status.state, State::kDone);
  inputs.enabled = false;
  EXPECT_EQ(tickFor(1.0).status.reason, Reason::kPaused);
  inputs.enabled = true;
  EXPECT_EQ(tickFor(1.0).status.reason, Reason::kUntilTime);
}

class UntilDistance : public ExplorerTest {
 protected:
  UntilDistance() : ExplorerTest(endingAfter(0.0, 0.0, 0.5)) {}
};

// [EXP-10]
TEST_F(UntilDistance, CountsWhatIsDrivenWhileExploring_EXP_10) {
  show(kRoom);
  inputs.enabled = false;
  for (int i = 0; i < 6; ++i) {
    pose.x += 0.05;
    tick();
  }
  inputs.enabled = true;
  tick();
  for (int i = 0; i < 9; ++i) {
    pose.x += 0.05;
    EXPECT_EQ(tick().status.state, State::kNavigating);
  }
  pose.x += 0.06;
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.reason, Reason::kUntilDistance);
  EXPECT_NEAR(output.status.exploring_distance, 0.51, 1e-9);
  EXPECT_NEAR(output.status.distance_travelled, 0.76, 1e-9) << "the first tick only tells where it stands";
}

class UntilArea : public ExplorerTest {
 protected:
  UntilArea() : ExplorerTest(endingAfter(0.7, 0.0, 0.0, true)) {}  // the room has 0.65 m^2 at first
};

// [EXP-10]
TEST_F(UntilArea, ReturnsToTheStartBeforeItIsDone_EXP_10) {
  show(kRoom);
  const Pose2 start = pose;
  EXPECT_EQ(tick().status.state, State::kNavigating);
  pose = sent.goal;
  change({30, 1, 3, 9}, kFree);
  exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.reason, Reason::kReturningToStart);
  EXPECT_EQ(sent.goal.position(), start.position());
  change({30, 1, 1, 9}, kOccupied);
  EXPECT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  pose = start;
  goalEnds(Event::kReached);
  output = tick();
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilArea);
}

// [EXP-10]
TEST_F(UntilArea, IsNotSentOutAgainByAMapThatChangedOnTheWayBack_EXP_10) {
  show(kRoom);
  const Pose2 start = pose;
  tick();
  pose = sent.goal;
  change({30, 1, 3, 9}, kFree);  // the right end is still unknown
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  change({30, 1, 1, 1}, kOccupied);
  pose = start;
  goalEnds(Event::kReached);
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.command.kind, GoalCommand::Kind::kNone);
  EXPECT_FALSE(wentThrough(State::kSelectGoal, Reason::kMapChanged));
}

class UntilTimeWithReturn : public ExplorerTest {
 protected:
  UntilTimeWithReturn() : ExplorerTest(endingAfter(0.0, 10.0, 0.0, true)) {}
};

// [EXP-10]
TEST_F(UntilTimeWithReturn, DoesNotReturnToAStartOutOfBounds_EXP_10) {
  show(kTwoEnds);
  tick();
  pose.x = 1.7;
  exploration::ExplorationBounds bounds;
  bounds.stay_within = {{1.2, -1.0}, {5.0, -1.0}, {5.0, 2.0}, {1.2, 2.0}};
  explorer.setBounds(bounds, world.map);
  EXPECT_EQ(tickFor(11.0).status.reason, Reason::kUntilTime);
  EXPECT_FALSE(wentThrough(State::kNavigating, Reason::kReturningToStart));
}

class UntilBattery : public ExplorerTest {
 protected:
  static exploration::ExplorerParameters atTwentyPercent() {
    exploration::ExplorerParameters parameters = endingAfter(0.0, 0.0, 0.0);
    parameters.until.battery = 0.2;
    return parameters;
  }
  UntilBattery() : ExplorerTest(atTwentyPercent()) {}
};

// [EXP-10]
TEST_F(UntilBattery, EndsWhenTheChargeIsDownToTheLimit_EXP_10) {
  show(kRoom);
  inputs.battery = 0.21;
  EXPECT_EQ(tickFor(1.0).status.state, State::kNavigating);
  inputs.battery = 0.2;
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilBattery);
}

// [EXP-10]
TEST_F(UntilBattery, AChargeThatIsNotKnownDoesNotEndIt_EXP_10) {
  show(kRoom);
  EXPECT_EQ(tickFor(5.0).status.state, State::kNavigating);
}

// [EXP-10]
TEST_F(UntilBattery, GoesOnAfterAStartOnlyWhenItHasBeenCharged_EXP_10) {
  show(kRoom);
  inputs.battery = 0.1;
  ASSERT_EQ(tick().status.reason, Reason::kUntilBattery);
  inputs.start = true;
  EXPECT_EQ(tick().status.reason, Reason::kUntilBattery);
  inputs.battery = 0.9;
  EXPECT_EQ(tick().status.state, State::kNavigating);
}

// [EXP-10]
TEST_F(UntilBattery, TheReturnToTheStartCanBeAskedForMeanwhile_EXP_10) {
  show(kRoom);
  tick();
  explorer.setReturnToStart(true);
  inputs.battery = 0.1;
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.reason, Reason::kReturningToStart);
  EXPECT_EQ(output.command.kind, GoalCommand::Kind::kSend);
}

// [EXP-10]
TEST(UntilParameters, AreToldInWords_EXP_10) {
  exploration::UntilParameters until;
  EXPECT_EQ(until.inWords(), "");
  until.area = 400.0;
  EXPECT_EQ(until.inWords(), "400 m2 are known");
  until.time = 90.0;
  until.battery = 0.25;
  EXPECT_EQ(until.inWords(), "400 m2 are known, 90 s have passed or the battery is at 25 %");
  until = {};
  until.share = 0.9;
  EXPECT_EQ(until.inWords(), "90 % of the estimated floor is explored");
}

// [EXP-10]
TEST(UntilParameters, TellTheAreaThatHasToBeKnownAfterARestart_EXP_10) {
  exploration::UntilParameters until;
  until.area = 400.0;
  EXPECT_EQ(until.inWords(412.34), "812.3 m2 are known");
}

using OthersGoal = ExplorerTest;

// [EXP-11]
TEST_F(OthersGoal, IsWaitedForAsLongAsItTakes_EXP_11) {
  show(kRoom);
  tick();
  const std::uint32_t first = sent.goal_id;
  inputs.others_goal = true;
  goalEnds(Event::kPreempted, "another goal");
  exploration::ExplorerOutput output = tickFor(600.0);
  EXPECT_EQ(output.status.state, State::kIdle);
  EXPECT_EQ(output.status.reason, Reason::kOthersGoal);
  EXPECT_EQ(output.status.reason_text, "waiting for your goal to end");
  EXPECT_EQ(sent.goal_id, first) << "nothing was sent that would replace the goal";
  inputs.others_goal = false;
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_NE(sent.goal_id, first);
}

// [EXP-11]
TEST_F(OthersGoal, IsNotReplacedByAnExplorerThatStartsOrWakesUp_EXP_11) {
  show(kClosedRoom);
  inputs.others_goal = true;
  EXPECT_EQ(tick().status.reason, Reason::kOthersGoal);
  inputs.others_goal = false;
  EXPECT_EQ(tickFor(5.0).status.state, State::kDone);
  inputs.others_goal = true;
  change({20, 1, 8, 9}, kUnknown);
  EXPECT_EQ(tickFor(10.0).status.state, State::kDone);
  EXPECT_EQ(sent.goal_id, 0U);
  inputs.others_goal = false;
  EXPECT_EQ(tickFor(1.0).status.state, State::kNavigating);
}

}  // namespace
}  // namespace frontier_pilot
