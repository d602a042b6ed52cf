// Long simulated drives with bad odometry: how far the mapper is from the truth, what it costs, what closures it finds.
// The drive is led by the truth and the same for every seed; the seed is that of scanner and odometry.

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/logs/trajectory_error.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/tools/arguments.h"
#include "frontier_pilot/tools/log_mapping.h"
#include "frontier_pilot/tools/map_picture.h"
#include "support/closed_loop/faulty_drive.h"
#include "support/slam_worlds.h"

namespace frontier_pilot::bench {
namespace {

constexpr const char* kUsage =
    "usage: slam_bench [options]\n"
    "  --world NAME     willow, corridor or a map_server YAML (config/worlds/loop.yaml)\n"
    "  --seeds A-B      seeds to run (1-5)\n"
    "  --distance M     length of the drive (500)\n"
    "  --fault NAME     none, kidnap, dropout, person, odom-frozen or odom-missing, for a while every 30 s\n"
    "  --odom-noise S   deviation of odometry's scale errors, and of its noise after a metre or radian (0.05)\n"
    "  --odom-drift D   deviation of odometry's constant turn [rad/m] (0.005)\n"
    "  --png PREFIX     write a picture of each map: odometry red, corrected trajectory blue, closures green\n"
    "Exit status 0: every seed within 0.10 m and 1 degree, no closure false.\n";

struct Options {
  std::string world = "config/worlds/loop.yaml";
  std::vector<int> seeds = {1, 2, 3, 4, 5};
  double distance = 500.0;
  test::SensorFault fault = test::SensorFault::kNone;
  double odom_noise = 0.05;
  double odom_drift = 0.005;
  std::string png;
};

void takeOption(const std::string& word, Arguments& arguments, Options& o) {
  if (word == "--world") return void(o.world = arguments.text());
  if (word == "--seeds") return void(o.seeds = arguments.range());
  if (word == "--distance") return void(o.distance = arguments.number());
  if (word == "--fault") return void(o.fault = test::sensorFaultNamed(arguments.text()));
  if (word == "--odom-noise") return void(o.odom_noise = arguments.number());
  if (word == "--odom-drift") return void(o.odom_drift = arguments.number());
  if (word == "--png") return void(o.png = arguments.text());
  throw std::invalid_argument("unknown option " + word);
}

Options parse(const std::vector<std::string>& words) {
  Arguments arguments(words);
  Options options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    takeOption(word, arguments, options);
  }
  return options;
}

double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What is allocated by now [MB].
double heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) * 1e-6;
}

sim::SimulatorParameters simulatorFor(const Options& options, int seed) {
  sim::SimulatorParameters parameters;
  parameters.seed = seed;
  parameters.limits.max_linear = 0.5;
  parameters.limits.max_angular = 1.5;
  parameters.odom_noise = true;
  sim::OdometryParameters& odometry = parameters.odometry;
  odometry.alpha1 = odometry.alpha3 = options.odom_noise * options.odom_noise;
  odometry.distance_scale = odometry.turn_scale = options.odom_noise;
  odometry.drift = options.odom_drift;
  return parameters;
}

/// One drive from the start to its end.
class Run {
 public:
  Run(const Options& options, int seed)
      : options_(options),
        seed_(seed),
        drive_(slamWorld(options.world), simulatorFor(options, seed), options.distance, options.fault),
        heap_before_(heapInUse()) {}

  /// Whether the drive met its mark.
  bool toTheEnd() {
    while (const LaserScan2* scan = drive_.nextScan()) take(*scan);
    return report();
  }

 private:
  static MapperParameters matching() {
    MapperParameters parameters;
    parameters.trust_odometry = false;
    return parameters;
  }
  void take(const LaserScan2& scan) {
    const std::optional<Pose2> odometry = drive_.T_odom_base();
    const double begin = threadSeconds();
    mapper_.insert(scan, odometry, scan.stamp);
    matching_ += threadSeconds() - begin;
    mapper_.reviseNow();
    costs_.push_back(threadSeconds() - begin);
    if (mapper_.revisions().closures != closures_.size()) {
      const auto& closures = mapper_.revisions().last_closures;
      closures_.insert(closures_.end(), closures.begin(), closures.end());
    }
    if (!odometry) return;
    truth_.push_back(drive_.T_map_base());
    odometry_.push_back({scan.stamp, *odometry});
    online_.push_back(mapper_.T_map_odom() * *odometry);
  }

