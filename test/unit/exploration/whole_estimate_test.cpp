#include "exploration/progress/whole_estimate.h"

#include <cmath>

#include "exploration/limits/stopping_rules.h"
#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using exploration::ExplorationRecord;
using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

ExplorationRecord halfWay() {
  ExplorationRecord record;
  record.explored_area = 100.0;
  record.area_in_sight = 20.0;
  record.time = 60.0;
  record.distance = 25.0;
  record.tour_length = 20.0;
  return record;
}

// [EXP-12]
TEST(WholeEstimate, IsNotMadeBeforeThereIsSomethingToGoBy_EXP_12) {
  ExplorationRecord record = halfWay();
  record.time = 9.0;
  EXPECT_FALSE(exploration::estimateWhole(record));
  record = halfWay();
  record.explored_area = 0.0;
  EXPECT_FALSE(exploration::estimateWhole(record));
}

// [EXP-12]
TEST(WholeEstimate, GrowsWithWhatIsInSightAndSoDoesItsUncertainty_EXP_12) {
  ExplorationRecord record = halfWay();
  const auto some = exploration::estimateWhole(record);
  record.area_in_sight *= 2.0;
  const auto more = exploration::estimateWhole(record);
  ASSERT_TRUE(some && more);
  EXPECT_GT(some->area, record.explored_area);
  EXPECT_GT(more->area, some->area);
  EXPECT_GT(more->deviation, some->deviation);
  EXPECT_GT(more->time_left, some->time_left);
}

// [EXP-12]
TEST(WholeEstimate, IsWhatIsKnownWhenNearlyNothingIsInSight_EXP_12) {
  ExplorationRecord record = halfWay();
  record.area_in_sight = 0.0;
  const auto whole = exploration::estimateWhole(record);
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->area, record.explored_area, 0.5);
  EXPECT_LT(whole->deviation, 0.5);
}

exploration::ExplorerParameters endingAtShare(double share) {
  exploration::ExplorerParameters parameters;
  parameters.frontier.view.sensor_range = 1.0;
  parameters.until.share = share;
  return parameters;
}

class EstimatedWhole : public ExplorerTest {
 protected:
  using ExplorerTest::ExplorerTest;
  /// Explores the room until it has something to estimate the whole by.
  exploration::ExplorerOutput exploreTheRoom() {
    show(kRoom);
    tickFor(9.0);
    change({31, 4, 1, 1}, kFree);  // so that it decides again
    tickFor(3.0);
    change({31, 5, 1, 1}, kFree);
    return tickFor(3.0);
  }
};

class UntilShare : public EstimatedWhole {
 protected:
  UntilShare() : EstimatedWhole(endingAtShare(0.05)) {}
};

// [EXP-10] [EXP-12]
TEST_F(UntilShare, EndsAsSoonAsTheEstimateSaysSoAndGoesOnWhenStartedAgain_EXP_10_EXP_12) {
  show(kRoom);
  EXPECT_EQ(tickFor(9.0).status.state, State::kNavigating);
  EXPECT_FALSE(history.back().whole) << "too early to tell";
  change({31, 4, 1, 1}, kFree);  // so that it decides again
  tickFor(3.0);
  change({31, 5, 1, 1}, kFree);
  const exploration::ExplorerOutput output = tickFor(3.0);
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilShare);
  ASSERT_TRUE(output.status.shareExplored());
  EXPECT_GE(*output.status.shareExplored(), 0.05);
  inputs.start = true;
  tick();
  inputs.start = false;
  EXPECT_EQ(tickFor(5.0).status.state, State::kNavigating) << "the same share does not end it at once";
}

// [EXP-10]
TEST(StoppingRules, CountTheShareAgainAfterAResetWhereNothingWasLeft_EXP_10) {
  exploration::UntilParameters until;
  until.share = 0.9;
  exploration::StoppingRules rules(until);
  rules.startOver({100.0, 1.0, false, {}});
  EXPECT_EQ(rules.met({200.0, 0.95, true, {}}), Reason::kUntilShare);
  rules.startOver({200.0, 0.95, true, {}});
  EXPECT_FALSE(rules.met({210.0, 0.96, true, {}})) << "a share that is explored already ends nothing";
}

// [EXP-10]
TEST_F(UntilShare, AResetLetsItGoOnForLongerThanTheEstimateTakes_EXP_10) {
  ASSERT_EQ(exploreTheRoom().status.reason, Reason::kUntilShare);
  inputs.reset = true;
  tickFor(11.0);
  change({31, 6, 1, 1}, kFree);
  tickFor(3.0);
  change({31, 7, 1, 1}, kFree);
  const exploration::ExplorerOutput output = tickFor(3.0);
  EXPECT_EQ(output.status.state, State::kNavigating);
  ASSERT_TRUE(output.status.whole) << "the share is known again";
  EXPECT_GE(*output.status.shareExplored(), 0.05);
}

