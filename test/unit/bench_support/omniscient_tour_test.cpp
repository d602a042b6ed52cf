#include "support/omniscient_tour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "frontier_pilot/core/grid_traversal.h"
#include "sim/reachable_floor.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using bench::omniscientTour;
using bench::OmniscientTour;

constexpr double kCell = 0.1;  // [m]

test::AsciiWorld oneRoom() {
  return test::drawWorld(R"(
    ##################
    #................#
    #................#
    #....S...........#
    #................#
    #................#
    ##################)",
                         kCell);
}

/// Two rooms with a door of 0.8 m; from the start nothing of the second one is seen but a strip.
test::AsciiWorld twoRooms() {
  return test::drawWorld(R"(
    #########################################
    #...................#...................#
    #...................#...................#
    #...................#...................#
    #...................#...................#
    #...................#...................#
    #...................#...................#
    #.......................................#
    #.......................................#
    #.......................................#
    #.......................................#
    #.......................................#
    #.......................................#
    #.......................................#
    #.......................................#
    #...................#...................#
    #..S................#...................#
    #...................#...................#
    #...................#...................#
    #########################################)",
                         kCell);
}

bool seesSomeOf(const OccupancyGrid& map, const Vec2& from, const Vec2& centre) {
  const auto sees = [&](double x, double y) {
    return visitCells(map.geometry(), from, centre + 0.45 * kCell * Vec2(x, y),
                      [&](Cell c) { return map.get(c, kOccupied) == kFree; });
  };
  return sees(0, 0) || sees(-1, -1) || sees(-1, 1) || sees(1, -1) || sees(1, 1);
}

/// The share of the floor of which the middle or a corner is seen, by straight lines from places at most 0.05 m apart
/// on the path: slow and simple.
double shareSeen(const OccupancyGrid& map, const std::vector<Vec2>& path, const Grid<std::uint8_t>& floor) {
  int area = 0;
  int seen = 0;
  for (std::size_t i = 0; i < floor.size(); ++i) {
    if (floor[i] == 0) continue;
    ++area;
    const Vec2 target = map.geometry().centre(map.geometry().cell(i));
    const auto sees = [&](const Vec2& from) { return seesSomeOf(map, from, target); };
    bool found = sees(path.front());
    for (std::size_t k = 1; k < path.size() && !found; ++k) {
      const int steps = static_cast<int>(std::ceil((path[k] - path[k - 1]).norm() / 0.05));
      for (int s = 1; s <= steps && !found; ++s) found = sees(path[k - 1] + (path[k] - path[k - 1]) * s / steps);
    }
    seen += found ? 1 : 0;
  }
  return static_cast<double>(seen) / area;
}

/// The least distance from the path to the centre of a cell that is not free [m].
double clearanceOf(const OccupancyGrid& map, const std::vector<Vec2>& path) {
  double least = 1e9;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i] == kFree) continue;
    const Vec2 wall = map.geometry().centre(map.geometry().cell(i));
    least = std::min(least, (wall - path.front()).norm());
    for (std::size_t k = 1; k < path.size(); ++k) {
      const Vec2 along = path[k] - path[k - 1];
      const double at = along.norm() > 0.0 ? (wall - path[k - 1]).dot(along) / along.squaredNorm() : 0.0;
      least = std::min(least, (wall - path[k - 1] - std::min(1.0, std::max(0.0, at)) * along).norm());
    }
  }
  return least;
}

bench::TourTask taskWith(double range) {
  bench::TourTask task;
  task.range = range;
  task.rounds = 100;
  return task;
}

TEST(OmniscientTour, DoesNotLeaveTheStartOfAConvexRoom) {
  const test::AsciiWorld world = oneRoom();
  const OmniscientTour tour = omniscientTour(world.map, world.point('S'), taskWith(8.0));
  EXPECT_EQ(tour.length, 0.0);
  ASSERT_EQ(tour.path.size(), 1U);
  EXPECT_EQ(tour.path.front(), world.point('S'));
  EXPECT_GE(tour.seen, 0.99);
}

TEST(OmniscientTour, SeesTwoRoomsFromNearTheDoorBetweenThem) {
  const test::AsciiWorld world = twoRooms();
  const OmniscientTour tour = omniscientTour(world.map, world.point('S'), taskWith(8.0));
  const Grid<std::uint8_t> floor = sim::reachableFloor(world.map, world.cell('S'), 2);
  EXPECT_EQ(tour.path.front(), world.point('S'));
  EXPECT_GE(shareSeen(world.map, tour.path, floor), 0.99);
  EXPECT_GE(clearanceOf(world.map, tour.path), 0.15);
  // The door is 1.75 m from the start, and its middle 1.85 m.
  EXPECT_GE(tour.length, 0.5);
  EXPECT_LE(tour.length, 2.2);
  double length = 0.0;
  for (std::size_t i = 1; i < tour.path.size(); ++i) length += (tour.path[i] - tour.path[i - 1]).norm();
  EXPECT_NEAR(tour.length, length, 1e-9);
}

TEST(OmniscientTour, GoesFartherWithAScannerOfShortRange) {
  const test::AsciiWorld world = twoRooms();
  const double near = omniscientTour(world.map, world.point('S'), taskWith(1.0)).length;
  EXPECT_GE(near, 3.0);  // to within 1 m of the far wall
  EXPECT_LE(near, 8.0);
}

TEST(OmniscientTour, IsTheSameWhenSearchedAgain) {
  const test::AsciiWorld world = twoRooms();
  const OmniscientTour tour = omniscientTour(world.map, world.point('S'), taskWith(1.5));
  EXPECT_EQ(tour.path, omniscientTour(world.map, world.point('S'), taskWith(1.5)).path);
}

TEST(OmniscientTour, CannotStartInAWall) {
  const test::AsciiWorld world = oneRoom();
  EXPECT_THROW(omniscientTour(world.map, {0.0, 0.0}, taskWith(8.0)), std::invalid_argument);
}

}  // namespace
}  // namespace frontier_pilot
