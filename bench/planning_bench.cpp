// Planning on the Willow Garage floor between 200 random pairs of reachable cells: the time, the number of expanded
// cells, and the length compared to the shortest any-angle path of the same clearance. Set FRONTIER_PILOT_WORLDS to the
// folder of willow_garage.yaml if that is not ../shared/worlds. The reference takes minutes and is only computed with
// FRONTIER_PILOT_REFERENCE=1.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "frontier_pilot/planning/global_planner.h"
#include "frontier_pilot/sim/simulator.h"
#include "planning/grid_search.h"
#include "support/any_angle_reference.h"
#include "support/benchmark_main.h"
#include "support/buildings.h"

const char* const frontier_pilot::bench::kPurpose =
    "Planning on the Willow Garage floor: time, expanded cells, and length compared to the shortest path.\n"
    "Worlds: the folder in FRONTIER_PILOT_WORLDS, or else ../shared/worlds.\n";

namespace frontier_pilot::bench {
namespace {

constexpr int kPairs = 200;

/// For choosing the pairs and for the reference: only ways with the full clearance, in which nothing can be touched.
/// The planner itself may also use tighter ones.
planning::ClearanceParams withoutTightPlaces() {
  planning::ClearanceParams params;
  params.tight_weight = 0.0;
  return params;
}

struct Willow {
  OccupancyGrid map = sim::loadWorld(willowGarage()).map;
  std::vector<planning::PlanRequest> requests;

  Willow() {
    planning::ClearanceMap clearance(withoutTightPlaces());
    clearance.setMap(map, map.geometry().rect());
    const Cell start = map.geometry().cellAt({16.6, 21.6});
    planning::GridSearch flood;
    flood.search(clearance, start, {0, 0});
    std::vector<Cell> reachable;
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (flood.reached(map.geometry().cell(i))) reachable.push_back(map.geometry().cell(i));
    }
    std::mt19937 random(1);
    for (int i = 0; i < kPairs; ++i) {
      planning::PlanRequest request;
      request.start = map.geometry().centre(reachable[random() % reachable.size()]);
      request.goal = map.geometry().centre(reachable[random() % reachable.size()]);
      requests.push_back(request);
    }
  }
};

const Willow& willow() {
  static const Willow instance;
  return instance;
}

planning::ClearanceMap clearanceMap(const planning::ClearanceParams& params) {
  planning::ClearanceMap map(params);
  map.setMap(willow().map, willow().map.geometry().rect());
  return map;
}

std::vector<double> referenceLengths() {
  std::vector<double> lengths;
  planning::ClearanceParams params = withoutTightPlaces();
  params.wall_weight = 0.0;
  const planning::ClearanceMap map = clearanceMap(params);
  for (const planning::PlanRequest& request : willow().requests) {
    lengths.push_back(shortestAnyAngle(map, request.start, request.goal).path.length());
  }
  return lengths;
}

void lengthCounters(benchmark::State& state, const std::vector<double>& lengths) {
  if (std::getenv("FRONTIER_PILOT_REFERENCE") == nullptr) return;
  static const std::vector<double> reference = referenceLengths();
  double sum = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double ratio = reference[i] > 0.0 ? lengths[i] / reference[i] : 1.0;
    sum += ratio;
    worst = std::max(worst, ratio);
  }
  state.counters["length_ratio_mean"] = sum / static_cast<double>(lengths.size());
  state.counters["length_ratio_max"] = worst;
}

struct Clearances {
  double mean = 0.0;   ///< along the path [m]
  double least = 1e9;  ///< [m]
};

Clearances clearancesAlong(const planning::ClearanceMap& map, const planning::Path& path) {
  Clearances clearances;
  const std::vector<Vec2> samples = path.sampled(0.02);
  for (const Vec2& sample : samples) {
    const double here = map.clearance(sample);
    clearances.mean += here / static_cast<double>(samples.size());
    clearances.least = std::min(clearances.least, here);
  }
  return clearances;
}

void planWillow(benchmark::State& state) {
  const planning::ClearanceMap map = clearanceMap(planning::ClearanceParams());
  planning::GlobalPlanner planner;
  std::vector<double> best(kPairs, 1e9);
  std::vector<double> lengths(kPairs, 0.0);
  int solved = 0;
  double expanded = 0.0;
  for (auto _ : state) {
    solved = 0;
    expanded = 0.0;
    for (std::size_t i = 0; i < kPairs; ++i) {
      const std::clock_t before = std::clock();  // processor time, because other programs may be running
      const planning::PlanResult result = planner.plan(map, willow().requests[i]);
      const double took = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      best[i] = std::min(best[i], took);
      lengths[i] = result.path.length();
      solved += result.found() ? 1 : 0;
      expanded += static_cast<double>(result.expanded);
    }
  }
  std::sort(best.begin(), best.end());
  state.counters["solved"] = solved;
  state.counters["mean_ms"] = std::accumulate(best.begin(), best.end(), 0.0) / kPairs;
  state.counters["p99_ms"] = best[kPairs * 99 / 100 - 1];
  state.counters["max_ms"] = best.back();
  state.counters["expanded_mean"] = expanded / kPairs;
  state.counters["length_mean_m"] = std::accumulate(lengths.begin(), lengths.end(), 0.0) / kPairs;
  lengthCounters(state, lengths);
}
BENCHMARK(planWillow)->Unit(benchmark::kMillisecond)->Iterations(3);

/// Each of the first 100 pairs planned once by a new planner, as a robot does: mean and greatest time, mean length, and
/// the clearance that the paths keep.
void planEachPairOnce(benchmark::State& state) {
  constexpr std::size_t kOnce = 100;
  const planning::ClearanceMap map = clearanceMap(planning::ClearanceParams());
  double sum = 0.0;
  double worst = 0.0;
  double length = 0.0;
  double clearance = 0.0;
  double least = 0.0;
  for (auto _ : state) {
    planning::GlobalPlanner planner;
    for (std::size_t i = 0; i < kOnce; ++i) {
      const std::clock_t before = std::clock();
      const planning::PlanResult result = planner.plan(map, willow().requests[i]);
      const double took = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      sum += took / kOnce;
      worst = std::max(worst, took);
      length += result.path.length() / kOnce;
      const Clearances kept = clearancesAlong(map, result.path);
      clearance += kept.mean / kOnce;
      least += kept.least / kOnce;
    }
  }
  state.counters["mean_ms"] = sum;
  state.counters["max_ms"] = worst;
  state.counters["length_mean_m"] = length;
  state.counters["clearance_mean_m"] = clearance;
  state.counters["clearance_least_mean_m"] = least;
}
BENCHMARK(planEachPairOnce)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Updating the clearance map after a scan: a small change in a window of the scanner's range.
void updateMap(benchmark::State& state) {
  OccupancyGrid grid = willow().map;
  planning::ClearanceMap map;
  map.setMap(grid, grid.geometry().rect());
  const Cell at = grid.geometry().cellAt({16.6, 21.6});
  const CellRect changed = CellRect{at.x, at.y, 1, 1}.grown(160);
  int step = 0;
  for (auto _ : state) {
    for (int i = 0; i < 20; ++i) grid[Cell{at.x + i, at.y + step % 40}] = (step / 40) % 2 == 0 ? kOccupied : kFree;
    ++step;
    map.setMap(grid, changed);
    benchmark::DoNotOptimize(map.refresh());
  }
}
BENCHMARK(updateMap)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace frontier_pilot::bench
