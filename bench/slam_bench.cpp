// Long simulated drives with bad odometry: how far the mapper is from the truth, what it costs, and which loop closures
// it finds. The drive follows the true pose and is the same for every seed; the seed is that of scanner and odometry.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/mapping/mapper.h"
#include "support/closed_loop/faulty_drive.h"
#include "support/cpu_time.h"
#include "support/heap_meter.h"
#include "support/slam_worlds.h"
#include "tools/arguments.h"
#include "tools/log_mapping.h"
#include "tools/map_picture.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

constexpr const char* kUsage =
    "usage: slam_bench [options]\n"
    "Long simulated drives with bad odometry: how far the mapper is from the truth, and which loops it closes.\n"
    "  --world NAME     willow, corridor, open-place, campus or a map_server YAML (config/worlds/loop.yaml)\n"
    "  --seeds A-B      seeds to run (1-5)\n"
    "  --distance M     length of the drive (500)\n"
    "  --fault NAME     none, kidnap, dropout, person, odom-frozen or odom-missing, for a while every 30 s\n"
    "  --odom-noise S   deviation of odometry's scale errors, and of its noise after a metre or radian (0.05)\n"
    "  --odom-drift D   deviation of odometry's constant turn [rad/m] (0.005)\n"
    "  --step M         map only scans that are this far apart (0: all)\n"
    "  --turn RAD       or that the robot has turned this far between (0: all)\n"
    "  --beams N        beams of the scanner (360)\n"
    "  --fov DEG        its field of view (360)\n"
    "  --range M        its range (8)\n"
    "  --rolling        scans are measured beam after beam, 5 times a second, at up to 2.8 rad/s; odometry's noise is\n"
    "                   that of wheels and a gyroscope, see --odom-walk, but its scale errors stay\n"
    "  --odom-walk S    with --rolling: deviation of odometry's noise after a metre or radian (0.001)\n"
    "  --at-once        with --rolling: the same drive, but all beams are measured at once\n"
    "  --skewed         with --rolling: beams are not put where the robot was at their time\n"
    "  --details        what became of scans and of attempts to close loops\n"
    "  --png PREFIX     write a picture of each map: corrected trajectory blue\n"
    "Exit status 0: every seed within 0.10 m and 1 degree, no closure false.\n"
    "Example:\n"
    "  slam_bench --world corridor --seeds 1-3 --distance 200\n";

constexpr double kDegrees = 180.0 / kPi;

struct Options {
  std::string world = "config/worlds/loop.yaml";
  std::vector<int> seeds = {1, 2, 3, 4, 5};
  double distance = 500.0;
  test::SensorFault fault = test::SensorFault::kNone;
  double odom_noise = 0.05;
  double odom_drift = 0.005;
  double odom_walk = 0.001;
  double step = 0.0;
  double turn = 0.0;
  int beams = 0;             ///< 0: the default robot's
  double field_of_view = 0;  ///< [rad]; 0: the default robot's
  double range = 0.0;        ///< [m]; 0: the default robot's
  bool rolling = false, at_once = false, skewed = false;
  std::string png;
  bool details = false;
};

void takeOption(const std::string& word, tools::Arguments& arguments, Options& o) {
  if (word == "--world") return void(o.world = arguments.text());
  if (word == "--seeds") return void(o.seeds = arguments.range());
  if (word == "--distance") return void(o.distance = arguments.number());
  if (word == "--fault") return void(o.fault = test::sensorFaultNamed(arguments.text()));
  if (word == "--odom-noise") return void(o.odom_noise = arguments.number());
  if (word == "--odom-drift") return void(o.odom_drift = arguments.number());
  if (word == "--odom-walk") return void(o.odom_walk = arguments.number());
  if (word == "--step") return void(o.step = arguments.number());
  if (word == "--turn") return void(o.turn = arguments.number());
  if (word == "--beams") return void(o.beams = static_cast<int>(arguments.number()));
  if (word == "--fov") return void(o.field_of_view = arguments.number() / kDegrees);
  if (word == "--range") return void(o.range = arguments.number());
  if (word == "--rolling") return void(o.rolling = true);
  if (word == "--at-once") return void(o.at_once = true);
  if (word == "--skewed") return void(o.skewed = true);
  if (word == "--details") return void(o.details = true);
  if (word == "--png") return void(o.png = arguments.text());
  throw std::invalid_argument("unknown option " + word);
}

Options parse(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  Options options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    takeOption(word, arguments, options);
  }
  return options;
}

