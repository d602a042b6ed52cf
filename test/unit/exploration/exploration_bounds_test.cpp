#include "explorer_fixture.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

/// Two unknown ends, the left one nearer to the robot; the right one is at x > 2.2 m.
class BoundedExplorer : public ExplorerTest {
 protected:
  static std::vector<Vec2> rectangle(double left, double right) {
    return {{left, -1.0}, {right, -1.0}, {right, 2.0}, {left, 2.0}};
  }
  exploration::ExplorationBounds staying(double left, double right) {
    exploration::ExplorationBounds bounds;
    bounds.stay_within = rectangle(left, right);
    return bounds;
  }
  exploration::ExplorationBounds out_of(double left, double right) {
    exploration::ExplorationBounds bounds;
    bounds.keep_out = {rectangle(left, right)};
    return bounds;
  }
  void setBounds(const exploration::ExplorationBounds& bounds) { explorer.setBounds(bounds, world.map); }
};

// [EXP-10]
TEST_F(BoundedExplorer, GoesWhereItMayAndNotWhereItIsNearer_EXP_10) {
  show(kTwoEnds);
  setBounds(staying(0.6, 5.0));
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_GT(sent.goal.x, 1.5) << "the nearer end lies outside";
}

// [EXP-10]
TEST_F(BoundedExplorer, TheWholeRobotStaysInside_EXP_10) {
  show(kTwoEnds);
  setBounds(staying(0.6, 5.0));
  tick();
  for (const exploration::Frontier& frontier : explorer.frontiers()) {
    if (!frontier.selectable()) continue;
    EXPECT_GT(frontier.goal.x(), 0.6 + 0.089) << "half its width";
  }
}

// [EXP-10]
TEST_F(BoundedExplorer, NeitherGoalNorWayLeadsThroughAKeepOutArea_EXP_10) {
  show(kTwoEnds);
  setBounds(out_of(0.2, 0.4));  // a band across the whole room, before the left end
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_GT(sent.goal.x, 1.5);
}

// [EXP-10]
TEST_F(BoundedExplorer, TheAreaOutsideIsNotCounted_EXP_10) {
  show(kClosedRoom);
  const double whole = tick().status.explored_area;
  setBounds(staying(-1.0, 0.05 + 0.05 * 10));
  EXPECT_NEAR(tick().status.explored_area, whole * 10 / 29, 1e-6) << "ten of 29 columns";
}

// [EXP-10]
TEST_F(BoundedExplorer, LiftedBoundsShowEverythingAgain_EXP_10) {
  show(kTwoEnds);
  const double whole = tick().status.explored_area;
  setBounds(staying(0.6, 1.4));
  EXPECT_LT(tick().status.explored_area, whole);
  setBounds({});
  EXPECT_EQ(tick().status.explored_area, whole);
}

// [EXP-10]
TEST_F(BoundedExplorer, IsDoneWhenNothingIsLeftInsideAndGoesOnWithWiderBounds_EXP_10) {
  show(kTwoEnds);
  setBounds(staying(0.5, 1.5));
  EXPECT_EQ(tickFor(5.0).status.state, State::kDone);
  EXPECT_EQ(history.back().reason, Reason::kNoReachableFrontier);
  setBounds({});
  EXPECT_EQ(tickFor(3.0).status.state, State::kNavigating);
}

// [EXP-10]
TEST_F(BoundedExplorer, ARobotOutsideIsToldSoAndNotDriven_EXP_10) {
  show(kTwoEnds);
  setBounds(staying(1.4, 5.0));
  const exploration::ExplorerOutput output = tickFor(10.0);
  EXPECT_EQ(output.status.state, State::kSelectGoal);
  EXPECT_EQ(output.status.reason, Reason::kRobotOutOfBounds);
  EXPECT_EQ(notesWith("outside of the bounds"), 1U);
  EXPECT_EQ(output.status.goals_sent, 0U);
  pose.x = 1.7;
  EXPECT_EQ(tickFor(0.5).status.state, State::kNavigating);
}

