#include "waypoints/waypoint_follower.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using waypoints::LegEnd;
using waypoints::WaypointFollower;
using waypoints::WaypointInputs;
using waypoints::WaypointOutcome;
using waypoints::WaypointOutput;
using waypoints::WaypointParameters;

class Waypoints : public ::testing::Test {
 protected:
  void SetUp() override { inputs_.navigation_up = true; }
  WaypointOutput update(double seconds = 0.1) {
    now_ += fromSeconds(seconds);
    const WaypointOutput output = follower_.update(inputs_, now_);
    inputs_.ended.clear();
    if (output.send) leg_ = output.send->leg;
    return output;
  }
  /// The goal that is under way ends like that.
  WaypointOutput ends(LegEnd::Kind kind, const char* text = "no path") {
    inputs_.ended.push_back({leg_, kind, text});
    return update();
  }
  void stopOnFailure() {
    WaypointParameters parameters;
    parameters.stop_on_failure = true;
    follower_ = WaypointFollower(parameters);
  }

  WaypointFollower follower_{WaypointParameters{}};
  WaypointInputs inputs_;
  Time now_ = Time{} + fromSeconds(100.0);
  std::uint32_t leg_ = 0;
};

// [NAV-5]
TEST_F(Waypoints, AreGoneToInTheirOrder) {
  follower_.start(3, now_);
  EXPECT_EQ(update().send->waypoint, 0U);
  EXPECT_FALSE(update().send) << "each is sent once";
  EXPECT_EQ(ends(LegEnd::Kind::kReached).send->waypoint, 1U) << "at once";
  EXPECT_EQ(ends(LegEnd::Kind::kReached).send->waypoint, 2U);
  const WaypointOutput output = ends(LegEnd::Kind::kReached);
  EXPECT_TRUE(output.ended);
  EXPECT_FALSE(output.cancel);
  EXPECT_EQ(output.outcome, WaypointOutcome::kCompleted);
  EXPECT_EQ(output.text, "3 of 3 waypoints reached");
  EXPECT_FALSE(update().ended) << "it ends once";
}

// [NAV-5]
TEST_F(Waypoints, ThatCannotBeReachedAreLeftOutAndListed) {
  follower_.start(2, now_);
  update();
  EXPECT_EQ(ends(LegEnd::Kind::kFailed).send->waypoint, 1U);
  EXPECT_EQ(ends(LegEnd::Kind::kReached).text, "1 of 2 waypoints reached, missed: 1");
  EXPECT_EQ(follower_.missed(), std::vector<std::size_t>{0});
}

// [NAV-5]
TEST_F(Waypoints, AreGivenUpAfterAMissedOneIfThatIsWanted) {
  stopOnFailure();
  follower_.start(2, now_);
  update();
  const WaypointOutput output = ends(LegEnd::Kind::kFailed, "goal occupied");
  EXPECT_EQ(output.outcome, WaypointOutcome::kWaypointMissed);
  EXPECT_EQ(output.text, "aborted: waypoint 1 of 2 could not be reached: goal occupied");
  EXPECT_EQ(follower_.missed(), std::vector<std::size_t>{0});
}

// [NAV-5]
TEST_F(Waypoints, EndWithAnEmergencyStopAndTheGoalIsCancelled) {
  follower_.start(2, now_);
  update();
  inputs_.emergency_stop = true;
  const WaypointOutput output = update();
  EXPECT_TRUE(output.cancel);
  EXPECT_EQ(output.outcome, WaypointOutcome::kEmergencyStop);
  inputs_.emergency_stop = false;
  EXPECT_FALSE(update().send) << "nothing goes on when the stop is cleared";
}

// [NAV-5]
TEST_F(Waypoints, AreNotBegunDuringAnEmergencyStop) {
  inputs_.emergency_stop = true;
  follower_.start(2, now_);
  const WaypointOutput output = update();
  EXPECT_FALSE(output.send);
  EXPECT_FALSE(output.cancel) << "a goal of somebody else is none of ours";
  EXPECT_EQ(output.outcome, WaypointOutcome::kEmergencyStop);
}

