// The closed loop in one process: how long it takes to explore each world, how far the robot drives, and what CPU time
// that costs.

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/closed_loop/exploration_meter.h"
#include "support/cpu_time.h"
#include "support/driving_meter.h"
#include "support/explore_report.h"
#include "support/explore_usage.h"
#include "support/named_limits.h"
#include "support/named_robot.h"
#include "support/omniscient_tour.h"
#include "support/progress_track.h"
#include "support/svg.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

struct Options {
  std::vector<std::string> worlds;
  std::vector<int> seeds = {1, 2, 3, 4, 5};
  std::string robot, limits;  ///< empty: the default robot, and the limits of the robot
  std::string strategy = "tour";
  std::optional<Pose2> start;
  double until = 2.0, limit = 7200.0, latency = 0.0;
  bool at_once = false, skewed = false, odom_noise = false, curve = false, log = false, twice = false,
       omniscient = false, driving = false, decisions = false;
  std::string svg;
};

Pose2 poseOf(tools::Arguments& arguments) {
  const double x = arguments.number();
  const double y = arguments.number();
  return {x, y, arguments.number()};
}

void takeWord(const std::string& word, tools::Arguments& arguments, Options& o) {
  if (word == "--seeds") return void(o.seeds = arguments.range());
  if (word == "--robot") return void(o.robot = arguments.text());
  if (word == "--limits") return void(o.limits = arguments.text());
  if (word == "--strategy") return void(o.strategy = arguments.text());
  if (word == "--start") return void(o.start = poseOf(arguments));
  if (word == "--until") return void(o.until = arguments.number());
  if (word == "--limit") return void(o.limit = arguments.number());
  if (word == "--latency") return void(o.latency = arguments.number());
  if (word == "--at-once") return void(o.at_once = true);
  if (word == "--skewed") return void(o.skewed = true);
  if (word == "--odom-noise") return void(o.odom_noise = true);
  if (word == "--curve") return void(o.curve = true);
  if (word == "--driving") return void(o.driving = true);
  if (word == "--decisions") return void(o.decisions = true);
  if (word == "--log") return void(o.log = true);
  if (word == "--twice") return void(o.twice = true);
  if (word == "--omniscient") return void(o.omniscient = true);
  if (word == "--svg") return void(o.svg = arguments.text());
  if (tools::Arguments::isOption(word)) throw std::invalid_argument("unknown option " + word);
  o.worlds.push_back(word);
}

Options parse(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  Options options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    takeWord(word, arguments, options);
  }
  if (options.latency < 0.0) throw std::invalid_argument("--latency must not be negative");
  if (options.worlds.empty()) throw std::invalid_argument("no world given");
  return options;
}

RobotModel robotOf(const Options& options) {
  RobotModel robot = robotNamed(options.robot);
  if (!options.limits.empty()) robot.limits = limitsNamed(options.limits);
  if (options.at_once) robot.scanner.rolling = false;
  if (options.skewed) robot.scanner.time_increment = 0.0;
  return robot;
}

/// The clearance on either side of the robot with which floor still counts as reachable [m].
constexpr double kRoomBeside = 0.045;

system::ClosedLoopParameters parametersFor(const Options& options, const std::string& world, int seed) {
  system::ClosedLoopParameters parameters;
  parameters.setRobot(robotOf(options));
  parameters.simulator.world = world;
  parameters.simulator.seed = seed;
  parameters.simulator.odom_noise = options.odom_noise;
  parameters.mapper.trust_odometry = !options.odom_noise;
  // What is seen from the start anchors the map: the mapper observes it for a while before the robot leaves.
  constexpr double kLook = 2.0;  // [s]
  if (options.odom_noise) parameters.head_start = kLook;
  parameters.explorer.strategy = options.strategy;
  parameters.latency = options.latency;
  if (options.start) {
    parameters.simulator.x = options.start->x;
    parameters.simulator.y = options.start->y;
    parameters.simulator.yaw = options.start->yaw;
  }
  return parameters;
}

/// The radius of the disc that reaches the floor which counts [m].
double floorRadius(const RobotModel& robot) { return robot.drivenOutline().halfWidth() + kRoomBeside; }

/// The length of a tour that sees the floor of `world` and knows it beforehand [m].
double omniscientLength(const Options& options, const std::string& world) {
  const sim::Simulator simulator(sim::loadWorld(world), parametersFor(options, world, 1).simulator);
  const RobotModel robot = robotOf(options);
  TourTask task;
  task.radius = floorRadius(robot);
  task.range = robot.scanner.range_max;
  return omniscientTour(simulator.map(), simulator.startPose(0).position(), task).length;
}

/// One exploration from start to end.
class Run {
 public:
  Run(const Options& options, const std::string& world, int seed)
      : options_(options),
        loop_(sim::loadWorld(world), parametersFor(options, world, seed), threadSeconds),
        meter_(loop_.simulator().map(), loop_.simulator().startPose(0), floorRadius(robotOf(options))),
        driving_(robotOf(options), loop_.simulator().map()),
        svg_(options.svg.empty() ? "" : svgPath(options.svg, world, seed)) {
    report_.world = std::filesystem::path(world).stem().string();
    report_.seed = seed;
    report_.area = meter_.area();
  }

  const DrivingReport& driving() const { return driving_.report(); }

  const ExploreReport& toTheEnd() {
    const double begin = threadSeconds();
    while (!finished()) {
      loop_.step();
      follow();
      if (loop_.now().time_since_epoch() % kSample == Duration::zero()) sample();
    }
    sample();
    conclude(threadSeconds() - begin - metering_);
    return report_;
  }

