// The navigator on known maps: how long a fixed list of goals takes, where the time goes that full speed would not
// take, and how near the robot comes to obstacles. The list depends on the world alone, so that two versions of the
// navigator can be compared, which explorations do not allow: there, a robot that drives differently sees other goals.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/grids/distance_field.h"
#include "frontier_pilot/sim/simulator.h"
#include "sim/random.h"
#include "sim/reachable_floor.h"
#include "support/driving_meter.h"
#include "support/floors/driven_robot.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

constexpr std::size_t kGoals = 60;
constexpr double kRadius = 0.2;      ///< of the disc that fits at every goal [m]
constexpr double kLeastAway = 1.0;   ///< from one goal to the next [m]
constexpr double kMostAway = 6.0;    ///< [m]
constexpr double kPatience = 120.0;  ///< for a goal [s]
constexpr double kTick = 0.05;       ///< of test::DrivenRobot [s]

/// Random places that the robot can reach from `start`, each some metres from the one before.
std::vector<Vec2> goalsOn(const OccupancyGrid& map, const Vec2& start) {
  const int cells = static_cast<int>(std::ceil(kRadius / map.resolution()));
  const Grid<std::uint8_t> floor = sim::reachableFloor(map, map.geometry().cellAt(start), cells);
  Grid<std::uint8_t> outside(map.geometry());
  for (std::size_t i = 0; i < map.size(); ++i) outside[i] = floor[i] == 0 ? 1 : 0;
  const grids::DistanceField field(outside, 2.0 * kRadius);
  sim::Random random(1);
  std::vector<Vec2> goals;
  Vec2 last = start;
  constexpr int kDraws = 1000000;
  for (int draw = 0; goals.size() < kGoals; ++draw) {
    if (draw == kDraws) throw std::invalid_argument("the world has no places that are far enough apart");
    const Cell cell{static_cast<int>(random.uniform() * map.width()),
                    static_cast<int>(random.uniform() * map.height())};
    const Vec2 goal = map.geometry().centre(cell);
    const double away = (goal - last).norm();
    if (static_cast<double>(field[cell]) < kRadius || away < kLeastAway || away > kMostAway) continue;
    goals.push_back(goal);
    last = goal;
  }
  return goals;
}

/// Drives to every goal in turn; to every other one only half of the way, as an explorer does that changes its mind.
DrivingReport drive(const sim::World& world, int& contacts) {
  if (!world.start) throw std::invalid_argument("the world has no start");
  const navigation::NavigatorParams params = test::DrivenRobot::fast();
  test::DrivenRobot robot(world.map, *world.start, params);
  DrivingMeter meter(params.robot, robot.simulator().map());
  bool half = false;
  for (const Vec2& goal : goalsOn(world.map, world.start->position())) {
    robot.send(goal);
    half = !half;
    for (double t = 0.0; t < kPatience; t += kTick) {
      robot.tick();
      meter.observe(robot.pose(), robot.simulator().velocity(0), robot.navigator(), robot.output(), kTick);
      if (!robot.navigator().hasGoal()) break;
      if (half && robot.navigator().progress() > 0.5 * robot.navigator().path().length()) break;
    }
  }
  contacts += robot.contacts();
  return meter.report();
}

constexpr const char* kUsage =
    "usage: driving_bench WORLD.yaml ...\n"
    "Drives the navigator to a fixed list of goals on known maps: how long that takes, where the time goes that full\n"
    "speed would not take, and how near the robot comes to obstacles.\n"
    "Exit status 0: without contact.\n"
    "Example:\n"
    "  driving_bench config/worlds/office.yaml\n";

int driveAll(const std::vector<std::string>& paths) {
  if (paths.empty()) throw std::invalid_argument("no world is given");
  for (const std::string& path : paths) {
    if (tools::Arguments::isOption(path)) throw std::invalid_argument("unknown option " + path);
  }
  DrivingReport all;
  int contacts = 0;
  for (const std::string& path : paths) {
    const DrivingReport report = drive(sim::loadWorld(path), contacts);
    std::printf("%s\n%s", std::filesystem::path(path).stem().c_str(), report.text().c_str());
    std::fflush(stdout);
    all.add(report);
  }
  std::printf("all worlds, %d contacts\n%s", contacts, all.text().c_str());
  return contacts == 0 ? 0 : 1;
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("driving_bench", {argv + 1, argv + argc}, bench::kUsage, bench::driveAll);
}
