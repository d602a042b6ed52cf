// What a scan costs the mapper on the Willow Garage floor: 360 beams, 8 m, 1 cm noise, a scan every 5 cm of a tour that
// comes within 2 m of every reachable place. Set FRONTIER_PILOT_WORLDS to the folder of willow_garage.yaml.
//
//   Exploring   the first tour through an empty map: 0.5 m/s at 10 Hz
//   Mapped      the same tour once more, through a map that is complete
//   Fresh       single scans, each into an empty map: the worst case
//
// `cells` is the mean number of cells that the beams of a scan pass through, and so the floor: one load for each.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "frontier_pilot/core/distance_field.h"
#include "frontier_pilot/core/ray_casting.h"
#include "frontier_pilot/mapping/map_io.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {
namespace {

constexpr double kRange = 8.0;

OccupancyGrid loadWillow() {
  const char* folder = std::getenv("FRONTIER_PILOT_WORLDS");
  OccupancyGrid map;
  loadGrid(std::string(folder != nullptr ? folder : "../shared/worlds") + "/willow_garage.yaml", map);
  return map;
}

/// A floor, and a tour through it.
class Tour {
 public:
  explicit Tour(const OccupancyGrid& map) : solid_(map.geometry()) {
    for (std::size_t i = 0; i < map.size(); ++i) solid_[i] = map[i] == kFree ? 0 : 1;
    caster_ = RayCaster(solid_);
    distance_ = DistanceField(solid_, 0.5);
    drive(map.geometry().cellAt({16.6, 21.6}));
  }

  const std::vector<Pose2>& poses() const { return poses_; }
  const RayCaster& caster() const { return caster_; }

 private:
  bool isPassable(Cell c) const { return distance_.at(c) > 0.3; }

  /// From the start always to the nearest lattice point not visited yet, until none can be reached.
  void drive(Cell at) {
    Grid<std::uint8_t> visited(solid_.geometry(), 0);
    while (true) {
      visit(visited, at);
      const std::vector<Cell> leg = pathToUnvisited(visited, at);
      if (leg.empty()) return;
      for (std::size_t i = 1; i < leg.size(); ++i) addPose(leg[i - 1], leg[i]);
      at = leg.back();
    }
  }
  static void visit(Grid<std::uint8_t>& visited, Cell at) {
    constexpr int kNear = 40;
    const CellRect near = CellRect{at.x, at.y, 1, 1}.grown(kNear).intersection(visited.geometry().rect());
    for (int y = near.y; y < near.y + near.height; ++y) {
      std::fill_n(visited.row(y) + near.x, near.width, std::uint8_t{1});
    }
  }
  std::vector<Cell> pathToUnvisited(const Grid<std::uint8_t>& visited, Cell from) const {
    Grid<int> parent(solid_.geometry(), -1);
    std::deque<Cell> queue = {from};
    parent[from] = static_cast<int>(solid_.geometry().index(from));
    while (!queue.empty()) {
      const Cell at = queue.front();
      queue.pop_front();
      if (visited[at] == 0) return trace(parent, at, from);
      for (const Cell next : {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1}, Cell{at.x, at.y - 1}}) {
        if (!isPassable(next) || parent[next] >= 0) continue;
        parent[next] = static_cast<int>(solid_.geometry().index(at));
        queue.push_back(next);
      }
    }
    return {};
  }
  static std::vector<Cell> trace(const Grid<int>& parent, Cell at, Cell from) {
    std::vector<Cell> path = {at};
    while (path.back() != from) path.push_back(parent.geometry().cell(static_cast<std::size_t>(parent[path.back()])));
    std::reverse(path.begin(), path.end());
    return path;
  }
  void addPose(Cell from, Cell to) {
    poses_.emplace_back(solid_.geometry().centre(to), bearing(Vec2(to.x - from.x, to.y - from.y)));
  }

  Grid<std::uint8_t> solid_;
  RayCaster caster_;
  DistanceField distance_;
  std::vector<Pose2> poses_;
};

const Tour* tour() {
  static const OccupancyGrid map = loadWillow();
  static const Tour whole =
      map.empty() ? Tour(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 1000, 1000}, kOccupied)) : Tour(map);
  return map.empty() ? nullptr : &whole;
}

