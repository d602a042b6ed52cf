#include <gtest/gtest.h>

#include <string>

#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using Phase = exploration::ExplorerPhase;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;
using Event = exploration::GoalEvent::Kind;

class ExplorerPhases : public test::ExplorerTest {
 protected:
  static exploration::ExplorerParameters parameters(double rich_min_density) {
    exploration::ExplorerParameters p = shortSighted();
    p.rich_min_density = rich_min_density;
    return p;
  }
  explicit ExplorerPhases(double rich_min_density = exploration::ExplorerParameters().rich_min_density)
      : test::ExplorerTest(parameters(rich_min_density)) {}

  /// What was said when the phase changed; empty if it did not.
  std::string textOfChange() const {
    for (const exploration::ExplorerProgress& p : history) {
      if (p.reason == Reason::kRichFrontiersExhausted) return p.reason_text;
    }
    return "";
  }

  /// A niche of five unknown cells on the left, near the robot, and an open end on the right.
  static constexpr const char* kNicheAndOpenEnd = R"(
    ###################################################????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    ?..................................................????????????????????
    ?..................................................????????????????????
    ?.................r................................????????????????????
    ?..................................................????????????????????
    ?..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    ###################################################????????????????????
  )";
  /// The same without the niche.
  static constexpr const char* kOpenEnd = R"(
    ###################################################????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #.................r................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    #..................................................????????????????????
    ###################################################????????????????????
  )";
};

// [EXP-1]
TEST_F(ExplorerPhases, RichLastsWhileARichFrontierCanBeSelectedOrIsDrivenTo_EXP_1) {
  show(kOpenEnd);
  tick();
  EXPECT_EQ(tickFor(3.0).status.phase, Phase::kRich);
  pose = sent.goal;  // too near by now to be sent there
  change({70, 1, 1, 1}, kOccupied);
  EXPECT_EQ(tickFor(3.0).status.phase, Phase::kRich);
  change({51, 0, 20, 13}, kOccupied);
  goalEnds(Event::kReached);
  const exploration::ExplorerOutput output = tickFor(1.0);
  EXPECT_EQ(output.status.phase, Phase::kCoverage);
  EXPECT_EQ(textOfChange(), "no rich frontier left, others that can be selected: 0");
}

// [EXP-1]
TEST_F(ExplorerPhases, TheScoreAloneChoosesInPhaseRich_EXP_1) {
  show(kNicheAndOpenEnd);
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.phase, Phase::kRich);
  EXPECT_EQ(output.status.frontiers_selectable, 2U);
  EXPECT_LT(sent.goal.x, pose.x) << "the niche is on the way of nothing else, and near";
}

// [EXP-1]
TEST_F(ExplorerPhases, CoverageFetchesWhatIsLeftAndSaysHowMuchThatIs_EXP_1) {
  show(kNicheAndOpenEnd);
  tick();
  change({51, 0, 20, 13}, kOccupied);  // the open end has been seen from afar
  const exploration::ExplorerOutput output = tickFor(3.0);
  EXPECT_EQ(output.status.phase, Phase::kCoverage);
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_EQ(textOfChange(), "no rich frontier left, others that can be selected: 1");
}

class SelectionByDensity : public ExplorerPhases {
 protected:
  SelectionByDensity() : ExplorerPhases(0.2) {}
};

// [EXP-1]
TEST_F(SelectionByDensity, OnlyRichFrontiersAreSelectedInPhaseRich_EXP_1) {
  show(kNicheAndOpenEnd);
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.phase, Phase::kRich);
  EXPECT_EQ(output.status.frontiers_selectable, 1U);
  EXPECT_GT(sent.goal.x, pose.x);
}

class NothingIsRich : public ExplorerPhases {
 protected:
  NothingIsRich() : ExplorerPhases(0.9) {}
};

// [EXP-1]
TEST_F(NothingIsRich, PhaseCoverageFollowsWhenNoRichFrontierIsLeft_EXP_1) {
  show(kRoom);
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.status.phase, Phase::kCoverage);
  EXPECT_EQ(output.status.state, State::kNavigating);
  EXPECT_TRUE(wentThrough(State::kSelectGoal, Reason::kRichFrontiersExhausted));
  EXPECT_EQ(textOfChange(), "no rich frontier left, others that can be selected: 1");
}

class GreedyExplorer : public test::ExplorerTest {
 protected:
  static exploration::ExplorerParameters parameters() {
    exploration::ExplorerParameters p = shortSighted();
    p.strategy = "greedy";
    return p;
  }
  GreedyExplorer() : test::ExplorerTest(parameters()) {}

  /// Two ways on: the left end is nearer to the robot, behind the right one more is unknown.
  static constexpr const char* kNearAndWide = R"(
    ############################################????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ##??..............r.........................????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ##??........................................????????????????????
    ############################################????????????????????
  )";
};

// [EXP-4]
TEST_F(GreedyExplorer, OtherWeightsDecideTheNextGoalWithinADecision_EXP_4) {
  show(kNearAndWide);
  tickFor(0.3);
  EXPECT_LT(sent.goal.x, pose.x) << "the distance decides";
  exploration::ExplorerParameters changed = parameters();
  changed.frontier.score.w_dist = 0.0;
  changed.frontier.score.w_info = 50.0;
  explorer.setParameters(changed);
  tickFor(changed.decision_period + 0.2);
  EXPECT_GT(sent.goal.x, pose.x) << "what there is to see decides [EXP-4]";
}

// [EXP-10]
TEST_F(GreedyExplorer, OtherWeightsLeaveTheOperatorsSwitchAsItIs_EXP_10) {
  explorer.setReturnToStart(true);
  explorer.setParameters(parameters());
  EXPECT_TRUE(explorer.returnsToStart());
}

// [EXP-4]
TEST_F(GreedyExplorer, NewWeightsAreThoseInTheExplanationToo_EXP_4) {
  show(kRoom);
  tick();
  ASSERT_EQ(explorer.explain().find("information +0.00"), std::string::npos) << explorer.explain();
  exploration::ExplorerParameters tuned = parameters();
  tuned.frontier.score.w_info = 0.0;
  explorer.setParameters(tuned);
  tickFor(tuned.decision_period + 0.2);
  EXPECT_NE(explorer.explain().find("information +0.00"), std::string::npos) << explorer.explain();
}

}  // namespace
}  // namespace frontier_pilot
