#include "support/willow_tour.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>

#include "frontier_pilot/sim/simulator.h"
#include "support/buildings.h"

namespace frontier_pilot::bench {
namespace {

void visit(Grid<std::uint8_t>& visited, Cell at) {
  constexpr int kNear = 40;
  const CellRect near = CellRect{at.x, at.y, 1, 1}.grown(kNear).intersection(visited.geometry().rect());
  for (int y = near.y; y < near.y + near.height; ++y) {
    std::fill_n(visited.row(y) + near.x, near.width, std::uint8_t{1});
  }
}

std::vector<Cell> trace(const Grid<int>& parent, Cell at, Cell from) {
  std::vector<Cell> path = {at};
  while (path.back() != from) path.push_back(parent.geometry().cell(static_cast<std::size_t>(parent[path.back()])));
  std::reverse(path.begin(), path.end());
  return path;
}

/// The mean position of the poses around `i`.
Vec2 meanAround(const std::vector<Pose2>& poses, std::size_t i) {
  constexpr std::size_t kReach = 5;
  const std::size_t reach = std::min({kReach, i, poses.size() - 1 - i});
  Vec2 sum = Vec2::Zero();
  for (std::size_t k = i - reach; k <= i + reach; ++k) sum += poses[k].position();
  return sum / static_cast<double>(2 * reach + 1);
}

}  // namespace

Tour::Tour(const OccupancyGrid& map, const Vec2& start) : solid_(map.geometry()) {
  for (std::size_t i = 0; i < map.size(); ++i) solid_[i] = map[i] == kFree ? 0 : 1;
  caster_ = grids::RayCaster(solid_);
  distance_ = grids::DistanceField(solid_, 0.5);
  drive(map.geometry().cellAt(start));
}

/// Drives to the nearest cell that has not been visited, again and again, until none is reachable.
void Tour::drive(Cell at) {
  Grid<std::uint8_t> visited(solid_.geometry(), 0);
  while (true) {
    visit(visited, at);
    const std::vector<Cell> leg = pathToUnvisited(visited, at);
    if (leg.empty()) return;
    for (std::size_t i = 1; i < leg.size(); ++i) addPose(leg[i - 1], leg[i]);
    at = leg.back();
  }
}

std::vector<Cell> Tour::pathToUnvisited(const Grid<std::uint8_t>& visited, Cell from) const {
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

void Tour::addPose(Cell from, Cell to) {
  poses_.emplace_back(solid_.geometry().centre(to), bearing(Vec2(to.x - from.x, to.y - from.y)));
}

const Tour* tour() {
  if (!std::filesystem::exists(willowGarage())) return nullptr;
  static const Tour whole(sim::loadWorld(willowGarage()).map, {16.6, 21.6});
  return &whole;
}

std::vector<Pose2> smoothed(const std::vector<Pose2>& poses) {
  constexpr double kTurn = 0.12;  // [rad] between two scans
  constexpr std::size_t kAhead = 8;
  std::vector<Pose2> result;
  double yaw = poses.front().yaw;
  for (std::size_t i = 0; i + kAhead < poses.size(); ++i) {
    const Vec2 at = meanAround(poses, i);
    const Vec2 ahead = meanAround(poses, i + kAhead) - at;
    const double wanted = ahead.norm() > 0.1 ? bearing(ahead) : yaw;
    while (std::abs(angleDifference(wanted, yaw)) > kPi / 3.0) {
      yaw = normalizeAngle(yaw + std::copysign(kTurn, angleDifference(wanted, yaw)));
      result.emplace_back(at, yaw);
    }
    yaw = normalizeAngle(yaw + std::clamp(angleDifference(wanted, yaw), -kTurn, kTurn));
    result.emplace_back(at, yaw);
  }
  return result;
}

Scanner::Scanner(const grids::RayCaster& caster) : caster_(caster) {
  scan_.angle_min = -kPi;
  scan_.angle_increment = 2.0 * kPi / 360.0;
  scan_.range_min = 0.12;
  scan_.range_max = kRange;
  scan_.ranges.resize(360);
}

const LaserScan2& Scanner::at(const Pose2& pose) {
  scan_.stamp += fromSeconds(0.1);
  for (std::size_t i = 0; i < scan_.ranges.size(); ++i) {
    const double range = caster_.cast(pose.position(), pose.yaw + scan_.angle(i), kRange);
    scan_.ranges[i] = static_cast<float>(range < kRange ? range + noise_(random_) : range + 1.0);
  }
  return scan_;
}

}  // namespace frontier_pilot::bench