class Scanner {
 public:
  explicit Scanner(const RayCaster& caster) : caster_(caster) {
    scan_.angle_min = -kPi;
    scan_.angle_increment = 2.0 * kPi / 360.0;
    scan_.range_min = 0.12;
    scan_.range_max = kRange;
    scan_.ranges.resize(360);
  }
  const LaserScan2& at(const Pose2& pose) {
    scan_.stamp += fromSeconds(0.1);
    for (std::size_t i = 0; i < scan_.ranges.size(); ++i) {
      const double range = caster_.cast(pose.position(), pose.yaw + scan_.angle(i), kRange);
      scan_.ranges[i] = static_cast<float>(range < kRange ? range + noise_(random_) : range + 1.0);
    }
    return scan_;
  }

 private:
  const RayCaster& caster_;
  LaserScan2 scan_;
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_{0.0, 0.01};
};

/// The CPU time of this thread [us]: what else the machine does is none of our business.
double cpuMicros() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

/// Times insertions one by one.
class Stopwatch {
 public:
  void insert(Mapper& mapper, const LaserScan2& scan, const Pose2& pose) {
    const double start = cpuMicros();
    benchmark::DoNotOptimize(mapper.insert(scan, pose, scan.stamp));
    micros_.push_back(cpuMicros() - start);
  }
  void report(benchmark::State& state) {
    std::sort(micros_.begin(), micros_.end());
    double sum = 0.0;
    for (const double t : micros_) sum += t;
    state.counters["scans"] = static_cast<double>(micros_.size());
    state.counters["mean_us"] = sum / static_cast<double>(micros_.size());
    state.counters["p50_us"] = micros_[micros_.size() / 2];
    state.counters["p99_us"] = micros_[micros_.size() * 99 / 100];
    state.counters["max_us"] = micros_.back();
  }

 private:
  std::vector<double> micros_;
};

double cellsPassed(const LaserScan2& scan, const Pose2& pose, const GridGeometry& geometry) {
  double cells = 0.0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = std::min(kRange, static_cast<double>(scan.ranges[i]));
    visitCells(geometry, pose.position(), pose.position() + range * direction(pose.yaw + scan.angle(i)),
               [&](Cell) { return cells += 1.0, true; });
  }
  return cells;
}

/// One tour; the scans' times go into `watch`. Gives the mean number of cells that a scan passes.
double driveTour(Mapper& mapper, Scanner& scanner, Stopwatch& watch) {
  double cells = 0.0;
  for (const Pose2& pose : tour()->poses()) {
    const LaserScan2& scan = scanner.at(pose);
    watch.insert(mapper, scan, pose);
    cells += cellsPassed(scan, pose, mapper.grid().geometry());
  }
  return cells / static_cast<double>(tour()->poses().size());
}

void exploring(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  for (auto _ : state) {
    Mapper mapper;
    Scanner scanner(tour()->caster());
    Stopwatch watch;
    state.counters["cells"] = driveTour(mapper, scanner, watch);
    watch.report(state);
    state.counters["octree_MB"] = static_cast<double>(mapper.map().octree().memory()) / 1e6;
    state.counters["map_cells"] = static_cast<double>(mapper.grid().size());
  }
}
BENCHMARK(exploring)->Name("Exploring")->Iterations(1)->Unit(benchmark::kMillisecond);

void mapped(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  Mapper mapper;
  Scanner scanner(tour()->caster());
  Stopwatch unused;
  driveTour(mapper, scanner, unused);
  for (auto _ : state) {
    Stopwatch watch;
    state.counters["cells"] = driveTour(mapper, scanner, watch);
    watch.report(state);
  }
}
BENCHMARK(mapped)->Name("Mapped")->Iterations(1)->Unit(benchmark::kMillisecond);

void fresh(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  for (auto _ : state) {
    Scanner scanner(tour()->caster());
    Stopwatch watch;
    double cells = 0.0;
    double scans = 0.0;
    for (std::size_t i = 0; i < tour()->poses().size(); i += 100) {
      Mapper mapper;
      const Pose2& pose = tour()->poses()[i];
      const LaserScan2& scan = scanner.at(pose);
      watch.insert(mapper, scan, pose);
      cells += cellsPassed(scan, pose, mapper.grid().geometry());
      scans += 1.0;
    }
    state.counters["cells"] = cells / scans;
    watch.report(state);
  }
}
BENCHMARK(fresh)->Name("Fresh")->Iterations(1)->Unit(benchmark::kMillisecond);

void save(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  Mapper mapper;
  Scanner scanner(tour()->caster());
  Stopwatch unused;
  driveTour(mapper, scanner, unused);
  const std::string path = (std::filesystem::temp_directory_path() / "willow_map").string();
  for (auto _ : state) {
    if (!saveMap(mapper.map(), path).ok()) return state.SkipWithError("cannot save");
  }
}
BENCHMARK(save)->Name("Save")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frontier_pilot
