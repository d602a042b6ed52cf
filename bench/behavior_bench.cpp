// How exactly patrols return to their start and spins reach their angle, in lockstep with the simulator; as a table.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/behavior/collision_check.h"
#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/patrol/patrol.h"
#include "frontier_pilot/sim/simulator.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot {
namespace {

constexpr double kSide = 16.0;  // of the empty world [m]

sim::Simulator emptyWorld(bool noise, int seed) {
  GridGeometry geometry;
  geometry.width = geometry.height = static_cast<int>(kSide / geometry.resolution);
  sim::World world;
  world.map = OccupancyGrid(geometry, kFree);
  sim::SimulatorParameters parameters;
  parameters.x = parameters.y = 0.5 * kSide;
  parameters.yaw = 0.3;
  parameters.odom_noise = noise;
  parameters.seed = seed;
  return {world, parameters};
}

/// Mean and maximum of absolute values.
struct Figures {
  double sum = 0.0, worst = 0.0;
  int count = 0;

  void add(double value) {
    sum += std::abs(value);
    worst = std::max(worst, std::abs(value));
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0.0; }
};

void run(sim::Simulator& simulator, const Twist2& command, double seconds) {
  simulator.setCommand(0, command);
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 100.0)); ++i) simulator.step();
}

/// Drives one patrol; false if it was not completed.
bool patrolOnce(sim::Simulator& simulator, const patrol::PatrolOrder& order, double frequency) {
  patrol::PatrolParameters parameters;
  parameters.frequency = frequency;
  patrol::Patrol patrol(parameters);
  patrol.start(order, simulator.now());
  patrol::PatrolOutput output;
  while (patrol.active()) {
    patrol::PatrolInputs inputs;
    inputs.odometry = MotionSample{simulator.now(), simulator.odometry(0), simulator.velocity(0)};
    output = patrol.update(inputs, simulator.now());
    run(simulator, output.command.value_or(Twist2()), 1.0 / frequency);
  }
  run(simulator, {}, 0.5);
  return output.outcome == patrol::PatrolOutcome::kCompleted;
}

void tabulatePatrols(bool noise, int seeds) {
  for (const patrol::PatrolShape shape :
       {patrol::PatrolShape::kSquare, patrol::PatrolShape::kTriangle, patrol::PatrolShape::kCircle}) {
    for (const double frequency : {10.0, 20.0}) {
      Figures distance, angle;
      for (int seed = 1; seed <= seeds; ++seed) {
        sim::Simulator simulator = emptyWorld(noise, seed);
        const Pose2 start = simulator.pose(0);
        if (!patrolOnce(simulator, {static_cast<double>(shape), 1.0, 1.0}, frequency)) std::printf("not completed!\n");
        distance.add((simulator.pose(0).position() - start.position()).norm());
        angle.add(angleDifference(simulator.pose(0).yaw, start.yaw));
      }
      const double degree = kPi / 180.0;
      std::printf("| %-8s 1 m | %2.0f Hz | %-9s | %3d | %7.2f | %7.2f | %6.3f | %6.3f |\n", toString(shape), frequency,
                  noise ? "noisy" : "noiseless", distance.count, distance.mean() * 1e3, distance.worst * 1e3,
                  angle.mean() / degree, angle.worst / degree);
    }
  }
}

/// The costmap that a behaviour looks ahead in, and the time that inserting scans into it takes.
struct Eyes {
  behavior::CollisionCheck around{behavior::CollisionCheckParameters()};
  std::chrono::duration<double> spent{};
  int scans = 0;

  void look(const sim::Simulator& simulator) {
    const LaserScan2* scan = simulator.newScan(0);
    if (scan == nullptr) return;
    const auto begin = std::chrono::steady_clock::now();
    around.insert(*scan, simulator.odometry(0));
    spent += std::chrono::steady_clock::now() - begin;
    ++scans;
  }
};

void step(sim::Simulator& simulator, Eyes& eyes, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 100.0)); ++i) {
    simulator.step();
    eyes.look(simulator);
  }
}

void tabulateSpins(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  sim::Simulator simulator = emptyWorld(false, 1);
  Eyes eyes;
  Figures error;
  std::chrono::duration<double> thought{};
  int cycles = 0;
  step(simulator, eyes, 0.5);
  for (int i = 0; i < count; ++i) {
    behavior::TimedBehavior behavior((behavior::BehaviorParameters()));
    const double target = angle(random);
    const double start = simulator.pose(0).yaw;
    behavior.start({behavior::BehaviorKind::kSpin, target, 0.0, 0.0, true}, simulator.now());
    behavior::BehaviorOutput output;
    while (behavior.active()) {
      const auto begin = std::chrono::steady_clock::now();
      behavior::BehaviorInputs inputs;
      inputs.pose = StampedPose2{simulator.now(), simulator.odometry(0)};
      inputs.look_ahead = eyes.around.lookAhead(0.5, simulator.now());
      output = behavior.update(inputs, simulator.now());
      thought += std::chrono::steady_clock::now() - begin;
      ++cycles;
      simulator.setCommand(0, output.command.value_or(Twist2()));
      step(simulator, eyes, 0.1);
    }
    if (output.outcome != behavior::BehaviorOutcome::kSucceeded)
      std::printf("not succeeded: %s\n", output.message.c_str());
    step(simulator, eyes, 0.5);
    error.add(angleDifference(simulator.pose(0).yaw, start + target));
  }
  std::printf("\n%d random spins at 10 Hz: final yaw error mean %.4f rad, worst %.4f rad\n", count, error.mean(),
              error.worst);
  std::printf("a cycle with its look-ahead takes %.1f us, a scan into the costmap %.1f us\n",
              1e6 * thought.count() / cycles, 1e6 * eyes.spent.count() / eyes.scans);
}

int tabulateAll(const std::vector<std::string>& words) {
  int seeds = 50;
  tools::Arguments arguments(words);
  while (!arguments.atEnd()) {
    if (const std::string word = arguments.next(); word != "--seeds")
      throw std::invalid_argument("unknown argument " + word);
    seeds = arguments.integer();
  }
  std::printf("| closing error | cycles | odometry | runs | mean mm | worst mm | mean deg | worst deg |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  tabulatePatrols(false, 1);
  tabulatePatrols(true, seeds);
  tabulateSpins(200);
  return 0;
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  constexpr const char* kUsage =
      "usage: behavior_bench [--seeds N]\n"
      "How exactly patrols return to their start and spins reach their angle, in lockstep with the simulator; a "
      "table.\n"
      "  --seeds N  of the runs with noise (50)\n"
      "Example:\n"
      "  behavior_bench --seeds 10\n";
  return frontier_pilot::tools::runProgram("behavior_bench", {argv + 1, argv + argc}, kUsage,
                                           frontier_pilot::tabulateAll);
}
