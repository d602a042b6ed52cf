// What it costs to put the maps of several robots together: an update of one of them, a new transform, and all at once.
//
// Each robot has a map of 60 m x 60 m with a wall every 3 m, and lies somewhere else in the common frame.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "frontier_pilot/fleet/merged_map.h"
#include "support/benchmark_main.h"

const char* const frontier_pilot::bench::kPurpose =
    "Putting the maps of several robots together: an update, a new transform, all at once.\n";

namespace frontier_pilot {
namespace {

constexpr int kSide = 1200;  // [cells]

OccupancyGrid walls() {
  GridGeometry geometry;
  geometry.width = geometry.height = kSide;
  OccupancyGrid map(geometry, kFree);
  for (int y = 0; y < kSide; y += 60) std::fill_n(map.row(y), kSide, kOccupied);
  return map;
}

Pose2 place(std::size_t robot) {
  const auto i = static_cast<double>(robot);
  return robot == 0 ? Pose2() : Pose2(2.0 * i, -3.0 * i, 0.7 * i);
}

/// The maps of `count` robots, in the first one's frame.
class Fleet {
 public:
  explicit Fleet(std::size_t count) : maps_(count, walls()) {
    for (std::size_t i = 0; i < count; ++i) set(i, maps_[i].geometry().rect(), place(i));
  }
  void set(std::size_t robot, const CellRect& changed, const Pose2& pose) {
    merged_.setSource(robot, maps_[robot], changed, pose);
    benchmark::DoNotOptimize(merged_.takeChanged());
  }
  /// A wall that was not there, or the other way round.
  void change(std::size_t robot, const CellRect& cells) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) {
      std::int8_t& cell = maps_[robot][Cell{x, cells.y}];
      cell = isFree(cell) ? kOccupied : kFree;
    }
  }

 private:
  std::vector<OccupancyGrid> maps_;
  fleet::MergedMap merged_;
};

/// A block of 8 m x 8 m, what a scan changes at most in a room.
void update(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Fleet fleet(count);
  const CellRect changed{500, 501, 160, 160};
  for (auto _ : state) {
    fleet.change(count - 1, changed);
    fleet.set(count - 1, changed, place(count - 1));
  }
}
BENCHMARK(update)->Name("Update")->Arg(2)->Arg(3)->Arg(10)->Unit(benchmark::kMillisecond);

void newTransform(benchmark::State& state) {
  Fleet fleet(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    fleet.set(1, {}, Pose2(2.1, -3.0, 0.7));
    fleet.set(1, {}, place(1));
  }
}
BENCHMARK(newTransform)->Name("TwoNewTransforms")->Arg(2)->Arg(10)->Unit(benchmark::kMillisecond);

void fromScratch(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Fleet(static_cast<std::size_t>(state.range(0))));
}
BENCHMARK(fromScratch)->Name("FromScratch")->Arg(2)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frontier_pilot