  /// What is known at the end of where the robot was.
  std::vector<Pose2> finalPoses() const {
    Trajectory anchors;
    for (const KeyframePose& keyframe : mapper_.trajectory()) anchors.push_back({keyframe.stamp, keyframe.T_map_base});
    return posesOf(bend(odometry_, anchors));
  }

  Pose2 truthAt(Time stamp) const {
    const auto at = std::find_if(odometry_.begin(), odometry_.end(),
                                 [&](const TrajectoryPose& entry) { return entry.stamp == stamp; });
    return truth_[static_cast<std::size_t>(at - odometry_.begin())];
  }

  /// How many closures join places that are not the same.
  int falseClosures() const {
    int count = 0;
    for (const LoopClosure& closure : closures_) {
      const Pose2 T_submap_keyframe = truthAt(closure.submap_stamp).inverse() * truthAt(closure.keyframe_stamp);
      const Pose2 error = closure.T_submap_keyframe.inverse() * T_submap_keyframe;
      if (error.position().norm() > 0.3 || std::abs(error.yaw) > 0.1) ++count;
    }
    return count;
  }

  bool report() {
    const double heap = heapInUse() - heap_before_;
    std::vector<double> sorted = costs_;
    std::sort(sorted.begin(), sorted.end());
    double sum = 0.0;
    for (const double cost : costs_) sum += cost;
    std::vector<Pose2> odometry;
    for (const TrajectoryPose& entry : odometry_) odometry.push_back(entry.pose);
    const AbsoluteError raw = absoluteError(odometry, truth_);
    const AbsoluteError online = absoluteError(online_, truth_);
    const double degrees = 180.0 / kPi;
    const AbsoluteError final = absoluteError(finalPoses(), truth_);
    const int wrong = falseClosures();
    const double seconds = toSeconds(drive_.drive().now());
    std::printf(
        "%4d %6.0f %8.2f %7.1f | %7.3f %6.2f %7.3f | %7.3f %6.2f %7.3f | %4zu %3d %4zu | "
        "%6.1f %6.1f %6.2f %7.1f %7.1f\n",
        seed_, drive_.drive().distance(), raw.position_rmse, raw.yaw_rmse * degrees, online.position_rmse,
        online.yaw_rmse * degrees, online.position_max, final.position_rmse, final.yaw_rmse * degrees,
        final.position_max, closures_.size(), wrong, static_cast<std::size_t>(mapper_.revisions().rendered),
        1e3 * matching_ / seconds, 1e3 * sum / seconds, 1e3 * sorted[sorted.size() * 99 / 100], 1e3 * sorted.back(),
        heap);
    for (std::size_t i = 0; i < kClosureVerdicts; ++i) {
      const auto verdict = static_cast<ClosureVerdict>(i);
      std::printf("     %s %llu", toString(verdict),
                  static_cast<unsigned long long>(mapper_.revisions().attempts[verdict]));
    }
    for (const auto& [text, count] : mapper_.correctionCounts()) {
      std::printf("  %s %llu", text.c_str(), static_cast<unsigned long long>(count));
    }
    std::printf("\n");
    std::fflush(stdout);
    return final.position_rmse <= 0.10 && final.yaw_rmse * degrees <= 1.0 && wrong == 0;
  }

  const Options& options_;
  int seed_;
  test::FaultyDrive drive_;
  double heap_before_;
  Mapper mapper_{matching()};
  std::vector<double> costs_;  ///< of each scan, second thoughts included [s]
  double matching_ = 0.0;      ///< without them, all together [s]
  std::vector<LoopClosure> closures_;
  std::vector<Pose2> truth_;
  Trajectory odometry_;
  std::vector<Pose2> online_;
};

int runAll(const Options& options) {
  std::printf("%s\n", options.world.c_str());
  std::printf(
      "seed    [m]    odometry        | online: RMSE, max       | final: RMSE, max        | closures, false, rendered "
      "| CPU [ms/s] front, all; p99  max [ms] heap [MB]\n");
  bool good = true;
  for (const int seed : options.seeds) good = Run(options, seed).toTheEnd() && good;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  try {
    return frontier_pilot::bench::runAll(frontier_pilot::bench::parse({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    std::cerr << "slam_bench: " << error.what() << "\n" << frontier_pilot::bench::kUsage;
    return 2;
  }
}
