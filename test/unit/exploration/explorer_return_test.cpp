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

}  // namespace
}  // namespace frontier_pilot