// [EXP-10]
TEST_F(BoundedExplorer, AGoalThatNewBoundsForbidIsCancelled_EXP_10) {
  show(kTwoEnds);
  tick();
  const exploration::GoalCommand first = sent;
  ASSERT_LT(first.goal.x, 0.8);
  setBounds(staying(0.8, 5.0));
  tick();
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kBoundsChanged));
  EXPECT_NE(sent.goal_id, first.goal_id) << "the new goal replaces it";
  EXPECT_GT(sent.goal.x, 1.5);
}

// [EXP-10]
TEST_F(BoundedExplorer, NewBoundsAroundAGoalButNotTheRobotStopIt_EXP_10) {
  show(kTwoEnds);
  tick();
  setBounds(staying(-1.0, sent.goal.x + 0.2));
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.reason, Reason::kRobotOutOfBounds);
}

// [EXP-10]
TEST_F(BoundedExplorer, BoundsSurviveAMapOfAnotherSize_EXP_10) {
  show(kTwoEnds);
  setBounds(staying(0.6, 5.0));
  show(kRoom);
  pose = Pose2(1.0, 0.27, 0.0);
  EXPECT_EQ(tick().status.state, State::kNavigating);
  show(kTwoEnds);
  tickFor(1.0);
  EXPECT_GT(sent.goal.x, 0.6);
}

// [EXP-10]
TEST_F(BoundedExplorer, BoundsMayBeSetBeforeThereIsAMap_EXP_10) {
  explorer.setBounds(staying(0.6, 5.0), {});
  tick();
  show(kTwoEnds);
  EXPECT_EQ(tick().status.state, State::kNavigating);
  EXPECT_GT(sent.goal.x, 1.5);
}

// [EXP-10]
TEST(ExplorationBounds, ABrokenPolygonIsRefusedByName_EXP_10) {
  const auto problemsOf = [](const std::string& yaml) {
    exploration::ExplorerParameters parameters;
    Problems problems = loadParameters(parseYaml(yaml), parameters);
    return problems.size() == 1 ? problems[0] : std::to_string(problems.size()) + " problems";
  };
  EXPECT_EQ(problemsOf("{bounds: {stay_within: [0, 0, 1, 0, 1, 1, 0, 1], keep_out: [[0, 0, 1, 0, 1, 1]]}}"),
            "0 problems");
  EXPECT_EQ(problemsOf("{bounds: {stay_within: [0, 0, 1, 0]}}"),
            "bounds/stay_within: must have at least three corners");
  EXPECT_EQ(problemsOf("{bounds: {stay_within: [0, 0, 1, 1, 1, 0, 0, 1]}}"),
            "bounds/stay_within: crosses or touches itself");
  EXPECT_EQ(problemsOf("{bounds: {stay_within: [0, 0, 1, 0, 1, 1, 7]}}"), "bounds/stay_within: must be pairs x, y");
  EXPECT_EQ(problemsOf("{bounds: {keep_out: [[0, 0, 1, 0, 1, 1], [0, 0, 1, 0, 2, 0]]}}"),
            "bounds/keep_out[1]: has no area");
  EXPECT_EQ(problemsOf("{bounds: {keep_out: [[0, 0, 1, 0, 1, x]]}}"), "bounds/keep_out[0]: must be a list of numbers");
  EXPECT_EQ(problemsOf("{bounds: {keep_out: [0, 0, 1, 0, 1, 1]}}"), "bounds/keep_out[0]: must be a list of numbers");
}

// [EXP-10]
TEST(ExplorationBounds, TooManyCornersAndCoordinatesThatAreNotFiniteAreRefused_EXP_10) {
  exploration::ExplorationBounds bounds;
  bounds.keep_out.assign(501, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  EXPECT_NE(bounds.problem().find("2000 corners"), std::string::npos);
  bounds.keep_out.assign(1, {{0.0, 0.0}, {1.0, 0.0}, {std::nan(""), 1.0}});
  EXPECT_EQ(bounds.problem(), "keep_out[0]: a corner is not finite or farther than 1000 km away");
}

}  // namespace
}  // namespace frontier_pilot
