#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

exploration::ExplorerParameters endingAtTheStart(double until_time) {
  exploration::ExplorerParameters parameters;
  parameters.frontier.view.sensor_range = 1.0;
  parameters.return_to_start = true;
  parameters.until.time = until_time;
  return parameters;
}

class WayBackWithoutAScan : public test::ExplorerTest {
 protected:
  explicit WayBackWithoutAScan(double until_time = 0.0) : ExplorerTest(endingAtTheStart(until_time)) {}

  /// Each attempt to drive back ends for want of a scan. Gives the last status, and how long it took to end [s].
  std::pair<exploration::ExplorerProgress, double> tryToReturn() {
    exploration::ExplorerProgress status = tickFor(5.0).status;
    EXPECT_EQ(status.reason, Reason::kReturningToStart);
    const Time begin = now;
    while (status.state != State::kDone && now - begin < std::chrono::minutes(10)) {
      if (status.state == State::kNavigating) goalEnds(exploration::GoalEvent::Kind::kUnable, "no scan");
      status = tick().status;
    }
    return {status, toSeconds(now - begin)};
  }
};

class WayBackAfterATime : public WayBackWithoutAScan {
 protected:
  WayBackAfterATime() : WayBackWithoutAScan(3.0) {}
};

// [EXP-8] [EXP-10] The map at the end is saved only then.
TEST_F(WayBackWithoutAScan, IsGivenUpAfterAWhileSoThatAnExplorationWithNothingLeftIsDone_EXP_8_EXP_10) {
  show(kClosedRoom);
  const auto [status, seconds] = tryToReturn();
  EXPECT_EQ(status.state, State::kDone);
  EXPECT_EQ(status.reason, Reason::kNoReachableFrontier);
  EXPECT_GT(seconds, 55.0) << "a short outage does not keep the robot from its start";
  EXPECT_EQ(tickFor(60.0).status.state, State::kDone);
}

// [EXP-8] [EXP-10]
TEST_F(WayBackAfterATime, IsGivenUpAfterAWhileSoThatAnExplorationEndedByARuleIsDone_EXP_8_EXP_10) {
  show(kRoom);
  const auto [status, seconds] = tryToReturn();
  EXPECT_EQ(status.state, State::kDone);
  EXPECT_EQ(status.reason, Reason::kUntilTime);
  EXPECT_GT(seconds, 55.0);
}

// [EXP-8] [EXP-10] The navigation waits for a scan itself before it gives a goal up.
TEST_F(WayBackWithoutAScan, IsGivenUpAfterAMinuteHoweverLongTheNavigationTakesToSayThatItCannotDrive_EXP_8_EXP_10) {
  show(kClosedRoom);
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  const Time begin = now;
  exploration::ExplorerProgress status = tick().status;
  while (status.state != State::kDone && now - begin < std::chrono::minutes(10)) {
    status = tickFor(15.0).status;
    if (status.state == State::kNavigating) goalEnds(exploration::GoalEvent::Kind::kUnable, "no scan");
  }
  EXPECT_EQ(status.reason, Reason::kNoReachableFrontier);
  EXPECT_LT(toSeconds(now - begin), 120.0);
}

// [EXP-8] [EXP-10]
TEST_F(WayBackAfterATime, IsGivenUpAfterAMinuteInWhichAnInputIsMissing_EXP_8_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  inputs.navigation_refused = "its source avoid has the wheels";
  EXPECT_EQ(tickFor(55.0).status.state, State::kIdle);
  const exploration::ExplorerOutput output = tickFor(10.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilTime);
}

// [EXP-10] The minute begins anew: who lets the exploration go on wants the robot back.
TEST_F(WayBackAfterATime, IsNotGivenUpForWhatWasWaitedBeforeAPause_EXP_10) {
  show(kRoom);
  ASSERT_EQ(tickFor(5.0).status.reason, Reason::kReturningToStart);
  inputs.localized = false;
  tickFor(40.0);
  inputs.enabled = false;
  tickFor(60.0);
  inputs.enabled = true;
  EXPECT_EQ(tickFor(40.0).status.state, State::kIdle);
  inputs.localized = true;
  EXPECT_EQ(tickFor(2.0).status.reason, Reason::kReturningToStart);
}

}  // namespace
}  // namespace frontier_pilot
