// The closed loop in one process: how long it takes to explore each world, how far the robot drives, and what CPU time
// that costs.

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/closed_loop/exploration_meter.h"
#include "support/closed_loop/standing_watch.h"
#include "support/cpu_time.h"
#include "support/driving_meter.h"
#include "support/explore_options.h"
#include "support/explore_report.h"
#include "support/explore_usage.h"
#include "support/omniscient_tour.h"
#include "support/progress_track.h"
#include "support/svg.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

/// The length of a tour that sees the floor of `world` and knows it beforehand [m].
double omniscientLength(const ExploreOptions& options, const std::string& world) {
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
  Run(const ExploreOptions& options, const std::string& world, int seed)
      : options_(options),
        loop_(sim::loadWorld(world), parametersFor(options, world, seed), threadSeconds),
        meter_(loop_.simulator().map(), loop_.simulator().startPose(0), floorRadius(robotOf(options))),
        driving_(robotOf(options), loop_.simulator().map()),
        svg_(options.svg.empty() ? "" : svgPath(options.svg, world, seed)),
        tracks_(loop_.robotCount()),
        contacts_(loop_.robotCount(), 0),
        standing_(loop_.robotCount()) {
    report_.world = std::filesystem::path(world).stem().string();
    report_.seed = seed;
    report_.area = meter_.area();
  }

  const DrivingReport& driving() const { return driving_.report(); }

  const ExploreReport& toTheEnd() {
    const double begin = threadSeconds();
    while (!finished()) {
      loop_.setPowered(loop_.robotCount() - 1, !isOff(loop_.robotCount() - 1));
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
    return (loop_.done() && !returns()) || report_.explored >= options_.until ||
           toSeconds(loop_.now()) >= options_.limit;
  }

  /// Whether a robot that is off will be switched on again.
  bool returns() const { return isOff(loop_.robotCount() - 1) && std::isfinite(options_.off_until); }

  /// Whether it is switched off now, as `--off` says of the last robot.
  bool isOff(std::size_t robot) const {
    const double t = toSeconds(loop_.now());
    return robot + 1 == loop_.robotCount() && t >= options_.off_from && t < options_.off_until;
  }

  void follow() {
    if (options_.driving) {
      driving_.observe(loop_.simulator().pose(0), loop_.simulator().velocity(0), loop_.navigator(), loop_.navigation(),
                       toSeconds(sim::Simulator::kStep));
    }
    for (std::size_t robot = 0; robot < loop_.robotCount(); ++robot) followRobot(robot);
    if (options_.curve) {
      truth_.push_back(truePose());
      estimates_.push_back(estimatedPose());
    }
  }

  void followRobot(std::size_t robot) {
    const sim::Simulator& simulator = loop_.simulator();
    const Vec2 position = simulator.pose(robot).position();
    if (robot == last_.size()) last_.push_back(position);
    report_.distance += (position - last_[robot]).norm();
    last_[robot] = position;
    const int more = simulator.contactCount(robot) - contacts_[robot];
    if (options_.log && more > 0) {
      std::printf("    %.2f contact%s at (%.2f, %.2f)\n", toSeconds(loop_.now()), nameOf(robot).c_str(), position.x(),
                  position.y());
    }
    const bool drives = loop_.status(robot).state == exploration::ExplorerState::kNavigating;
    const bool has_reason = !drives || isOff(robot) || !loop_.navigation(robot).traffic.empty();
    standing_[robot].observe(simulator.pose(robot), has_reason, loop_.now());
    contacts_[robot] += more;
    report_.contacts += more;
  }

  /// Empty for a robot that is alone.
  std::string nameOf(std::size_t robot) { return loop_.robotCount() > 1 ? " " + loop_.simulator().name(robot) : ""; }

  void sample() {
    const double begin = threadSeconds();
    const double t = toSeconds(loop_.now());
    report_.explored = meter_.explored(loop_.view());
    report_.reach(report_.explored, t);
    for (std::size_t robot = 0; robot < loop_.robotCount(); ++robot) {
      tracks_[robot].points.push_back(loop_.simulator().startPose(0).inverse() *
                                      loop_.simulator().pose(robot).position());
      for (const std::string& line : loop_.takeLog(robot)) {
        if (options_.log) std::printf("   %s %s\n", nameOf(robot).c_str(), line.c_str());
      }
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
  Pose2 mapperError() { return truePose().inverse() * estimatedPose(); }
  Pose2 truePose() { return loop_.simulator().startPose(0).inverse() * loop_.simulator().pose(0); }
  Pose2 estimatedPose() { return loop_.mapper().T_map_odom() * loop_.simulator().odometry(0); }

  void conclude(double cpu) {
    if (options_.curve) {
      std::printf("%s\n", progress_.text().c_str());
      const logs::AbsoluteError error = logs::absoluteError(estimates_, truth_);
      std::printf("    the mapper's pose, RMS over the run: %.1f mm, %.2f deg\n", 1e3 * error.position_rmse,
                  error.yaw_rmse * 180.0 / kPi);
    }
    for (std::size_t robot = 0; options_.log && robot < loop_.robotCount(); ++robot) {
      std::printf("   %s %s\n", nameOf(robot).c_str(), loop_.explorer(robot).explain().c_str());
    }
    report_.simulated = toSeconds(loop_.now());
    report_.cpu = cpu;
    report_.times = loop_.times();
    report_.wrong = meter_.wrong(loop_.view());
    report_.hash = loop_.hash();
    bool complete = loop_.done();
    for (std::size_t robot = 0; robot < loop_.robotCount(); ++robot) {
      if (loop_.robotCount() > 1)
        report_.standing = std::max(report_.standing.value_or(0.0), standing_[robot].longest());
      report_.decisions += static_cast<int>(loop_.status(robot).goals_sent);
      const bool is_done = loop_.status(robot).reason == exploration::ExplorerReason::kNoReachableFrontier;
      complete = complete && (is_done || isOff(robot));
    }
    report_.ended_well = complete || report_.explored >= options_.until;
    report_.end = loop_.done() ? toString(loop_.status().reason) : "not done";
    if (!svg_.empty()) std::ofstream(svg_) << drawSvg(loop_.view(), tracks_, report_.text());
  }

  const ExploreOptions& options_;
  system::ClosedLoop loop_;
  test::ExplorationMeter meter_;
  DrivingMeter driving_;
  std::string svg_;
  ExploreReport report_;
  ProgressTrack progress_;
  std::vector<Pose2> truth_, estimates_;  ///< of the pose of the first robot, in the frame of its start
  std::vector<SvgTrack> tracks_;          ///< by robot, as are the next two
  std::vector<int> contacts_;
  std::vector<test::StandingWatch> standing_;
  std::vector<Vec2> last_;
  std::string last_remark_;
  double metering_ = 0.0;
};

int runAll(const ExploreOptions& options) {
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
  return frontier_pilot::tools::runProgram(
      "explore_bench", {argv + 1, argv + argc}, bench::kUsage,
      [](const auto& words) { return bench::runAll(bench::parseExploreOptions(words)); });
}
