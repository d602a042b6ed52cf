// What the arbiter may be configured with.
#include <gtest/gtest.h>

#include "frontier_pilot/arbiter/arbiter.h"

namespace frontier_pilot {
namespace {

Problems load(const std::string& yaml, arbiter::ArbiterParameters& parameters) {
  return loadParameters(parseYaml(yaml), parameters);
}

std::string onlyProblem(const std::string& yaml) {
  arbiter::ArbiterParameters parameters;
  const Problems problems = load(yaml, parameters);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

// [ARB-1]
TEST(ArbiterParameters, DefaultsAreTheFiveSourcesOfTheInterface_ARB_1) {
  const arbiter::ArbiterParameters parameters;
  Problems problems;
  parameters.check(problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(parameters.sources.size(), 5U) << "[ARB-1]";
  for (const arbiter::SourceParameters& source : parameters.sources) {
    EXPECT_EQ(source.topic, "cmd_vel_" + source.name);
    EXPECT_EQ(source.timeout, 1.0) << "[ARB-1]";
    EXPECT_TRUE(source.enabled);
    EXPECT_FALSE(source.required);
    EXPECT_EQ(source.zero_means_idle, source.name == "avoid") << "[ARB-3]";
  }
}

// [ARB-1]
TEST(ArbiterParameters, EqualPrioritiesAreRefusedByName_ARB_1) {
  const std::string problem = onlyProblem("sources: [{name: nav}, {name: joy, topic: joy_vel, priority: 60}]");
  EXPECT_NE(problem.find("sources[1]/priority"), std::string::npos) << problem << " [ARB-1]";
  EXPECT_NE(problem.find("'nav'"), std::string::npos) << problem;
}

// [ARB-1]
TEST(ArbiterParameters, ATimeoutThatIsNotPositiveIsRefused_ARB_1) {
  for (const char* timeout : {"0.0", "-1.0", ".nan", ".inf"}) {
    const std::string problem = onlyProblem(std::string("sources: [{name: nav, timeout: ") + timeout + "}]");
    EXPECT_NE(problem.find("sources[0]/timeout"), std::string::npos) << problem << " [ARB-1]";
  }
}

// [ARB-1]
TEST(ArbiterParameters, AnUnknownKeyIsRefused_ARB_1) {
  EXPECT_NE(onlyProblem("surces: []").find("surces"), std::string::npos) << "[ARB-1]";
  EXPECT_NE(onlyProblem("sources: [{name: nav, timout: 1.0}]").find("timout"), std::string::npos) << "[ARB-1]";
}

TEST(ArbiterParameters, AnEntryWithABuiltInNameStartsFromThatSource) {
  arbiter::ArbiterParameters parameters;
  EXPECT_TRUE(load("sources: [{name: avoid, required: true}, {name: nav, timeout: 0.3}]", parameters).empty());
  ASSERT_EQ(parameters.sources.size(), 2U);
  EXPECT_EQ(parameters.sources[0].topic, "cmd_vel_avoid");
  EXPECT_EQ(parameters.sources[0].priority, 100);
  EXPECT_TRUE(parameters.sources[0].zero_means_idle);
  EXPECT_TRUE(parameters.sources[0].required);
  EXPECT_EQ(parameters.sources[1].priority, 60);
  EXPECT_EQ(parameters.sources[1].timeout, 0.3);
}

TEST(ArbiterParameters, TwoSourcesOfOneNameOrTopicAndSourcesOnCmdVelAreRefused) {
  EXPECT_NE(onlyProblem("sources: [{name: a, topic: t, priority: 1}, {name: a, topic: u, priority: 2}]").find("name"),
            std::string::npos);
  EXPECT_NE(onlyProblem("sources: [{name: a, topic: t, priority: 1}, {name: b, topic: t, priority: 2}]").find("topic"),
            std::string::npos);
  EXPECT_NE(onlyProblem("sources: [{name: a, topic: cmd_vel, priority: 1}]").find("cmd_vel"), std::string::npos);
  EXPECT_NE(onlyProblem("sources: [{name: 'a b', topic: t, priority: 1}]").find("name"), std::string::npos);
  EXPECT_NE(onlyProblem("sources: [{name: joy, priority: 1}]").find("topic"), std::string::npos);
  EXPECT_NE(onlyProblem("sources: []").find("at least one"), std::string::npos);
}

TEST(ArbiterParameters, AnArbiterCannotBeMadeFromABadConfiguration) {
  arbiter::ArbiterParameters parameters;
  parameters.sources[1].priority = parameters.sources[0].priority;
  EXPECT_THROW(arbiter::Arbiter{parameters}, std::invalid_argument);
}

}  // namespace
}  // namespace frontier_pilot
