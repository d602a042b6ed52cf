#include <algorithm>

#include "exploration/frontier_evaluator.h"
#include "exploration/view_gain.h"

namespace frontier_pilot::exploration {

std::vector<GoalCandidate> FrontierEvaluator::candidates(const Vec2& robot) {
  std::vector<GoalCandidate> all;
  for (std::size_t i = 0; i < frontiers_.size(); ++i) {
    Frontier& f = frontiers_[i];
    if (!f.selectable()) continue;
    const double density = f.obstacle_density / std::max(parameters_.max_obstacle_density, 1e-3);
    all.push_back({i, f.goal, f.distance, (f.goal - robot).norm(), f.info, density, f.visits, 0.0});
    f.score = all.back().score = goalScore(all.back(), parameters_.score);
  }
  return all;
}

std::optional<GoalCandidate> FrontierEvaluator::candidateAt(const Pose2& goal, const Vec2& robot) {
  const Cell cell = map_.geometry().cellAt(goal.position());
  if (!travel_.reached(cell)) return std::nullopt;
  const double density = obstacleDensity(map_.grid(), cell, parameters_.obstacle_radius_cells);
  const double relative = std::min(1.0, density / std::max(parameters_.max_obstacle_density, 1e-3));
  const double distance = (goal.position() - robot).norm();
  GoalCandidate candidate{
      frontiers_.size(), goal.position(), travel_.distance(cell), distance, infoAt(goal), relative, 0, 0.0};
  candidate.score = goalScore(candidate, parameters_.score);
  return candidate;
}

}  // namespace frontier_pilot::exploration
