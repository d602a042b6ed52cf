#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/closed_loop/exploration_meter.h"

namespace frontier_pilot::test {
namespace {

constexpr double kMeterRadius = 0.15;  // [m]
constexpr double kBeside = 0.8;        // [m]: from one start to the other

sim::World load(const std::string& name) {
  return sim::loadWorld(std::string(WORLDS_DIRECTORY) + "/" + name + ".yaml");
}

/// Robots at half a metre a second, that start at `starts`.
system::ClosedLoopParameters team(const std::vector<Pose2>& starts) {
  system::ClosedLoopParameters parameters;
  RobotLimits fast;
  fast.max_linear = 0.5;
  fast.max_angular = 1.5;
  parameters.setLimits(fast);
  for (const Pose2& start : starts) {
    const std::string name = "robot_" + std::to_string(parameters.simulator.robots.size() + 1);
    parameters.simulator.robots.push_back({name, start.x, start.y, start.yaw});
  }
  return parameters;
}

/// What became of one exploration.
struct Outcome {
  double reached = 0.0;   ///< when 97 % of the floor was explored [s]; 0: never
  double explored = 0.0;  ///< share at the end
  bool done = false;
  int contacts = 0;
};

Outcome explore(system::ClosedLoop& loop, double limit) {
  Outcome outcome;
  ExplorationMeter meter(loop.simulator().map(), loop.simulator().startPose(0), kMeterRadius);
  while (!loop.done() && toSeconds(loop.now()) < limit) {
    loop.step();
    if (loop.now().time_since_epoch() % std::chrono::seconds(1) != Duration::zero()) continue;
    outcome.explored = meter.explored(loop.view());
    if (outcome.reached == 0.0 && outcome.explored >= 0.97) outcome.reached = toSeconds(loop.now());
  }
  outcome.done = loop.done();
  for (std::size_t robot = 0; robot < loop.robotCount(); ++robot) {
    outcome.contacts += loop.simulator().contactCount(robot);
  }
  return outcome;
}

// [MUL-1] [MUL-2] [MUL-3]
TEST(Team, OfTwoExploresAnOfficeWithoutContactInThreeQuartersOfTheTimeOfOne_MUL_1_MUL_2_MUL_3) {
  const Pose2 first = load("office").start.value();
  system::ClosedLoop alone(load("office"), team({first}));
  const Outcome one = explore(alone, 1200.0);
  ASSERT_GT(one.reached, 0.0);
  system::ClosedLoop loop(load("office"), team({first, {first.x + kBeside, first.y, 0.0}}));
  const Outcome two = explore(loop, 1200.0);
  EXPECT_TRUE(two.done) << loop.status(0).reason_text << ", " << loop.status(1).reason_text;
  EXPECT_EQ(two.contacts, 0);
  EXPECT_GE(two.explored, 0.99);
  EXPECT_GT(two.reached, 0.0);
  EXPECT_LT(two.reached, 0.75 * one.reached);
}

// [MUL-2]
TEST(Team, FinishesTheShareOfARobotThatDies_MUL_2) {
  const Pose2 first = load("flat").start.value();
  system::ClosedLoop loop(load("flat"), team({first, {first.x + kBeside, first.y, 0.0}}));
  while (toSeconds(loop.now()) < 15.0) loop.step();
  loop.setPowered(1, false);
  const Outcome outcome = explore(loop, 600.0);
  EXPECT_TRUE(outcome.done) << loop.status(0).reason_text;
  EXPECT_GE(outcome.explored, 0.97);
  EXPECT_EQ(outcome.contacts, 0);
}

// [SIM-2] [MUL-2]
TEST(Team, OfTheSameSeedDoesTheSame_SIM_2_MUL_2) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    const Pose2 first = load("flat").start.value();
    system::ClosedLoop loop(load("flat"), team({first, {first.x + kBeside, first.y, 0.0}}));
    while (toSeconds(loop.now()) < 30.0) loop.step();
    hash = loop.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace frontier_pilot::test