// [NAV-5]
TEST_F(Waypoints, AreCancelledWithTheGoalThatIsUnderWay) {
  follower_.start(2, now_);
  update();
  const WaypointOutput output = follower_.cancel();
  EXPECT_TRUE(output.cancel);
  EXPECT_TRUE(output.ended);
  EXPECT_EQ(output.outcome, WaypointOutcome::kCanceled);
  EXPECT_FALSE(follower_.cancel().ended) << "there is nothing left to cancel";
}

// [NAV-5]
TEST_F(Waypoints, GiveWayToAGoalOfSomebodyElse) {
  follower_.start(2, now_);
  update();
  const WaypointOutput output = ends(LegEnd::Kind::kReplaced, "preempted");
  EXPECT_EQ(output.outcome, WaypointOutcome::kReplaced);
  EXPECT_FALSE(output.cancel) << "that would be the other goal";
  EXPECT_EQ(output.text, "aborted: the goal of waypoint 1 of 2 ended: preempted");
}

// [NAV-5] They may have been drawn on another map than the one on which the robot is to be found.
TEST_F(Waypoints, EndWithANavigationThatCanDriveNowhere) {
  follower_.start(3, now_);
  ASSERT_TRUE(update().send);
  const WaypointOutput output = ends(LegEnd::Kind::kUnable, "not localised");
  EXPECT_TRUE(output.ended);
  EXPECT_EQ(output.outcome, WaypointOutcome::kNavigationUnable);
  EXPECT_EQ(output.text, "aborted: on the way to waypoint 1 of 3 the navigation gave the goal up: not localised");
  EXPECT_TRUE(follower_.missed().empty()) << "the place is not the cause";
  EXPECT_FALSE(update().send) << "nothing goes on when it can drive again";
}

// [NAV-5] [MAP-5]
TEST_F(Waypoints, EndWithTheMapThatTheyWereMeantFor) {
  EXPECT_FALSE(follower_.abortByMap().ended);
  follower_.start(3, now_);
  ASSERT_TRUE(update().send);
  const WaypointOutput output = follower_.abortByMap();
  EXPECT_TRUE(output.ended && output.cancel);
  EXPECT_EQ(output.outcome, WaypointOutcome::kNavigationUnable);
  EXPECT_EQ(output.text, "aborted: the map was replaced");
}

// [NAV-5]
TEST_F(Waypoints, EndWithANavigationThatFailsWhileTheArbiterDoesNotHeedIt) {
  follower_.start(3, now_);
  ASSERT_TRUE(update().send);
  inputs_.navigation_refused = "its source nav is disabled";
  EXPECT_FALSE(update(40.0).ended) << "it may be enabled again before the navigation gives up";
  const WaypointOutput output = ends(LegEnd::Kind::kFailed, "blocked");
  EXPECT_EQ(output.outcome, WaypointOutcome::kNavigationUnable);
  EXPECT_EQ(output.text,
            "aborted: on the way to waypoint 1 of 3 the navigation gave the goal up: blocked, without the arbiter's "
            "permission "
            "to drive (its source nav is disabled)");
  EXPECT_TRUE(follower_.missed().empty()) << "the place is not the cause";
}

// [NAV-5]
TEST_F(Waypoints, WaitForANavigationThatIsRestartedAndSendTheGoalAgain) {
  follower_.start(2, now_);
  const std::uint32_t first = update().send->leg;
  inputs_.navigation_up = false;
  EXPECT_FALSE(update(5.0).ended);
  inputs_.navigation_up = true;
  const WaypointOutput again = update();
  EXPECT_EQ(again.send->waypoint, 0U);
  EXPECT_NE(again.send->leg, first);
  inputs_.ended.push_back({first, LegEnd::Kind::kFailed, "late news"});
  EXPECT_FALSE(update().send) << "the end of the goal of the server that died means nothing";
  EXPECT_TRUE(follower_.missed().empty());
  EXPECT_EQ(ends(LegEnd::Kind::kLost).send->waypoint, 0U);
}

// [NAV-5] Whoever waited for the navigation has sent a goal first.
TEST_F(Waypoints, GiveWayToAGoalThatARestartedNavigationPursuesAlready) {
  follower_.start(2, now_);
  ASSERT_TRUE(update().send);
  inputs_.navigation_up = false;
  update();
  inputs_.navigation_up = inputs_.navigation_serves_others = true;
  const WaypointOutput output = update();
  EXPECT_FALSE(output.send);
  EXPECT_EQ(output.outcome, WaypointOutcome::kReplaced);
  EXPECT_EQ(output.text, "aborted: another goal came before that of waypoint 1 of 2 was sent again");
}

