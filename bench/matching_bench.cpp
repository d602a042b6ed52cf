// What tracking the robot's pose costs, and how far the estimate drifts without loop closures, on the Willow Garage
// floor: 360 beams, 8 m, 1 cm noise, a scan every 5 cm of a tour of all places, and odometry with 5 % noise of distance
// and rotation that drifts by 2 % of the distance and 0.01 rad/m. Set FRONTIER_PILOT_WORLDS to the folder of
// willow_garage.yaml.
//
//   Follow   reading a scan and LocalSlam::update, scan by scan
//   Search   the correlative search alone, in windows of growing half width [cm]
//   Whole    the search of the whole map by the scans of a drive, from 50 random places of each world: how many are
//            found, refused, and wrong (more than 0.3 m or 0.1 rad off). /1: by a single scan; /5: by one every 0.5 m
//            of a drive with 2 % noise of odometry. The floor is one load for each cell of the map and each direction.
//
// The least that a search can cost is to score one pose: one load for each of its `points`. Branch and bound scores
// some hundred nodes; scoring all `poses` of the window would mean thousands to millions.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/sim/simulator.h"
#include "slam/front_end/local_slam.h"
#include "support/benchmark_main.h"
#include "support/buildings.h"
#include "support/cpu_stopwatch.h"
#include "support/willow_tour.h"

const char* const frontier_pilot::bench::kPurpose =
    "What tracking the robot's pose costs, and how far the estimate drifts without loop closures.\n"
    "Worlds: the folder in FRONTIER_PILOT_WORLDS, or else ../shared/worlds.\n";

namespace frontier_pilot {
namespace {

/// Simulated odometry of a drive.
class Wheels {
 public:
  const Pose2& move(const Pose2& step) {
    const double driven = step.position().norm();
    const double turn = step.yaw * (1.0 + 0.05 * noise_(random_)) + 0.01 * driven;
    pose_ = pose_ * Pose2(step.position() * (1.02 + 0.05 * noise_(random_)), turn);
    return pose_;
  }

 private:
  Pose2 pose_;
  std::mt19937 random_{7};
  std::normal_distribution<double> noise_{0.0, 1.0};
};

/// How far estimates drift from the truth.
class Drift {
 public:
  void add(const Pose2& truth, const Pose2& estimate) {
    truth_.push_back(truth);
    estimate_.push_back(estimate);
  }
  /// Reports the mean error of the motion over `scans` scans; `name` is the distance that these cover.
  void report(benchmark::State& state, const std::string& name, std::size_t scans) const {
    double length = 0.0;
    double off = 0.0;
    double turned = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i + scans < truth_.size(); i += scans / 10) {
      const Pose2 wanted = truth_[i].inverse() * truth_[i + scans];
      const Pose2 error = wanted.inverse() * (estimate_[i].inverse() * estimate_[i + scans]);
      for (std::size_t k = i; k < i + scans; ++k) length += (truth_[k + 1].position() - truth_[k].position()).norm();
      off += error.position().norm();
      turned += std::abs(error.yaw);
      count += 1.0;
    }
    state.counters["drift_" + name + "_pct"] = 100.0 * off / length;
    state.counters["drift_" + name + "_deg"] = turned / count * 180.0 / kPi;
  }