// [EXP-12]
TEST_F(ExplorerTest, TheTimeLeftIsUnknownUntilSomethingHasBeenExploredSinceTheReset_EXP_12) {
  show(kRoom);
  tickFor(1.0);
  inputs.reset = true;
  tickFor(11.0);
  change({31, 4, 1, 1}, kOccupied);
  exploration::ExplorerOutput output = tickFor(3.0);
  ASSERT_TRUE(output.status.whole);
  EXPECT_TRUE(std::isnan(output.status.whole->time_left));
  change({31, 5, 1, 1}, kFree);
  output = tickFor(3.0);
  EXPECT_GT(output.status.whole->time_left, 0.0);
}

class UntilTheWhole : public EstimatedWhole {
 protected:
  UntilTheWhole() : EstimatedWhole(endingAtShare(1.0)) {}
};

// [EXP-10] [EXP-12]
TEST_F(UntilTheWhole, WiderBoundsAreNotMeasuredByTheEstimateOfTheNarrowOnes_EXP_10_EXP_12) {
  std::string hall = std::string(110, '#') + "\n";
  for (int row = 0; row < 58; ++row) hall += "#" + std::string(79, '.') + std::string(30, '?') + "\n";
  show(hall + std::string(110, '#') + "\n");
  pose = Pose2(3.0, 1.5, 0.0);
  exploration::ExplorationBounds narrow;
  narrow.stay_within = {{2.5, -1.0}, {9.0, -1.0}, {9.0, 4.0}, {2.5, 4.0}};
  explorer.setBounds(narrow, world.map);
  tickFor(9.0);
  change({80, 20, 1, 1}, kFree);
  tickFor(3.0);
  change({80, 21, 1, 1}, kFree);
  ASSERT_TRUE(tickFor(3.0).status.whole);
  explorer.setBounds({}, world.map);
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_LT(output.status.shareExplored().value_or(0.0), 1.0);
}

// [EXP-10] [EXP-12]
TEST_F(UntilTheWhole, APoseToInspectWakesAnExplorationThatHadNothingLeftAndIsDrivenTo_EXP_10_EXP_12) {
  ASSERT_TRUE(exploreTheRoom().status.whole);
  show(kClosedRoom);
  exploration::ExplorerOutput output = tickFor(10.0);
  ASSERT_EQ(output.status.reason, Reason::kNoReachableFrontier);
  ASSERT_EQ(output.status.shareExplored(), 1.0);
  ASSERT_EQ(explorer.inspect(Pose2(1.1, pose.y, 0.0)), "");
  output = tickFor(10.0);
  EXPECT_EQ(output.status.state, State::kNavigating) << output.status.reason_text;
  EXPECT_EQ(output.status.reason, Reason::kInspecting);
  goalEnds(exploration::GoalEvent::Kind::kReached);
  output = tickFor(20.0);
  EXPECT_EQ(output.status.inspected, 1U);
  EXPECT_EQ(output.status.reason, Reason::kNoReachableFrontier);
}

// [EXP-12]
TEST_F(EstimatedWhole, WhenAllThatIsLeftIsBlacklistedTheWholeIsMoreThanWhatIsExplored_EXP_12) {
  exploration::ExplorerOutput output = exploreTheRoom();
  ASSERT_TRUE(output.status.whole);
  for (int i = 0; i < 40 && output.status.state != State::kDone; ++i) {
    if (output.status.state == State::kNavigating) goalEnds(exploration::GoalEvent::Kind::kAborted, "blocked");
    output = tickFor(1.0);
  }
  ASSERT_EQ(output.status.reason, Reason::kAllBlacklisted);
  EXPECT_LT(output.status.shareExplored(), 1.0);
}

// [EXP-12]
TEST_F(EstimatedWhole, WhenNothingIsLeftTheWholeIsWhatIsExplored_EXP_12) {
  ASSERT_TRUE(exploreTheRoom().status.whole);
  show(kClosedRoom);
  const exploration::ExplorerOutput output = tickFor(10.0);
  ASSERT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.shareExplored(), 1.0);
  EXPECT_EQ(output.status.whole->deviation, 0.0);
  EXPECT_EQ(output.status.whole->time_left, 0.0);
}

}  // namespace
}  // namespace frontier_pilot