constexpr double kMega = 1e-6;
sim::SimulatorParameters simulatorFor(const Options& options, int seed) {
  sim::SimulatorParameters parameters;
  parameters.seed = seed;
  parameters.robot.limits.max_linear = 0.5;
  parameters.robot.limits.max_angular = 1.5;
  if (options.beams > 0) parameters.robot.scanner.beams = options.beams;
  if (options.field_of_view > 0.0) parameters.robot.scanner.field_of_view = options.field_of_view;
  if (options.range > 0.0) parameters.robot.scanner.range_max = options.range;
  if (options.rolling) {
    parameters.robot.limits.max_angular = 2.8;
    parameters.robot.scanner.rate = 5.0;
    parameters.robot.scanner.rolling = !options.at_once;
    if (options.skewed) parameters.robot.scanner.time_increment = 0.0;
  }
  parameters.odom_noise = true;
  sim::OdometryParameters& odometry = parameters.odometry;
  odometry.alpha1 = odometry.alpha3 = options.odom_noise * options.odom_noise;
  odometry.distance_scale = odometry.turn_scale = options.odom_noise;
  odometry.drift = options.odom_drift;
  if (options.rolling)
    odometry.alpha1 = odometry.alpha2 = odometry.alpha3 = odometry.alpha4 = square(options.odom_walk);
  return parameters;
}

constexpr double kFalseDistance = 0.3;          // [m]
constexpr double kFalseAngle = 3.0 / kDegrees;  // [rad]
constexpr double kWantedPosition = 0.10;        // [m]
constexpr double kWantedYaw = 1.0 / kDegrees;   // [rad]

/// CPU times of many calls [s].
class Costs {
 public:
  template <class Call>
  void measure(const Call& call) {
    const double begin = threadSeconds();
    call();
    costs_.push_back(threadSeconds() - begin);
  }
  double sum() const { return std::accumulate(costs_.begin(), costs_.end(), 0.0); }
  double quantile(double share) const {
    std::vector<double> sorted = costs_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }

 private:
  std::vector<double> costs_;
};

/// One drive from start to end.
class Run {
 public:
  Run(const Options& options, int seed)
      : options_(options),
        seed_(seed),
        timing_(simulatorFor(options, seed).robot.scanner),
        drive_(slamWorld(options.world), simulatorFor(options, seed), options.distance, options.fault),
        heap_before_(HeapMeter::inUse()) {
    HeapMeter::restart();
  }

  /// Whether the drive met the targets for position, yaw and false closures.
  bool toTheEnd() {
    while (const LaserScan2* scan = drive_.nextScan()) take(*scan);
    heap_ = kMega * static_cast<double>(HeapMeter::inUse() - heap_before_);
    heap_peak_ = kMega * static_cast<double>(HeapMeter::peak() - heap_before_);
    const tools::MappedDrive mapped = recorder_.drive(mapper_);
    if (!options_.png.empty()) draw(mapped);
    return report(mapped);
  }

 private:
  void take(LaserScan2 scan) {
    if (!isFarEnough()) return;
    timing_.apply(scan);
    placeBeams(drive_.drive().odometry(), ScanReference::kMiddle, scan);
    const std::optional<Pose2> odometry = drive_.T_odom_base(scan.stamp);
    insertions_.measure([&] { mapper_.insert(scan, odometry, scan.stamp); });
    revisions_.measure([&] { mapper_.reviseNow(); });
    if (!odometry) return;
    recorder_.note(mapper_, scan.stamp, *odometry);
    truth_.push_back(drive_.drive().truth().nearest(scan.stamp).value());
  }

  /// Whether the robot has moved far enough, in truth, since the last scan that was mapped.
  bool isFarEnough() {
    const Pose2 at = drive_.T_map_base();
    const bool thinned = options_.step > 0.0 || options_.turn > 0.0;
    const double turn = options_.turn > 0.0 ? options_.turn : 2.0 * kPi;
    const double step = options_.step > 0.0 ? options_.step : std::numeric_limits<double>::infinity();
    if (thinned && mapped_ && !isJump(*mapped_, at, step, turn)) return false;
    mapped_ = at;
    return true;
  }

  std::size_t falseClosures(const tools::MappedDrive& mapped) const {
    const auto truthAt = [&](Time stamp) {
      const auto found = std::find_if(mapped.odometry.begin(), mapped.odometry.end(),
                                      [&](const StampedPose2& entry) { return entry.stamp == stamp; });
      return truth_[static_cast<std::size_t>(found - mapped.odometry.begin())];
    };
    return static_cast<std::size_t>(
        std::count_if(mapped.closures.begin(), mapped.closures.end(), [&](const slam::LoopClosure& closure) {
          const Pose2 really = truthAt(closure.reference_stamp).inverse() * truthAt(closure.keyframe_stamp);
          return isJump(really, closure.T_reference_keyframe, kFalseDistance, kFalseAngle);
        }));
  }

