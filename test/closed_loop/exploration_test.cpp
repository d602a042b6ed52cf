#include <gtest/gtest.h>

#include <string>

#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/closed_loop/exploration_meter.h"

namespace frontier_pilot::test {
namespace {

constexpr double kMeterRadius = 0.15;  // [m]

sim::World load(const std::string& name) {
  return sim::loadWorld(std::string(WORLDS_DIRECTORY) + "/" + name + ".yaml");
}

system::ClosedLoopParameters seeded(int seed) {
  system::ClosedLoopParameters parameters;
  parameters.simulator.seed = seed;
  return parameters;
}

/// Explores until DONE, or for `limit` [s] of simulated time.
void explore(system::ClosedLoop& loop, double limit) {
  while (!loop.done() && toSeconds(loop.now()) < limit) loop.step();
}

double exploredShare(system::ClosedLoop& loop) {
  ExplorationMeter meter(loop.simulator().map(), loop.simulator().startPose(0), kMeterRadius);
  return meter.explored(loop.mapper().grid());
}

class EveryWorld : public testing::TestWithParam<const char*> {};

// [EXP-7] [NAV-4] [SIM-3]
TEST_P(EveryWorld, IsExploredToTheEndWithoutContact) {
  system::ClosedLoop loop(load(GetParam()), seeded(1));
  explore(loop, 3600.0);
  EXPECT_TRUE(loop.done()) << loop.status().reason_text;
  EXPECT_EQ(loop.status().reason, exploration::ExplorerReason::kNoReachableFrontier) << loop.status().reason_text;
  EXPECT_GE(exploredShare(loop), 0.99);
  EXPECT_EQ(loop.simulator().contactCount(0), 0);
}
INSTANTIATE_TEST_SUITE_P(Worlds, EveryWorld, testing::Values("flat", "office", "maze", "cave", "loop", "small"));

class LateData : public testing::TestWithParam<const char*> {};

// What is seen, and what is done about it, is a third of a second old, as on a machine that has too much to do. [NAV-4]
TEST_P(LateData, AtHalfAMetreASecondMakesNoContact) {
  system::ClosedLoopParameters parameters = seeded(2);
  RobotLimits fast;
  fast.max_linear = 0.5;
  fast.max_angular = 1.5;
  parameters.setLimits(fast);
  parameters.latency = 0.3;
  system::ClosedLoop loop(load(GetParam()), parameters);
  explore(loop, 3600.0);
  EXPECT_TRUE(loop.done()) << loop.status().reason_text;
  EXPECT_GE(exploredShare(loop), 0.99);
  EXPECT_EQ(loop.simulator().contactCount(0), 0);
}
INSTANTIATE_TEST_SUITE_P(Worlds, LateData, testing::Values("maze", "cave"));

// [EXP-5] [EXP-7]
TEST(Exploration, GoesOnToTheEndWhenTheNavigatorsSourceIsSwitchedOffAndOnAgainAndAgain) {
  system::ClosedLoop loop(load("flat"), seeded(1));
  for (double change = 2.0; !loop.done() && change < 1800.0; change += 7.0) {
    explore(loop, change);
    loop.setNavEnabled(false);
    explore(loop, change + 5.0);
    loop.setNavEnabled(true);
  }
  EXPECT_EQ(loop.status().reason, exploration::ExplorerReason::kNoReachableFrontier) << loop.status().reason_text;
  EXPECT_EQ(loop.status().goals_failed, 0U) << "to be held up is no failure of the goal";
  EXPECT_GE(exploredShare(loop), 0.99);
}

class BoundedWorld : public testing::TestWithParam<const char*> {};

// The bounds are relative to the start, where the map's frame has its origin: 6 m x 6 m with a block to keep out of.
// [EXP-10] [NAV-4]
TEST_P(BoundedWorld, IsExploredInsideAndTheRobotNeverLeaves_EXP_10) {
  system::ClosedLoopParameters parameters = seeded(1);
  parameters.explorer.bounds.stay_within = {-3.0, -3.0, 3.0, -3.0, 3.0, 3.0, -3.0, 3.0};
  parameters.explorer.bounds.keep_out = {{1.0, -0.6, 1.8, -0.6, 1.8, 0.6, 1.0, 0.6}};
  const exploration::ExplorationBounds bounds = parameters.explorer.bounds.polygons();
  system::ClosedLoop loop(load(GetParam()), parameters);
  const Pose2 T_start_world = loop.simulator().startPose(0).inverse();
  int steps_outside = 0;
  while (!loop.done() && toSeconds(loop.now()) < 1200.0) {
    loop.step();
    steps_outside += static_cast<int>(!bounds.contain((T_start_world * loop.simulator().pose(0)).position()));
  }
  EXPECT_EQ(loop.status().reason, exploration::ExplorerReason::kNoReachableFrontier) << loop.status().reason_text;
  EXPECT_EQ(steps_outside, 0);
  EXPECT_GT(loop.status().goals_sent, 0U);
  EXPECT_GT(loop.status().explored_area, 9.0);
  EXPECT_LE(loop.status().explored_area, 36.0);
  EXPECT_EQ(loop.simulator().contactCount(0), 0);
}
INSTANTIATE_TEST_SUITE_P(Worlds, BoundedWorld, testing::Values("flat", "office", "cave", "loop"));

// [SIM-2]
TEST(Exploration, TheSameSeedGivesTheSameHashAndAnotherSeedAnotherOne) {
  std::uint64_t hashes[3];
  const int seeds[3] = {3, 3, 4};
  for (int i = 0; i < 3; ++i) {
    system::ClosedLoopParameters parameters = seeded(seeds[i]);
    parameters.simulator.odom_noise = true;
    parameters.mapper.trust_odometry = false;
    system::ClosedLoop loop(load("small"), parameters);
    explore(loop, 600.0);
    hashes[i] = loop.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace frontier_pilot::test
