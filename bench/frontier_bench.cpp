// Frontier search and the reachability wavefront on whole maps, from scratch, as for a map that has just arrived.
//
// The maps are the Willow Garage floor ($FRONTIER_PILOT_WORLDS or ../shared/worlds; if absent, the office floor of
// config/worlds), repeated to fill the size and seen in part by scans from random places; and noise, where about every
// hundredth cell is unknown. `floor_MB` is the memory that must be read or written at least once: the map, and for the
// wavefront the distances and the neighbour masks.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "exploration/frontier_search.h"
#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/exploration/explorer.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/sim/simulator.h"
#include "support/benchmark_main.h"
#include "support/buildings.h"
#include "support/cpu_stopwatch.h"

const char* const frontier_pilot::bench::kPurpose =
    "Frontier search and the reachability wavefront on whole maps, from scratch.\n"
    "Worlds: the folder in FRONTIER_PILOT_WORLDS, or else ../shared/worlds.\n";

namespace frontier_pilot {
namespace {

constexpr double kClearance = 0.15;
constexpr int kExtent = 60;  // [cells], as the explorer cuts its clusters

const OccupancyGrid& building() {
  static const OccupancyGrid loaded = sim::loadWorld(bench::willowGarageOrOffice()).map;
  return loaded;
}

/// Crossing corridors connect the repetitions of the building, so that the wavefront reaches the whole map.
bool isCorridor(int x, int y) { return x % building().width() < 12 || y % building().height() < 12; }

/// The repeated building, as far as it might be known in the middle of an exploration.
OccupancyGrid seenInPart(int size) {
  const OccupancyGrid& world = building();
  GridGeometry geometry;
  geometry.width = geometry.height = size;
  Grid<std::uint8_t> solid(geometry);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool free = isCorridor(x, y) || isFree(world[Cell{x % world.width(), y % world.height()}]);
      solid[Cell{x, y}] = free ? 0 : 1;
    }
  }
  const grids::RayCaster caster(solid);
  OccupancyGrid map(geometry, kUnknown);
  std::mt19937 random(1);
  for (int scans = size * size / 7000; scans > 0;) {
    const Cell from{static_cast<int>(random() % static_cast<unsigned>(size)),
                    static_cast<int>(random() % static_cast<unsigned>(size))};
    if (solid[from] != 0) continue;
    --scans;
    for (int beam = 0; beam < 720; ++beam) {
      const Vec2 unit = direction(beam * kPi / 360.0);
      const Vec2 eye = geometry.centre(from);
      const double range = caster.cast(eye, unit, 8.0);
      visitCells(geometry, eye, eye + range * unit, [&](Cell c) {
        if (map.contains(c)) map[c] = solid[c] != 0 ? kOccupied : kFree;
        return true;
      });
    }
  }
  return map;
}

OccupancyGrid noise(int size) {
  GridGeometry geometry;
  geometry.width = geometry.height = size;
  OccupancyGrid map(geometry, kFree);
  std::mt19937 random(2);
  for (auto& cell : map.cells()) {
    if (random() % 100 == 0) cell = kUnknown;
  }
  return map;
}

const OccupancyGrid& mapOf(const benchmark::State& state) {
  static std::vector<std::pair<std::pair<bool, int>, OccupancyGrid>> maps;
  const std::pair<bool, int> key(state.range(1) != 0, static_cast<int>(state.range(0)));
  for (const auto& [known, map] : maps) {
    if (known == key) return map;
  }
  maps.emplace_back(key, key.first ? noise(key.second) : seenInPart(key.second));
  return maps.back().second;
}

Cell someFreeCell(const exploration::TraversableSpace& space) {
  const int size = space.geometry().width;
  Cell cell{size / 2, size / 2};
  while (!space.traversable(cell) && cell.x + 1 < size) ++cell.x;
  return cell;
}

void search(benchmark::State& state) {
  const OccupancyGrid& map = mapOf(state);
  exploration::FrontierClusters clusters;
  std::size_t cells = 0;
  for (auto _ : state) {
    exploration::FrontierSearch frontier;
    frontier.update(map, map.geometry().rect());
    clusters = frontier.clusters(1, kExtent);
    benchmark::DoNotOptimize(clusters);
    state.PauseTiming();
    cells = frontier.cellCount();
    state.ResumeTiming();
  }
  state.counters["frontier_cells"] = static_cast<double>(cells);
  state.counters["clusters"] = static_cast<double>(clusters.clusters.size());
  state.counters["floor_MB"] = static_cast<double>(map.size()) * 1e-6;
}