// [NAV-5]
TEST_F(Waypoints, ReplaceTheGoalOfSomebodyElseWhenTheyBeginAndWhenOneIsReached) {
  inputs_.navigation_serves_others = true;  // also for a moment after that goal has ended
  follower_.start(2, now_);
  EXPECT_TRUE(update().send);
  EXPECT_TRUE(ends(LegEnd::Kind::kReached).send);
}

// [NAV-5]
TEST_F(Waypoints, AreCancelledAlsoWhileTheNavigationSeemsToBeGone) {
  follower_.start(2, now_);
  ASSERT_TRUE(update().send);
  inputs_.navigation_up = false;
  update();
  EXPECT_TRUE(follower_.cancel().cancel) << "it may drive on and only be hard to hear";
}

// [NAV-5]
TEST_F(Waypoints, EndWithAGoalThatWasReplacedWhileTheNavigationSeemedToBeGone) {
  follower_.start(2, now_);
  ASSERT_TRUE(update().send);
  inputs_.navigation_up = false;
  update();
  const WaypointOutput output = ends(LegEnd::Kind::kReplaced, "preempted");
  EXPECT_TRUE(output.ended);
  EXPECT_EQ(output.outcome, WaypointOutcome::kReplaced);
  EXPECT_FALSE(output.cancel) << "that would be the other goal";
  inputs_.navigation_up = true;
  EXPECT_FALSE(update().send) << "whoever has cancelled or replaced it wants nothing more of it";
}

// [NAV-5]
TEST_F(Waypoints, ThatAreReachedWhileTheNavigationSeemsToBeGoneAreNotGoneToAgain) {
  follower_.start(2, now_);
  ASSERT_TRUE(update().send);
  inputs_.navigation_up = false;
  update();
  EXPECT_FALSE(ends(LegEnd::Kind::kReached).send) << "nobody takes it yet";
  inputs_.navigation_up = true;
  EXPECT_EQ(update().send->waypoint, 1U);
}

// [NAV-5]
TEST_F(Waypoints, OfWhichNoneIsReachedAreNoSuccess) {
  follower_.start(2, now_);
  update();
  EXPECT_FALSE(ends(LegEnd::Kind::kFailed).ended);
  const WaypointOutput output = ends(LegEnd::Kind::kFailed);
  EXPECT_TRUE(output.ended);
  EXPECT_EQ(output.outcome, WaypointOutcome::kWaypointMissed);
}

// [NAV-5]
TEST_F(Waypoints, EndWhenTheClockJumps) {
  follower_.start(2, now_);
  ASSERT_TRUE(update().send);
  const WaypointOutput output = follower_.abortByClockJump();
  EXPECT_TRUE(output.ended && output.cancel);
  EXPECT_FALSE(follower_.active());
}

// [NAV-5]
TEST_F(Waypoints, AreGivenUpWhenNothingServesTheNavigation) {
  inputs_.navigation_up = false;
  follower_.start(1, now_);
  EXPECT_FALSE(update(9.0).ended);
  const WaypointOutput output = update(1.5);
  EXPECT_EQ(output.outcome, WaypointOutcome::kNavigationGone);
  EXPECT_FALSE(output.cancel);
}

TEST_F(Waypoints, OutliveAClockThatIsSetBack) {
  inputs_.navigation_up = false;
  follower_.start(1, now_);
  now_ -= fromSeconds(50.0);
  EXPECT_FALSE(update(9.0).ended);
  EXPECT_TRUE(update(10.5).ended);
}

// [NAV-5] [FLT-1]
TEST_F(Waypoints, NoneAndTooManyAreRefused) {
  EXPECT_EQ(follower_.start(0, now_).text, "there are no waypoints");
  EXPECT_EQ(follower_.start(1001, now_).outcome, WaypointOutcome::kInvalidGoal);
  EXPECT_FALSE(follower_.active());
}

}  // namespace
}  // namespace frontier_pilot
