#include "sim/lidar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/ascii_world.h"

namespace frontier_pilot::sim {
namespace {

const GridGeometry kOpen{0.1, {-10.0, -10.0}, 200, 200};

constexpr LidarNoise kExact{0.0, 0.0};

ScannerModel centred() {
  ScannerModel scanner;
  scanner.x = 0.0;
  return scanner;
}

// Where a beam meets the nearest disc, asking every one of them.
double bruteForce(const Vec2& from, const Vec2& unit, const std::vector<Disc>& discs, double range) {
  for (const Disc& disc : discs) {
    const Vec2 to = disc.centre - from;
    const double along = to.dot(unit);
    const double square = along * along - to.squaredNorm() + disc.radius * disc.radius;
    if (to.norm() <= disc.radius) return 0.0;
    if (along > 0.0 && square >= 0.0) range = std::min(range, along - std::sqrt(square));
  }
  return range;
}

// [SIM-2] sees other robots and obstacles, each beam that points at one and no other
TEST(Lidar, SeesDiscsAsAskingEveryOneOfThem_SIM_2) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::uniform_real_distribution<double> size(0.05, 1.4);
  for (int world = 0; world < 60; ++world) {
    Grid<std::uint8_t> solid(kOpen);
    for (int i = 0; i < 20 * (world % 30); ++i) solid[random() % solid.size()] = 1;
    const grids::RayCaster walls(solid);
    ScannerModel scanner = centred();
    scanner.angle_min = place(random) / 3.0;
    scanner.field_of_view = world % 2 == 0 ? 2.0 * kPi : 2.0 + size(random);
    scanner.yaw = place(random) / 3.0;
    Lidar lidar(scanner, kExact);
    DiscIndex index(kOpen);
    std::vector<Disc> discs;
    for (int i = 0; i < 40; ++i) {
      discs.push_back({{place(random), place(random)}, size(random)});
      index.add(discs.back());
    }
    const Pose2 base(place(random), place(random), place(random));
    LaserScan2 scan;
    Random noise(1);
    lidar.scan(base, walls, index, std::nullopt, noise, scan);
    const Pose2 sensor = base * scan.T_base_sensor;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double expected = bruteForce(sensor.position(), direction(sensor.yaw + scan.angle(i)), discs,
                                         walls.cast(sensor.position(), sensor.yaw + scan.angle(i), 8.0));
      const RangeReading reading = readBeam(scan, i);
      ASSERT_NEAR(std::max(expected, scan.range_min), reading.distance, 1e-5) << "world " << world << " beam " << i;
    }
    LaserScan2 swept = scan;
    for (std::size_t first = 0; first < scan.ranges.size(); first += 18) {
      const std::size_t end = std::min(first + 18, scan.ranges.size());
      lidar.measure({first, end, base}, walls, index, std::nullopt, noise, swept);
    }
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      ASSERT_NEAR(readBeam(scan, i).distance, readBeam(swept, i).distance, 1e-5)
          << "world " << world << " beam " << i << " of a sweep";
    }
  }
}

TEST(Lidar, DoesNotSeeTheRobotItSitsOn) {
  DiscIndex index(kOpen);
  const DiscIndex::Id own = index.add({{0.0, 0.0}, 0.1});
  Lidar lidar(centred(), kExact);
  LaserScan2 scan;
  Random noise(1);
  lidar.scan({}, grids::RayCaster(Grid<std::uint8_t>{kOpen}), index, own, noise, scan);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) EXPECT_EQ(readBeam(scan, i).kind, RangeKind::kFree);
}

TEST(Lidar, SpreadsTheBeamsOverItsFieldOfView) {
  ScannerModel scanner = centred();
  LaserScan2 scan;
  Random noise(1);
  const grids::RayCaster walls(Grid<std::uint8_t>{kOpen});
  Lidar(scanner, kExact).scan({}, walls, DiscIndex(kOpen), std::nullopt, noise, scan);
  EXPECT_NEAR(scan.angle(360), 2.0 * kPi, 1e-9) << "a full turn has no beam twice";
  scanner.field_of_view = kPi;
  scanner.angle_min = -kPi / 2;
  scanner.beams = 181;
  Lidar(scanner, kExact).scan({}, walls, DiscIndex(kOpen), std::nullopt, noise, scan);
  EXPECT_NEAR(scan.angle(180), kPi / 2, 1e-9) << "less than that has one at each end";
}

// [SIM-2] noise and drop-outs have the statistics that were asked for
TEST(Lidar, NoiseAndDropoutsAreAsConfigured_SIM_2) {
  const test::AsciiWorld world = test::drawWorld("#.........................#", 0.1);
  ScannerModel scanner = centred();
  scanner.beams = 20000;
  scanner.field_of_view = 0.001;
  LaserScan2 scan;
  Random noise(3);
  Lidar(scanner, {0.02, 0.1})
      .scan({0.65, 0.05, -0.0005}, grids::RayCaster(world.solid()), DiscIndex(world.map.geometry()), std::nullopt,
            noise, scan);
  double sum = 0.0;
  double squares = 0.0;
  double hits = 0.0;
  for (const float range : scan.ranges) {
    if (std::isnan(range)) continue;
    hits += 1.0;
    sum += range - 1.95;
    squares += (range - 1.95) * (range - 1.95);
  }
  EXPECT_NEAR(hits / 20000.0, 0.9, 0.01);
  EXPECT_NEAR(sum / hits, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / hits), 0.02, 0.001);
}

TEST(Lidar, SaysTooNearAndNothingThereAsREP117Wants) {
  const test::AsciiWorld world = test::drawWorld("#..........................................................", 0.1);
  ScannerModel scanner = centred();
  scanner.range_max = 3.0;
  LaserScan2 scan;
  Random noise(1);
  Lidar(scanner, kExact)
      .scan({0.15, 0.05, kPi}, grids::RayCaster(world.solid()), DiscIndex(world.map.geometry()), std::nullopt, noise,
            scan);
  EXPECT_EQ(scan.ranges[0], -INFINITY);
  EXPECT_EQ(scan.ranges[180], INFINITY);
}

}  // namespace
}  // namespace frontier_pilot::sim
