// Robots that start anywhere in a building and do not know where from each other: whether the place of the second one
// is found, how soon after the maps overlap, and how exactly.

#include <algorithm>
#include <cstdio>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/fleet/map_merger.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/cpu_time.h"
#include "support/fleet_starts.h"
#include "support/named_limits.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

constexpr const char* kUsage =
    "usage: place_bench [options] WORLD.yaml ...\n"
    "Two robots explore a world, each alone, from starts that the other one does not know. The maps are put together\n"
    "as soon as the second one's place is found; a place that is more than 0.5 m or 5 degrees off is false.\n"
    "  --seeds A-B    seeds of the starts and of the noise (1-3)\n"
    "  --odom-noise   the simulator's odometry noise; the mappers then match scans and close loops\n"
    "  --overlap M2   area that both must know before the time counts, 30\n"
    "  --limit S      of simulated time, 600\n"
    "Exit status 0: no place was false.\n"
    "Example:\n"
    "  place_bench --seeds 1-5 config/worlds/office.yaml\n";

struct Options {
  std::vector<int> seeds = {1, 2, 3};
  bool odom_noise = false;
  double overlap = 30.0;  ///< [m^2]
  double limit = 600.0;   ///< [s]
  std::vector<std::string> worlds;
};

Options parse(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  Options options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    if (word == "--seeds")
      options.seeds = arguments.range();
    else if (word == "--odom-noise")
      options.odom_noise = true;
    else if (word == "--overlap")
      options.overlap = arguments.number();
    else if (word == "--limit")
      options.limit = arguments.number();
    else if (word.rfind("--", 0) == 0)
      throw std::invalid_argument("unknown option " + word);
    else
      options.worlds.push_back(word);
  }
  if (options.worlds.empty()) throw std::invalid_argument("WORLD.yaml is missing");
  return options;
}

/// A place with room for a robot, connected with `first`, in any direction.
Pose2 drawStart(const OccupancyGrid& truth, const Vec2& first, std::mt19937_64& random) {
  constexpr double kRoom = 0.4;                                                   // [m]
  const double anywhere = truth.resolution() * (truth.width() + truth.height());  // [m]
  const std::vector<Cell> places = placesAround(truth, first, kRoom, anywhere);
  const Vec2 place = truth.geometry().centre(places[random() % places.size()]);
  return {place, kPi * (static_cast<double>(random() % 360) / 180.0 - 1.0)};
}

/// Two robots that explore alone, and a merger that looks for the second one's place.
class Run {
 public:
  Run(const Options& options, const std::string& world, int seed) : options_(options), merger_(twoRobots()) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const sim::World drawn = sim::loadWorld(world);
    const sim::Simulator simulator(drawn, {});
    for (int robot = 0; robot < 2; ++robot) {
      sim::World own = drawn;
      const Pose2 start = drawStart(simulator.map(), simulator.startPose(0).position(), random);
      loops_.push_back(std::make_unique<system::ClosedLoop>(std::move(own), parameters(start, 2 * seed + robot)));
    }
    T_one_two_ = loops_[0]->simulator().startPose(0).inverse() * loops_[1]->simulator().startPose(0);
  }

  /// Returns whether no false place was found.
  bool toTheEnd(const std::string& name, int seed) {
    while (!over()) second();
    const auto place = merger_.place(1);
    const Pose2 error = place ? T_one_two_.inverse() * *place : Pose2();
    const double angle = std::abs(error.yaw) * 180.0 / kPi;
    const bool wrong = place && (error.position().norm() > 0.5 || angle > 5.0);
    std::printf("%-14s %4d  overlap %5.1f m2", name.c_str(), seed, overlap_);
    std::printf(enough_ ? " enough at %5.0f s" : "          never   ", enough_.value_or(0.0));
    if (found_) std::printf("  found at %5.0f s with %5.1f m2", *found_, overlap_found_);
    if (place) std::printf("  %.3f m %.2f deg%s", error.position().norm(), angle, wrong ? " FALSE" : "");
    if (!found_) std::printf(enough_ ? "  NOT FOUND" : "  -");
    std::printf("  search %.2f s in %d\n", search_seconds_ / std::max(1, searches_), searches_);
    std::fflush(stdout);
    return !wrong && !was_false_;
  }

 private:
  static constexpr double kAfterwards = 20.0;  ///< how long a place that was found is followed [s]

  static fleet::MapMergerParameters twoRobots() {
    fleet::MapMergerParameters parameters;
    parameters.robots = {{"one", 0.0, 0.0, 0.0}, {"two", 0.0, 0.0, 0.0}};
    parameters.known_starts = false;
    return parameters;
  }

  system::ClosedLoopParameters parameters(const Pose2& start, int seed) const {
    system::ClosedLoopParameters parameters;
    parameters.setLimits(limitsNamed("fast"));
    parameters.simulator.x = start.x;
    parameters.simulator.y = start.y;
    parameters.simulator.yaw = start.yaw;
    parameters.simulator.seed = seed;
    parameters.simulator.odom_noise = options_.odom_noise;
    parameters.mapper.trust_odometry = !options_.odom_noise;
    return parameters;
  }

  bool over() const {
    const double now = toSeconds(loops_[0]->now());
    if (now >= options_.limit) return true;
    if (found_ && enough_) return now > std::max(*found_, *enough_) + kAfterwards;
    return enough_ && now > *enough_ + 60.0;
  }

  void second() {
    for (const auto& loop : loops_) {
      for (int step = 0; step < 100; ++step) loop->step();
    }
    const Time now = loops_[0]->now();
    for (std::size_t robot = 0; robot < 2; ++robot) {
      const OccupancyGrid& map = loops_[robot]->mapper().grid();
      merger_.setMap(robot, map, map.geometry().rect(), now);
    }
    search(now);
    merger_.update(now);
    observe(toSeconds(now));
  }

  void search(Time now) {
    const auto work = merger_.takeWork(now);
    if (!work) return;
    const double begin = threadSeconds();
    const fleet::PlaceFinding finding = (*work)();
    search_seconds_ += threadSeconds() - begin;
    ++searches_;
    merger_.accept(finding, now);
  }

  void observe(double now) {
    overlap_ = fleet::compare(loops_[0]->mapper().grid(), loops_[1]->mapper().grid(), T_one_two_).overlap;
    if (!enough_ && overlap_ >= options_.overlap) enough_ = now;
    const auto place = merger_.place(1);
    if (place && (T_one_two_.inverse() * *place).position().norm() > 0.5) was_false_ = true;
    if (!place || found_) return;
    found_ = now;
    overlap_found_ = overlap_;
  }

  Options options_;
  std::vector<std::unique_ptr<system::ClosedLoop>> loops_;
  fleet::MapMerger merger_;
  Pose2 T_one_two_;
  double overlap_ = 0.0;
  double overlap_found_ = 0.0;
  std::optional<double> enough_;
  std::optional<double> found_;
  bool was_false_ = false;
  double search_seconds_ = 0.0;
  int searches_ = 0;
};

int runAll(const Options& options) {
  bool good = true;
  for (const std::string& world : options.worlds) {
    for (const int seed : options.seeds) {
      const std::string name = world.substr(world.find_last_of('/') + 1);
      good = Run(options, world, seed).toTheEnd(name, seed) && good;
    }
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("place_bench", {argv + 1, argv + argc}, bench::kUsage,
                                           [](const auto& words) { return bench::runAll(bench::parse(words)); });
}