 private:
  static constexpr Duration kSample = std::chrono::seconds(1);

  static std::string svgPath(const std::string& directory, const std::string& world, int seed) {
    std::filesystem::create_directories(directory);
    return directory + "/" + std::filesystem::path(world).stem().string() + "_" + std::to_string(seed) + ".svg";
  }

  bool finished() const {
    return loop_.done() || report_.explored >= options_.until || toSeconds(loop_.now()) >= options_.limit;
  }

  void follow() {
    const Vec2 position = loop_.simulator().pose(0).position();
    if (options_.driving) {
      driving_.observe(loop_.simulator().pose(0), loop_.simulator().velocity(0), loop_.navigator(), loop_.navigation(),
                       toSeconds(sim::Simulator::kStep));
    }
    if (last_) report_.distance += (position - *last_).norm();
    last_ = position;
    const int contacts = loop_.simulator().contactCount(0);
    if (options_.log && contacts > report_.contacts) {
      std::printf("    %.2f contact at (%.2f, %.2f)\n", toSeconds(loop_.now()), position.x(), position.y());
    }
    report_.contacts = contacts;
  }

  void sample() {
    const double begin = threadSeconds();
    const double t = toSeconds(loop_.now());
    report_.explored = meter_.explored(loop_.mapper().grid());
    report_.reach(report_.explored, t);
    track_.points.push_back(loop_.simulator().startPose(0).inverse() * loop_.simulator().pose(0).position());
    for (const std::string& line : loop_.takeLog()) {
      if (options_.log) std::printf("    %s\n", line.c_str());
    }
    if (options_.log) logMapper();
    progress_.add(t, loop_.status());
    if (options_.curve && static_cast<int>(t) % 10 == 0) {
      const Pose2 error = mapperError();
      std::printf("    t %6.0f s  explored %.4f  distance %7.1f m  off by %.3f m, %.2f deg\n", t, report_.explored,
                  report_.distance, error.position().norm(), error.yaw * 180.0 / kPi);
    }
    metering_ += threadSeconds() - begin;
  }

  /// Prints the mapper's remark about its scans whenever it changes, with the error of its pose.
  void logMapper() {
    const mapping::Mapper& mapper = loop_.mapper();
    const auto remark = mapper.remark(loop_.now());
    std::string text = std::to_string(mapper.revisions().closures) + " loops closed";
    if (remark) text += ", " + remark->text;
    if (text == last_remark_) return;
    last_remark_ = text;
    const Pose2 error = mapperError();
    std::printf("    %.2f mapper: %s; off by %.3f m, %.2f deg\n", toSeconds(loop_.now()), text.c_str(),
                error.position().norm(), error.yaw * 180.0 / kPi);
  }

  /// The robot's pose as the mapper estimates it, in the frame of its true pose.
  Pose2 mapperError() {
    const sim::Simulator& simulator = loop_.simulator();
    const Pose2 T_map_base = simulator.startPose(0).inverse() * simulator.pose(0);
    return T_map_base.inverse() * loop_.mapper().T_map_odom() * simulator.odometry(0);
  }

  void conclude(double cpu) {
    if (options_.curve) std::printf("%s\n", progress_.text().c_str());
    if (options_.log) std::printf("    %s\n", loop_.explorer().explain().c_str());
    report_.simulated = toSeconds(loop_.now());
    report_.cpu = cpu;
    report_.times = loop_.times();
    report_.wrong = meter_.wrong(loop_.mapper().grid());
    report_.decisions = static_cast<int>(loop_.status().goals_sent);
    report_.hash = loop_.hash();
    const bool complete = loop_.done() && loop_.status().reason == exploration::ExplorerReason::kNoReachableFrontier;
    report_.ended_well = complete || report_.explored >= options_.until;
    report_.end = loop_.done() ? toString(loop_.status().reason) : "not done";
    if (!svg_.empty()) std::ofstream(svg_) << drawSvg(loop_.mapper().grid(), {track_}, report_.text());
  }

  const Options& options_;
  system::ClosedLoop loop_;
  test::ExplorationMeter meter_;
  DrivingMeter driving_;
  std::string svg_;
  ExploreReport report_;
  SvgTrack track_;
  ProgressTrack progress_;
  std::optional<Vec2> last_;
  std::string last_remark_;
  double metering_ = 0.0;
};

int runAll(const Options& options) {
  bool good = true;
  DrivingReport driving;
  std::printf("%s\n", ExploreReport::header(options.omniscient).c_str());
  for (const std::string& world : options.worlds) {
    std::optional<double> tour;
    if (options.omniscient) tour = omniscientLength(options, world);
    for (const int seed : options.seeds) {
      Run run(options, world, seed);
      ExploreReport report = run.toTheEnd();
      report.tour = tour;
      std::printf("%s\n", report.text().c_str());
      if (options.driving) std::printf("%s", run.driving().text().c_str());
      if (options.decisions) std::printf("    %s\n", report.decisionText().c_str());
      driving.add(run.driving());
      std::fflush(stdout);
      good = good && report.ended_well && report.contacts == 0;
      if (options.twice && Run(options, world, seed).toTheEnd().hash != report.hash) {
        std::printf("    the second run has another hash\n");
        good = false;
      }
    }
  }
  if (options.driving) std::printf("all runs\n%s", driving.text().c_str());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("peak memory %.0f MiB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  return good ? 0 : 1;
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("explore_bench", {argv + 1, argv + argc}, bench::kUsage,
                                           [](const auto& words) { return bench::runAll(bench::parse(words)); });
}
