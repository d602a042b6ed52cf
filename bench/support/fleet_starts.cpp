#include "support/fleet_starts.h"

#include <random>
#include <stdexcept>
#include <string>

#include "frontier_pilot/grids/distance_field.h"
#include "sim/reachable_floor.h"

namespace frontier_pilot::bench {
namespace {

constexpr double kTogether = 3.0;  // [m]: the greatest distance between two starts
constexpr double kApart = 0.3;     // [m]: between a robot and what is around it

bool hasRoomBeside(const Vec2& place, const std::vector<sim::RobotSpec>& robots, double radius) {
  for (const sim::RobotSpec& robot : robots) {
    const double distance = (place - Vec2(robot.x, robot.y)).norm();
    if (distance > kTogether || distance < 2.0 * radius + kApart) return false;
  }
  return true;
}

}  // namespace

std::vector<Cell> placesAround(const OccupancyGrid& truth, const Vec2& first, double radius, double distance) {
  const GridGeometry& geometry = truth.geometry();
  const grids::DistanceField walls(sim::notFree(truth), radius + geometry.resolution);
  const Cell start = geometry.cellAt(first);
  Grid<std::uint8_t> blocked(geometry, 1);
  const CellRect box = CellRect{start.x, start.y, 1, 1}.grown(static_cast<int>(distance / geometry.resolution) + 1);
  const CellRect inside = box.intersection(geometry.rect());
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const Cell cell{x, y};
      const bool near = (geometry.centre(cell) - first).norm() <= distance;
      if (near && (cell == start || walls.grid()[cell] >= radius)) blocked[cell] = 0;
    }
  }
  const Grid<std::uint8_t> connected = sim::connectedCells(blocked, start);
  std::vector<Cell> places;
  for (std::size_t i = 0; i < connected.size(); ++i) {
    if (connected[i] != 0) places.push_back(geometry.cell(i));
  }
  return places;
}

std::vector<sim::RobotSpec> fleetStarts(const OccupancyGrid& truth, const Pose2& first, std::size_t count,
                                        double radius, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const std::vector<Cell> places = placesAround(truth, first.position(), radius + kApart, kTogether);
  std::vector<sim::RobotSpec> robots{{"robot_1", first.x, first.y, first.yaw}};
  while (robots.size() < count) {
    std::vector<Vec2> left;
    for (const Cell place : places) {
      const Vec2 centre = truth.geometry().centre(place);
      if (hasRoomBeside(centre, robots, radius)) left.push_back(centre);
    }
    if (left.empty()) throw std::runtime_error("no room for " + std::to_string(count) + " robots around the start");
    const Vec2 drawn = left[random() % left.size()];
    const double yaw = kPi * (static_cast<double>(random() % 360) / 180.0 - 1.0);
    robots.push_back({"robot_" + std::to_string(robots.size() + 1), drawn.x(), drawn.y(), yaw});
  }
  return robots;
}

}  // namespace frontier_pilot::bench