  bool report(const tools::MappedDrive& mapped) const {
    const logs::AbsoluteError raw = logs::absoluteError(tools::posesOf(mapped.odometry), truth_);
    const logs::AbsoluteError online = logs::absoluteError(tools::posesOf(mapped.online), truth_);
    const logs::AbsoluteError final = logs::absoluteError(tools::posesOf(mapped.corrected), truth_);
    const std::size_t wrong = falseClosures(mapped);
    const double cpu = (insertions_.sum() + revisions_.sum()) / toSeconds(drive_.drive().now());
    std::printf(
        "%4d %5.0f %8.2f %6.1f | %6.3f %5.2f %6.3f | %6.3f %5.2f %6.3f | %4zu %5zu | %5.1f %6.2f %6.2f %7.1f | %5.1f "
        "%5.1f\n",
        seed_, drive_.drive().distance(), raw.position_rmse, raw.yaw_rmse * kDegrees, online.position_rmse,
        online.yaw_rmse * kDegrees, online.position_max, final.position_rmse, final.yaw_rmse * kDegrees,
        final.position_max, mapped.closures.size(), wrong, 1e3 * cpu, 1e3 * insertions_.quantile(0.99),
        1e3 * insertions_.quantile(1.0), 1e3 * revisions_.quantile(1.0), heap_, heap_peak_);
    if (options_.details) printVerdicts();
    std::fflush(stdout);
    return final.position_rmse <= kWantedPosition && final.yaw_rmse <= kWantedYaw && wrong == 0;
  }

  void printVerdicts() const {
    std::printf("     ");
    for (const auto& [text, count] : mapper_.correctionCounts()) {
      std::printf(" %s %llu", text.c_str(), static_cast<unsigned long long>(count));
    }
    for (std::size_t i = 0; i < slam::kClosureVerdicts; ++i) {
      const auto verdict = static_cast<slam::ClosureVerdict>(i);
      std::printf("; closures %s %llu", toString(verdict),
                  static_cast<unsigned long long>(mapper_.revisions().attempts[verdict]));
    }
    const auto count = [&](mapping::ScanVerdict verdict) {
      return static_cast<unsigned long long>(mapper_.counts()[verdict]);
    };
    std::printf("; no odometry %llu, no room %llu of %zu scans\n", count(mapping::ScanVerdict::kNoOdometry),
                count(mapping::ScanVerdict::kOutOfBounds), truth_.size());
    const OccupancyGrid& grid = mapper_.grid();
    const auto known = std::count_if(grid.cells().begin(), grid.cells().end(), [](auto v) { return !isUnknown(v); });
    std::printf("      map of %d x %d cells, %.1f million known, in %.1f MB; %zu keyframes\n", grid.width(),
                grid.height(), kMega * static_cast<double>(known), kMega * static_cast<double>(mapper_.map().memory()),
                mapper_.trajectory().size());
  }

  void draw(const tools::MappedDrive& mapped) const {
    tools::MapPicture picture;
    for (const StampedPose2& entry : mapped.corrected) picture.trajectory.push_back(entry.pose.position());
    writePicture(mapper_.grid(), picture, options_.png + std::to_string(seed_) + ".png");
  }

  const Options& options_;
  int seed_;
  BeamTiming timing_;
  test::FaultyDrive drive_;
  std::size_t heap_before_;
  double heap_ = 0.0, heap_peak_ = 0.0;  ///< at the end and at most [MB]
  mapping::Mapper mapper_;
  tools::DriveRecorder recorder_;
  Costs insertions_;
  Costs revisions_;
  std::vector<Pose2> truth_;
  std::optional<Pose2> mapped_;  ///< the true pose at the last scan that was mapped
};

int runAll(const Options& options) {
  std::printf("%s\n", options.world.c_str());
  std::printf(
      "           | odometry RMSE | online [m] [deg] max | final [m] [deg] max  | closures  | CPU, scan, background    "
      "  |\n"
      "seed   [m]      [m]  [deg] |   RMSE  RMSE    max |   RMSE  RMSE    max |  all false |  ms/s    p99    max     "
      "max | heap, peak [MB]\n");
  bool good = true;
  for (const int seed : options.seeds) good = Run(options, seed).toTheEnd() && good;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("slam_bench", {argv + 1, argv + argc}, bench::kUsage,
                                           [](const auto& words) { return bench::runAll(bench::parse(words)); });
}
