#include "exploration/frontier_goals.h"

#include <algorithm>
#include <cmath>

#include "exploration/view_gain.h"

namespace frontier_pilot::exploration {
namespace {

/// Offsets within `radius` cells, nearest first; equally near ones row by row.
std::vector<Cell> discOffsets(int radius) {
  std::vector<Cell> offsets;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      if (x * x + y * y <= radius * radius) offsets.push_back({x, y});
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](Cell a, Cell b) { return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y; });
  return offsets;
}

}  // namespace

void FrontierGoals::restart() {
  offsets_ = discOffsets(static_cast<int>(std::lround(parameters_.goal_search_radius / map_.geometry().resolution)));
  goals_.clear();
  failures_.clear();
}

GoalCell FrontierGoals::find(const FrontierCluster& cluster, Cell anchor) {
  if (const std::optional<GoalCell> known = recall(anchor)) return *known;
  const std::size_t index = map_.geometry().index(anchor);
  const std::optional<Surroundings> surroundings = surroundingsOf(cluster);
  if (surroundings) {
    const auto failure = failures_.find(index);
    if (failure != failures_.end() && failure->second.surroundings == *surroundings) return failure->second.goal;
  }
  const GoalCell goal = search(cluster, anchor);
  if (goal.rejection == Rejection::kNone) {
    goals_[index] = goal.cell;
  } else if (surroundings) {
    failures_[index] = {*surroundings, goal};
  }
  return goal;
}

GoalCell FrontierGoals::search(const FrontierCluster& cluster, Cell anchor) const {
  constexpr int kOtherTargets = 3;
  GoalCell best = searchFor(anchor);
  for (int k = 0; k <= kOtherTargets && best.rejection != Rejection::kNone; ++k) {
    const int cell = std::min(cluster.cells * k / kOtherTargets, cluster.cells - 1);
    const GoalCell other = searchFor(cellOf(clusters_, cluster, cell));
    if (best.rejection == Rejection::kUnreachable || other.rejection == Rejection::kNone) best = other;
  }
  return best;
}

/// The nearest reachable cell that sees `target` and passes the filters; else the nearest that sees it. So a frontier
/// close to the robot or to a wall gets a goal farther away before it is rejected.
GoalCell FrontierGoals::searchFor(Cell target) const {
  constexpr int kMaxLooks = 60;  // of near and of other cells: bounds the cost if none of many cells sees it
  GoalCell first;
  int looks_from_near = 0;
  int looks = 0;
  for (const Cell offset : offsets_) {
    const Cell cell{target.x + offset.x, target.y + offset.y};
    if (!travel_.reached(cell)) continue;
    const bool near = travel_.distance(cell) < parameters_.min_distance;
    if (near && (first.rejection != Rejection::kUnreachable || ++looks_from_near > kMaxLooks)) continue;
    if (!near && ++looks > kMaxLooks) break;
    if (!inSight(map_.grid(), cell, target)) continue;
    const GoalCell goal = judge(cell);
    if (goal.rejection == Rejection::kNone) return goal;
    if (first.rejection == Rejection::kUnreachable) first = goal;
  }
  return first;
}

/// The goal found earlier for this anchor, if it is still reachable, sees the anchor and passes the filters.
std::optional<GoalCell> FrontierGoals::recall(Cell anchor) const {
  const auto known = goals_.find(map_.geometry().index(anchor));
  if (known == goals_.end() || !travel_.reached(known->second) || !inSight(map_.grid(), known->second, anchor)) {
    return std::nullopt;
  }
  const GoalCell goal = judge(known->second);
  return goal.rejection == Rejection::kNone ? std::optional<GoalCell>(goal) : std::nullopt;
}

/// Nothing near the robot, where the distances to the cells matter as well.
std::optional<FrontierGoals::Surroundings> FrontierGoals::surroundingsOf(const FrontierCluster& cluster) const {
  const GridGeometry& geometry = map_.geometry();
  const int radius = static_cast<int>(std::ceil(parameters_.goal_search_radius / geometry.resolution));
  const CellRect goals = cluster.box.grown(radius);
  const int near = static_cast<int>(std::ceil(parameters_.min_distance / geometry.resolution)) + 1;
  if (goals.grown(near).contains(from_)) return std::nullopt;
  const CellRect judged = goals.grown(parameters_.obstacle_radius_cells);
  const Vec2 centre =
      geometry.origin + geometry.resolution * Vec2(judged.x + judged.width / 2.0, judged.y + judged.height / 2.0);
  const double half_side = geometry.resolution * std::max(judged.width, judged.height) / 2.0;
  return Surroundings{space_, cluster.box, map_.changesAround(centre, half_side), travel_.countReached(goals)};
}

GoalCell FrontierGoals::judge(Cell cell) const {
  GoalCell goal{cell, Rejection::kNone, obstacleDensity(map_.grid(), cell, parameters_.obstacle_radius_cells)};
  if (travel_.distance(cell) < parameters_.min_distance) {
    goal.rejection = Rejection::kTooNear;
  } else if (goal.obstacle_density > parameters_.max_obstacle_density) {
    goal.rejection = Rejection::kCluttered;
  }
  return goal;
}

}  // namespace frontier_pilot::exploration
