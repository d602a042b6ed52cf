#include "exploration/goal_score.h"

namespace frontier_pilot::exploration {

ScoreTerms scoreTerms(const GoalCandidate& c, const ScoreParameters& p) {
  const double info = p.info_by_ray_casting ? c.info.area / (c.info.area + p.info_scale) : c.info.density;
  const double distance = (p.distance_by_travel ? c.travel_distance : c.euclidean_distance) / p.distance_scale;
  const double visited = static_cast<double>(c.visits) / (c.visits + 1);
  return {p.w_info * info, -p.w_dist * distance, -p.w_obs * c.obstacle_density, -p.w_visit * visited};
}

std::optional<std::size_t> chooseBestScore(const std::vector<GoalCandidate>& candidates,
                                           const std::optional<Vec2>& current, const ScoreParameters& parameters) {
  constexpr double kSamePlace = 0.5;  // [m]: the goal of a frontier moves a little as the frontier recedes
  std::optional<std::size_t> best;
  double best_score = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool is_current = current && (candidates[i].goal - *current).norm() < kSamePlace;
    const double score = candidates[i].score + (is_current ? parameters.switch_margin : 0.0);
    if (best && score <= best_score) continue;
    best = i;
    best_score = score;
  }
  return best;
}

}  // namespace frontier_pilot::exploration
