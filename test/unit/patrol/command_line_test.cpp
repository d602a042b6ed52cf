#include "frontier_pilot/patrol/command_line.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Words = std::vector<std::string>;

TEST(PatrolCommandLine, ShapeSideAndLapsInAnyOrderAndSpelling) {
  for (const Words& words :
       {Words{"triangle", "--side", "0.5", "--laps", "3"}, Words{"--laps=3", "triangle", "--side=0.5"},
        Words{"--radius", "0.5", "--laps", "3", "triangle"}}) {
    const patrol::PatrolCommandLine line = patrol::parsePatrolCommandLine(words);
    ASSERT_TRUE(line.goal.has_value()) << line.problem;
    EXPECT_EQ(line.goal->mode, 2.0);
    EXPECT_EQ(line.goal->size, 0.5);
    EXPECT_EQ(line.goal->laps, 3.0);
  }
}

TEST(PatrolCommandLine, DefaultsAreOneMetreAndOneLap) {
  const patrol::PatrolCommandLine line = patrol::parsePatrolCommandLine({"circle"});
  ASSERT_TRUE(line.goal.has_value());
  EXPECT_EQ(line.goal->mode, 3.0);
  EXPECT_EQ(line.goal->size, 1.0);
  EXPECT_EQ(line.goal->laps, 1.0);
}

TEST(PatrolCommandLine, WhatIsWrongIsNamed) {
  const auto problem = [](const Words& words) { return patrol::parsePatrolCommandLine(words).problem; };
  EXPECT_EQ(problem({}), "no shape given: square, triangle or circle");
  EXPECT_EQ(problem({"pentagon"}), "unknown argument: pentagon");
  EXPECT_EQ(problem({"square", "circle"}), "more than one shape: circle");
  EXPECT_EQ(problem({"square", "--side"}), "--side needs a number");
  EXPECT_EQ(problem({"square", "--laps", "two"}), "--laps needs a number, not two");
  EXPECT_EQ(problem({"square", "--side="}), "--side needs a number, not ");
  EXPECT_EQ(problem({"square", "--side", "-1"}), "--side must be above 0 m, not -1");
  EXPECT_EQ(problem({"circle", "--radius=0"}), "--radius must be above 0 m, not 0");
  EXPECT_EQ(problem({"square", "--side", "0.2", "--radius=2"}), "not both --side and --radius");
  EXPECT_EQ(problem({"square", "--side", "inf"}), "--side must be above 0 m, not inf");
  EXPECT_EQ(problem({"square", "--laps", "0"}), "--laps must be a whole number, at least 1, not 0");
  EXPECT_EQ(problem({"square", "--laps", "1.5"}), "--laps must be a whole number, at least 1, not 1.5");
}

TEST(PatrolCommandLine, HelpComesFirst) {
  EXPECT_TRUE(patrol::parsePatrolCommandLine({"--help"}).help);
  EXPECT_TRUE(patrol::parsePatrolCommandLine({"square", "-h"}).help);
}

}  // namespace
}  // namespace frontier_pilot
