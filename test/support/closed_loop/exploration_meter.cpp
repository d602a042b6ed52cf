#include "support/closed_loop/exploration_meter.h"

#include <cmath>
#include <stdexcept>

#include "frontier_pilot/grids/distance_field.h"
#include "sim/reachable_floor.h"

namespace frontier_pilot::test {
namespace {

constexpr double kNearWall = 0.25;  // [m]
constexpr double kEdge = 0.05;      // [m]

/// 1 for the cells of `truth` whose centre is at most `distance` [m] from that of a cell which is not free.
Grid<std::uint8_t> nearWall(const OccupancyGrid& truth, double distance) {
  const grids::DistanceField field(sim::notFree(truth), 2.0 * distance);
  Grid<std::uint8_t> near(truth.geometry());
  for (std::size_t i = 0; i < near.size(); ++i) near[i] = field.grid()[i] <= distance + 1e-6 ? 1 : 0;
  return near;
}

}  // namespace

ExplorationMeter::ExplorationMeter(const OccupancyGrid& truth, const Pose2& T_world_map, double radius)
    : near_wall_(nearWall(truth, kNearWall)), T_world_map_(T_world_map) {
  const Cell start = truth.geometry().cellAt(T_world_map.position());
  floor_ = sim::reachableFloor(truth, start, static_cast<int>(std::ceil(radius / truth.resolution())));
  const double resolution = truth.resolution();
  const Grid<std::uint8_t> edge = nearWall(truth, std::ceil(kEdge / resolution) * resolution);
  const Pose2 T_map_world = T_world_map.inverse();
  for (std::size_t i = 0; i < floor_.size(); ++i) {
    if (edge[i] != 0) floor_[i] = 0;
    if (floor_[i] != 0) targets_.push_back(T_map_world * floor_.geometry().centre(floor_.geometry().cell(i)));
  }
  if (targets_.empty()) throw std::invalid_argument("the start is in or too near a wall of the truth");
}

double ExplorationMeter::area() const {
  return static_cast<double>(targets_.size()) * floor_.resolution() * floor_.resolution();
}

void ExplorationMeter::locate(const GridGeometry& map) {
  if (map == located_ && target_cell_.size() == targets_.size()) return;
  located_ = map;
  target_cell_.clear();
  for (const Vec2& target : targets_) {
    const Cell c = map.cellAt(target);
    target_cell_.push_back(map.contains(c) ? static_cast<std::int64_t>(map.index(c)) : -1);
  }
}

double ExplorationMeter::explored(const OccupancyGrid& map) {
  locate(map.geometry());
  std::size_t seen = 0;
  for (const std::int64_t i : target_cell_) {
    if (i >= 0 && isFree(map[static_cast<std::size_t>(i)])) ++seen;
  }
  return static_cast<double>(seen) / static_cast<double>(targets_.size());
}

double ExplorationMeter::wrong(const OccupancyGrid& map) const {
  std::size_t occupied = 0;
  std::size_t far = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i] <= 50) continue;
    ++occupied;
    const Cell c = near_wall_.geometry().cellAt(T_world_map_ * map.geometry().centre(map.geometry().cell(i)));
    if (near_wall_.contains(c) && near_wall_[c] == 0) ++far;
  }
  return occupied == 0 ? 0.0 : static_cast<double>(far) / static_cast<double>(occupied);
}

}  // namespace frontier_pilot::test