void searchAndWavefront(benchmark::State& state) {
  const OccupancyGrid& map = mapOf(state);
  // The buffers are kept, as they are in the explorer; their content is computed again each time.
  exploration::TraversableSpace space(kClearance);
  space.update(map, map.geometry().rect());
  const Cell start = someFreeCell(space);
  exploration::TravelField field;
  for (auto _ : state) {
    exploration::FrontierSearch frontier;
    frontier.update(map, map.geometry().rect());
    const exploration::FrontierClusters clusters = frontier.clusters(1, kExtent);
    benchmark::DoNotOptimize(clusters.runs.data());
    space.update(map, map.geometry().rect());
    field.compute(space, map, start, 0.5);
    benchmark::DoNotOptimize(field.reachedCount());
  }
  state.counters["reached_cells"] = static_cast<double>(field.reachedCount());
  state.counters["floor_MB"] = static_cast<double>(map.size()) * (1.0 + 1.0 + 1.0 + 4.0) * 1e-6;
}

/// The map of a robot that has seen almost all of the building: what is unknown is left in every sixteenth block of
/// 12.5 m only, so that a map of 4000 x 4000 cells has about a thousand frontiers.
const OccupancyGrid& almostSeen(int size) {
  static std::map<int, OccupancyGrid> maps;
  const auto [entry, is_new] = maps.try_emplace(size);
  if (!is_new) return entry->second;
  constexpr int kBlock = 250;  // [cells]
  OccupancyGrid map = seenInPart(size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool keeps = (x / kBlock) % 4 == 1 && (y / kBlock) % 4 == 1;
      if (!keeps && isUnknown(map[Cell{x, y}])) map[Cell{x, y}] = isCorridor(x, y) ? kFree : kOccupied;
    }
  }
  return entry->second = std::move(map);
}

/// What a scan changes: the frontiers in a block as wide as the scanner's range is to both sides.
void followScan(benchmark::State& state) {
  OccupancyGrid map = almostSeen(static_cast<int>(state.range(0)));
  exploration::FrontierSearch frontier;
  frontier.update(map, map.geometry().rect());
  constexpr int kRange = 160;  // [cells]: 8 m
  const CellRect block{map.width() / 2 - kRange, map.height() / 2 - kRange, 2 * kRange, 2 * kRange};
  std::size_t clusters = 0;
  for (auto _ : state) {
    frontier.update(map, block);
    clusters = frontier.clusters(1, kExtent).clusters.size();
  }
  state.counters["clusters"] = static_cast<double>(clusters);
}

/// A whole decision on the building: frontiers, their judgement, views and tour. The views are kept from the decision
/// before it, as they are where the map has not changed; `cold_ms` is the first decision, which has none.
void decide(benchmark::State& state) {
  const bool thousand = state.range(1) != 0;
  const OccupancyGrid& map = thousand ? almostSeen(static_cast<int>(state.range(0))) : mapOf(state);
  exploration::ExplorerParameters parameters;
  parameters.strategy = state.range(2) != 0 ? "tour" : "greedy";
  exploration::TraversableSpace space(2.0 * kClearance, exploration::KeepClearOf::kObstaclesAndUnknown);
  space.update(map, map.geometry().rect());
  exploration::Explorer explorer(parameters);
  explorer.setMap(map, map.geometry().rect());
  exploration::ExplorerInputs inputs;
  Time now{};
  const auto decideOnce = [&] {
    now += std::chrono::seconds(1);
    inputs.T_map_base = StampedPose2{now, Pose2(map.geometry().centre(someFreeCell(space)), 0.0)};
    inputs.odometry_stamp = now;
    inputs.reset = true;
    benchmark::DoNotOptimize(explorer.update(inputs, now));
  };
  const double start = bench::threadSeconds();
  decideOnce();
  state.counters["cold_ms"] = 1e3 * (bench::threadSeconds() - start);
  for (auto _ : state) decideOnce();
  state.counters["frontiers"] = static_cast<double>(explorer.frontiers().size());
  state.counters["stops"] = static_cast<double>(explorer.tour().size());
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"size", "noise"})->Args({1000, 0})->Args({1000, 1})->Args({4000, 0})->Args({4000, 1});
  bench->Unit(benchmark::kMillisecond);
}

BENCHMARK(search)->Apply(arguments);
BENCHMARK(searchAndWavefront)->Apply(arguments);
BENCHMARK(followScan)->ArgNames({"size"})->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(decide)
    ->ArgNames({"size", "almost_seen", "tour"})
    ->Args({1000, 0, 0})
    ->Args({1000, 0, 1})
    ->Args({4000, 0, 0})
    ->Args({4000, 0, 1})
    ->Args({4000, 1, 0})
    ->Args({4000, 1, 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frontier_pilot