 private:
  std::vector<Pose2> truth_;
  std::vector<Pose2> estimate_;
};

void follow(benchmark::State& state) {
  if (bench::tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  const std::vector<Pose2> poses = bench::smoothed(bench::tour()->poses());
  for (auto _ : state) {
    slam::LocalSlam slam;
    Wheels wheels;
    bench::Scanner scanner(bench::tour()->caster());
    bench::Stopwatch watch;
    Drift drift;
    double odometry_only = 0.0;
    double contradicts = 0.0;
    double memory = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const LaserScan2& scan = scanner.at(poses[i]);
      const Pose2 T_odom_base = wheels.move(i == 0 ? Pose2() : poses[i - 1].inverse() * poses[i]);
      slam::LocalSlamOutput output;
      watch.time([&] { output = slam.update(surfaces::readScan(scan), T_odom_base); });
      drift.add(poses[i], output.track.T_local_base.pose);
      if (!slam::isMatched(output.track.verdict)) odometry_only += 1.0;
      if (output.track.verdict == slam::MatchVerdict::kContradicts) contradicts += 1.0;
      for (const auto& submap : output.finished) memory += static_cast<double>(submap->map.memory());
    }
    watch.report(state);
    drift.report(state, "18m", 400);
    drift.report(state, "90m", 2000);
    state.counters["odometry_only"] = odometry_only;
    state.counters["contradicts"] = contradicts;
    state.counters["submaps_MB"] = memory / 1e6;
  }
}
BENCHMARK(follow)->Name("Follow")->Iterations(1)->Unit(benchmark::kMillisecond);

void searchWindow(benchmark::State& state) {
  if (bench::tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  const std::vector<Pose2> poses = bench::smoothed(bench::tour()->poses());
  const double half = static_cast<double>(state.range(0)) / 100.0;
  bench::Scanner scanner(bench::tour()->caster());
  scan_matching::SurfaceMap map;
  constexpr std::size_t kFirst = 3000;
  for (std::size_t i = kFirst; i < kFirst + 100; i += 5)
    map.add(surfaces::filled(surfaces::readScan(scanner.at(poses[i])).points), poses[i]);
  const scan_matching::SearchWindow window{half, half, 0.3};
  const scan_matching::MaxPyramid pyramid(map.field(), scan_matching::pyramidTop(window, 0.05));
  const Pose2 truth = poses[kFirst + 50];
  const surfaces::SurfacePoints points = surfaces::thinned(surfaces::readScan(scanner.at(truth)).points);
  scan_matching::SearchRequest request;
  request.expected = truth * Pose2(0.4 * half, -0.3 * half, 0.1);
  request.window = window;
  for (auto _ : state) benchmark::DoNotOptimize(scan_matching::correlativeSearch(pyramid, points, request));
  state.counters["points"] = static_cast<double>(points.size());
  state.counters["poses"] = std::pow(2.0 * half / 0.05 + 1.0, 2) * 2.0 * 0.3 * 8.0 / 0.05;
}
BENCHMARK(searchWindow)->Name("Search")->Arg(10)->Arg(50)->Arg(200)->Arg(700)->Unit(benchmark::kMicrosecond);

/// The scans of a drive along `poses` from `first` on, with noisy odometry.
class ShortDrive {
 public:
  ShortDrive(const std::vector<Pose2>& poses, std::size_t first, std::size_t scans, bench::Scanner& scanner,
             std::mt19937& random) {
    constexpr std::size_t kApart = 10;  // poses, which are 5 cm apart
    const double turned = std::uniform_real_distribution<double>(-kPi, kPi)(random);
    std::vector<Pose2> odometry;
    for (std::size_t i = 0; i < scans; ++i) {
      const Pose2 at(poses[first + kApart * i].position(), normalizeAngle(poses[first + kApart * i].yaw + turned));
      const Pose2 step = i == 0 ? Pose2() : truth_.inverse() * at;
      std::normal_distribution<double> noise(1.0, 0.02);
      const Pose2 driven(step.position() * noise(random), step.yaw * noise(random));
      odometry.push_back(i == 0 ? Pose2() : odometry.back() * driven);
      scans_.push_back({surfaces::readScan(scanner.at(at)).points, odometry.back()});
      truth_ = at;
    }
    for (localization::RecentScan& scan : scans_) scan.T_last_base = odometry.back().inverse() * scan.T_last_base;
  }
  /// The robot is carried to a pose, which odometry does not show, and takes a scan there.
  void carryTo(const Pose2& pose, bench::Scanner& scanner) {
    scans_.push_back({surfaces::readScan(scanner.at(pose)).points, Pose2()});
    truth_ = pose;
  }
  const Pose2& truth() const { return truth_; }
  const std::vector<localization::RecentScan>& scans() const { return scans_; }

 private:
  std::vector<localization::RecentScan> scans_;
  Pose2 truth_;
};

void searchWorld(benchmark::State& state, const std::string& path) {
  if (!std::filesystem::exists(path)) return state.SkipWithError("no such world");
  sim::World world = sim::loadWorld(path);
  // Unknown cells are solid for the scanner, so a mapper would have mapped them as walls.
  for (std::size_t i = 0; i < world.map.size(); ++i) world.map[i] = isFree(world.map[i]) ? kFree : kOccupied;
  const bench::Tour tour(world.map, world.start ? world.start->position() : Vec2(16.6, 21.6));
  const auto scans = static_cast<std::size_t>(state.range(0));
  constexpr int kPlaces = 50;
  for (auto _ : state) {
    bench::Scanner scanner(tour.caster());
    std::mt19937 random(1);
    bench::Stopwatch watch;
    std::map<std::string, int> counts;
    for (int i = 0; i < kPlaces; ++i) {
      std::uniform_int_distribution<std::size_t> any(0, tour.poses().size() - 10 * scans);
      ShortDrive drive(tour.poses(), any(random), scans, scanner, random);
      if (state.range(1) != 0) drive.carryTo(tour.poses()[any(random)], scanner);
      localization::WholeMapSearch search;
      watch.time([&] { search = localization::searchWholeMap(world.map, drive.scans(), {}); });
      const bool found = search.verdict == localization::SearchVerdict::kFound;
      const bool wrong = found && isJump(drive.truth(), search.best.T_map_base, 0.3, 0.1);
      ++counts[wrong ? "wrong" : found ? "found" : "refused"];
      if (search.verdict == localization::SearchVerdict::kFitsNowhere) ++counts["nowhere"];
    }
    watch.report(state);
    for (const auto& [name, count] : counts) state.counters[name] = count;
  }
}

void ofWorld(benchmark::State& state, const std::string& name) {
  searchWorld(state, FRONTIER_PILOT_SOURCE_DIR "/config/worlds/" + name + ".yaml");
}
void ofWillow(benchmark::State& state) { searchWorld(state, bench::willowGarage()); }

/// With one scan, with five, and with seven after which the robot was carried and took another one.
void setUp(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"scans", "carried"})
      ->Args({1, 0})
      ->Args({5, 0})
      ->Args({7, 1})
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(ofWorld, cave, "cave")->Name("Whole/cave")->Apply(setUp);
BENCHMARK_CAPTURE(ofWorld, flat, "flat")->Name("Whole/flat")->Apply(setUp);
BENCHMARK_CAPTURE(ofWorld, loop, "loop")->Name("Whole/loop")->Apply(setUp);
BENCHMARK_CAPTURE(ofWorld, maze, "maze")->Name("Whole/maze")->Apply(setUp);
BENCHMARK_CAPTURE(ofWorld, office, "office")->Name("Whole/office")->Apply(setUp);
BENCHMARK_CAPTURE(ofWorld, small, "small")->Name("Whole/small")->Apply(setUp);
BENCHMARK(ofWillow)->Name("Whole/willow")->Apply(setUp);

}  // namespace
}  // namespace frontier_pilot
