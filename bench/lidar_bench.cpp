// What a ray, a scan and a step of the simulator cost, and how that grows with the number of robots. On the Willow
// Garage floor ($FRONTIER_PILOT_WORLDS or ../shared/worlds), or if that is absent on the office floor of config/worlds.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "frontier_pilot/fleet/claims.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/sim/simulator.h"
#include "sim/collision/collision_map.h"
#include "sim/solid_cells.h"
#include "support/benchmark_main.h"
#include "support/buildings.h"
#include "support/cpu_time.h"

const char* const frontier_pilot::bench::kPurpose =
    "What a ray, a scan and a step of the simulator cost, and how that grows with the number of robots.\n"
    "Worlds: the folder in FRONTIER_PILOT_WORLDS, or else ../shared/worlds.\n";

namespace frontier_pilot::sim {
namespace {

constexpr int kBeams = 360;
constexpr double kRange = 8.0;  // [m]

const World& world() {
  static const World loaded = loadWorld(bench::willowGarageOrOffice());
  return loaded;
}

// 1000 random places on the free floor where a robot fits, at least half a metre apart.
const std::vector<RobotSpec>& places() {
  static const std::vector<RobotSpec> found = [] {
    const CollisionMap walls(solidCells(world().map, false), 0.105);
    const Outline outline = Outline::disc(0.105);
    std::mt19937 random(1);
    std::vector<RobotSpec> robots;
    while (robots.size() < 1000) {
      const Vec2 at = world().map.geometry().centre(world().map.geometry().cell(random() % world().map.size()));
      bool fits = !walls.overlaps({outline, {at, 0.0}});
      for (const RobotSpec& other : robots) fits = fits && (Vec2(other.x, other.y) - at).norm() > 0.5;
      if (fits)
        robots.push_back(
            {"r" + std::to_string(robots.size()), at.x(), at.y(), 0.01 * static_cast<double>(random() % 600)});
    }
    return robots;
  }();
  return found;
}

// Casts scans from one place after the other, on one core.
void castFromPlaces(benchmark::State& state, const grids::RayCaster& caster) {
  std::vector<Vec2> units;
  for (int i = 0; i < kBeams; ++i) units.push_back(direction(0.01 + i * 2.0 * kPi / kBeams));
  std::vector<double> ranges(kBeams);
  std::size_t next = 0;
  for (auto _ : state) {
    const RobotSpec& at = places()[next++ % places().size()];
    std::fill(ranges.begin(), ranges.end(), kRange);
    caster.castAll({at.x, at.y}, units, ranges);
    benchmark::DoNotOptimize(ranges.data());
  }
  state.counters["rays/s"] =
      benchmark::Counter(kBeams * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

// Static walls only: the requirement is 15 million rays per second.
void castScans(benchmark::State& state) { castFromPlaces(state, grids::RayCaster(solidCells(world().map, false))); }
BENCHMARK(castScans)->MinTime(1.0);

// The lower bound: as castScans, but every ray ends at once, so that only its set-up and one look-up are left.
void castScansFromWithinAWall(benchmark::State& state) {
  castFromPlaces(state, grids::RayCaster(Grid<std::uint8_t>(world().map.geometry(), 1)));
}
BENCHMARK(castScansFromWithinAWall)->MinTime(0.5);

void buildRayCaster(benchmark::State& state) {
  const Grid<std::uint8_t> solid = solidCells(world().map, false);
  for (auto _ : state) benchmark::DoNotOptimize(grids::RayCaster(solid));
}
BENCHMARK(buildRayCaster)->Unit(benchmark::kMillisecond);

SimulatorParameters robots(std::int64_t count) {
  SimulatorParameters parameters;
  parameters.robot.scanner.beams = kBeams;
  parameters.robot.scanner.range_max = kRange;
  parameters.robots.assign(places().begin(), places().begin() + count);
  return parameters;
}

void driveAll(Simulator& simulator) {
  for (std::size_t i = 0; i < simulator.robotCount(); ++i) simulator.setCommand(i, {0.2, i % 2 == 0 ? 0.5 : -0.5});
}

// Steps the simulator from one scan to the next.
void stepToScan(Simulator& simulator) {
  driveAll(simulator);
  for (int i = 0; i < 10; ++i) simulator.step();
}

// Everything: robots that drive, and scan at 10 Hz with noise. `real time` is simulated time over wall time.
void simulate(benchmark::State& state, bool rolling) {
  SimulatorParameters parameters = robots(state.range(0));
  parameters.robot.scanner.rolling = rolling;
  Simulator simulator(world(), parameters);
  for (auto _ : state) stepToScan(simulator);
  const auto scans = static_cast<double>(state.iterations());
  const double rays = scans * static_cast<double>(state.range(0)) * kBeams;
  state.counters["real time"] = benchmark::Counter(scans * 0.1, benchmark::Counter::kIsRate);
  state.counters["ns/ray"] = benchmark::Counter(rays * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void simulate(benchmark::State& state) { simulate(state, false); }
BENCHMARK(simulate)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->MinTime(1.0)->Unit(benchmark::kMicrosecond);

// The same with scanners that measure one beam after the other.
void simulateRolling(benchmark::State& state) { simulate(state, true); }
BENCHMARK(simulateRolling)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->MinTime(1.0)->Unit(benchmark::kMicrosecond);

// The same robots tell each other what they are going to look at, twice a second, and each of them considers that in
// each of the explorer's cycles, five times a second. They have no maps. An iteration is a second of the simulation.
void simulateWithClaims(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Simulator simulator(world(), robots(state.range(0)));
  std::vector<fleet::ClaimBook> books;
  std::vector<fleet::ClaimsMessage> messages;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<exploration::Claim> claims(fleet::ClaimsMessage::kMostClaims, {{1.0, 2.0}, 3.0});
    books.emplace_back(simulator.name(i));
    messages.push_back(fleet::makeClaimsMessage(simulator.name(i), {}, claims, {}));
  }
  Time now;
  for (auto _ : state) {
    for (int tenth = 0; tenth < 10; ++tenth, now += fromSeconds(0.1)) {
      stepToScan(simulator);
      for (std::size_t i = 0; i < count; ++i) {
        if (tenth % 5 == 0) {
          for (const fleet::ClaimsMessage& message : messages) benchmark::DoNotOptimize(books[i].take(message, now));
        }
        if (tenth % 2 == 0) benchmark::DoNotOptimize(books[i].others({}, now));
      }
    }
  }
  state.counters["real time"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(simulateWithClaims)->Arg(10)->Arg(100)->MinTime(1.0)->Unit(benchmark::kMillisecond);

// Moves the robot to a place. With `among_others`, the obstacle that stood there moves to where the robot came from.
void carryTo(std::size_t i, bool among_others, Simulator& simulator) {
  const RobotSpec& to = places()[i];
  const RobotSpec& from = places()[(i + places().size() - 1) % places().size()];
  if (among_others) simulator.removeObstacle(to.name);
  simulator.setPose(simulator.name(0), {to.x, to.y, to.yaw});
  if (among_others) simulator.spawnObstacle(from.name, {from.x, from.y, 0.0}, 0.105);
}

// CPU time per ray [ns] with 1,000 robots, and with three controls. They are measured in turns, so that all meet the
// same load of the machine. The controls: one robot that stays where it is; one that is moved after each scan to the
// next place of the 1,000, so that the cache is as cold; and the same among 999 obstacles of a robot's size, so that it
// sees as many discs.
void growth(benchmark::State& state) {
  const std::size_t count = places().size();
  Simulator staying(world(), robots(1));
  Simulator carried(world(), robots(1));
  Simulator among(world(), robots(1));
  Simulator all(world(), robots(static_cast<std::int64_t>(count)));
  for (const RobotSpec& at : places()) among.spawnObstacle(at.name, {at.x, at.y, 0.0}, 0.105);
  std::array<double, 5> marks{};
  std::array<double, 4> seconds{};
  for (auto _ : state) {
    marks[0] = bench::threadSeconds();
    for (std::size_t i = 0; i < count; ++i) stepToScan(staying);
    marks[1] = bench::threadSeconds();
    for (std::size_t i = 0; i < count; ++i) carryTo(i, false, carried), stepToScan(carried);
    marks[2] = bench::threadSeconds();
    for (std::size_t i = 0; i < count; ++i) carryTo(i, true, among), stepToScan(among);
    marks[3] = bench::threadSeconds();
    stepToScan(all);
    marks[4] = bench::threadSeconds();
    for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] += marks[i + 1] - marks[i];
  }
  const double rays = static_cast<double>(state.iterations()) * static_cast<double>(count) * kBeams;
  state.counters["one"] = seconds[0] / rays * 1e9;
  state.counters["one, carried"] = seconds[1] / rays * 1e9;
  state.counters["one, carried among 999"] = seconds[2] / rays * 1e9;
  state.counters["1000 robots"] = seconds[3] / rays * 1e9;
  state.counters["ratio"] = seconds[3] / seconds[2];
}
BENCHMARK(growth)->Iterations(30)->Unit(benchmark::kMillisecond);

// The cost of a step without a scan, per robot.
void step(benchmark::State& state) {
  SimulatorParameters parameters = robots(state.range(0));
  parameters.robot.scanner.rate = 0.1;
  parameters.robot.scanner.beams = 1;
  Simulator simulator(world(), parameters);
  for (auto _ : state) {
    driveAll(simulator);
    simulator.step();
  }
  state.counters["ns/robot"] = benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)) * 1e-9,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(step)->Arg(1)->Arg(1000);

}  // namespace
}  // namespace frontier_pilot::sim
