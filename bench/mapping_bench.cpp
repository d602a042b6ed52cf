// What a scan costs the mapper on the Willow Garage floor: 360 beams, 8 m, 1 cm noise, a scan every 5 cm of a tour that
// comes within 2 m of every reachable place. Set FRONTIER_PILOT_WORLDS to the folder of willow_garage.yaml.
//
//   Exploring   the first tour through an empty map: 0.5 m/s at 10 Hz
//   Mapped      the same tour once more, through a map that is complete
//   Fresh       single scans, each into an empty map: the worst case
//   Publishing  how much of the map is sent on two tours, and what copying it costs
//   Save        writing the map's files
//
// `cells` is the mean number of cells that the beams of a scan pass through: each must be read at least once.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/mapping/map_schedule.h"
#include "frontier_pilot/mapping/mapper.h"
#include "support/benchmark_main.h"
#include "support/cpu_stopwatch.h"
#include "support/willow_tour.h"

const char* const frontier_pilot::bench::kPurpose =
    "What a scan costs the mapper on the Willow Garage floor, and what publishing and saving the map cost.\n"
    "Worlds: the folder in FRONTIER_PILOT_WORLDS, or else ../shared/worlds.\n";

namespace frontier_pilot {
namespace {

using bench::Scanner;
using bench::Stopwatch;
using bench::tour;

void insert(mapping::Mapper& mapper, const LaserScan2& scan, const Pose2& pose, Stopwatch& watch) {
  watch.time([&] { benchmark::DoNotOptimize(mapper.insert(scan, pose, scan.stamp)); });
}

double cellsPassed(const LaserScan2& scan, const Pose2& pose, const GridGeometry& geometry) {
  double cells = 0.0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = std::min(bench::kRange, static_cast<double>(scan.ranges[i]));
    visitCells(geometry, pose.position(), pose.position() + range * direction(pose.yaw + scan.angle(i)),
               [&](Cell) { return cells += 1.0, true; });
  }
  return cells;
}

/// Drives one tour; `watch` takes the time of each scan. Returns the mean number of cells that a scan passes through.
double driveTour(mapping::Mapper& mapper, Scanner& scanner, Stopwatch& watch) {
  double cells = 0.0;
  for (const Pose2& pose : tour()->poses()) {
    const LaserScan2& scan = scanner.at(pose);
    insert(mapper, scan, pose, watch);
    cells += cellsPassed(scan, pose, mapper.map().geometry());
  }
  return cells / static_cast<double>(tour()->poses().size());
}

/// Measures only the insertion of scans, not the matching that finds their poses.
mapping::MapperParameters insertionOnly() {
  mapping::MapperParameters parameters;
  parameters.trust_odometry = true;
  return parameters;
}

void exploring(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  for (auto _ : state) {
    mapping::Mapper mapper(insertionOnly());
    Scanner scanner(tour()->caster());
    Stopwatch watch;
    state.counters["cells"] = driveTour(mapper, scanner, watch);
    watch.report(state);
    state.counters["map_MB"] = static_cast<double>(mapper.map().memory()) / 1e6;
    state.counters["map_cells"] = static_cast<double>(mapper.map().geometry().size());
  }
}
BENCHMARK(exploring)->Name("Exploring")->Iterations(1)->Unit(benchmark::kMillisecond);

void mapped(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  mapping::Mapper mapper(insertionOnly());
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
      mapping::Mapper mapper(insertionOnly());
      const Pose2& pose = tour()->poses()[i];
      const LaserScan2& scan = scanner.at(pose);
      insert(mapper, scan, pose, watch);
      cells += cellsPassed(scan, pose, mapper.map().geometry());
      scans += 1.0;
    }
    state.counters["cells"] = cells / scans;
    watch.report(state);
  }
}
BENCHMARK(fresh)->Name("Fresh")->Iterations(1)->Unit(benchmark::kMillisecond);

/// The work of the map's publisher: each change is copied into an update message; now and then the whole map is sent.
class Publishing {
 public:
  void publish(mapping::Mapper& mapper, Time now) {
    const occupancy::OccupancyMap& map = mapper.map();
    const occupancy::MapChanges changes = mapper.takeChanges();
    if (schedule_.note(changes, now)) {
      watch_.time([&] { message_ = map.projection(changes.cells).cells(); });
      changed_ += static_cast<double>(message_.size());
    }
    if (!schedule_.isDue(map.geometry().size(), now)) return;
    watch_.time([&] { message_ = map.projection().cells(); });
    whole_maps_ += static_cast<double>(message_.size());
    schedule_.sent(now);
  }
  void report(benchmark::State& state, double scans) {
    watch_.report(state);
    state.counters["changed"] = changed_ / scans;
    state.counters["whole"] = whole_maps_ / scans;
  }

 private:
  mapping::MapSchedule schedule_;
  std::vector<std::int8_t> message_;
  Stopwatch watch_;
  double changed_ = 0.0;
  double whole_maps_ = 0.0;
};

void publishing(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  for (auto _ : state) {
    mapping::Mapper mapper(insertionOnly());
    Scanner scanner(tour()->caster());
    Publishing publisher;
    Stopwatch unused;
    for (int round = 0; round < 2; ++round) {
      for (const Pose2& pose : tour()->poses()) {
        const LaserScan2& scan = scanner.at(pose);
        insert(mapper, scan, pose, unused);
        publisher.publish(mapper, scan.stamp);
      }
    }
    publisher.report(state, 2.0 * static_cast<double>(tour()->poses().size()));
    state.counters["map_cells"] = static_cast<double>(mapper.map().geometry().size());
  }
}
BENCHMARK(publishing)->Name("Publishing")->Iterations(1)->Unit(benchmark::kMillisecond);

void save(benchmark::State& state) {
  if (tour() == nullptr) return state.SkipWithError("no willow_garage.yaml");
  mapping::Mapper mapper(insertionOnly());
  Scanner scanner(tour()->caster());
  Stopwatch unused;
  driveTour(mapper, scanner, unused);
  const std::string path = (std::filesystem::temp_directory_path() / "willow_map").string();
  for (auto _ : state) {
    if (!map_files::saveMap(mapper.map(), path).ok()) return state.SkipWithError("cannot save");
  }
}
BENCHMARK(save)->Name("Save")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frontier_pilot
