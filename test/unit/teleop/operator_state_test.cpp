#include "teleop/operator_state.h"

#include <gtest/gtest.h>

namespace frontier_pilot::teleop {
namespace {

TEST(ArbiterView, TellsASourceThatDrivesFromOneThatHoldsTheRobotStill) {
  ArbiterView arbiter;
  EXPECT_EQ(arbiter.driver(), "nobody drives");
  arbiter.active_source = "patrol";
  EXPECT_EQ(arbiter.driver(), "patrol holds the robot still");
  arbiter.command = {0.1, 0.0};
  EXPECT_EQ(arbiter.driver(), "patrol drives");
}

TEST(OperatorState, KnowsASourceByItsName) {
  OperatorState state;
  EXPECT_EQ(state.source("nav"), nullptr) << "no arbiter was heard";
  state.arbiter = ArbiterView();
  EXPECT_EQ(state.source("nav"), nullptr);
  SourceView nav;
  nav.name = "nav";
  nav.priority = 40;
  state.arbiter->sources = {SourceView(), nav};
  ASSERT_NE(state.source("nav"), nullptr);
  EXPECT_EQ(state.source("nav")->priority, 40);
}

}  // namespace
}  // namespace frontier_pilot::teleop
