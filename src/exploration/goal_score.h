#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// A possible next goal with everything that its score is computed from. [EXP-4]
struct GoalCandidate {
  std::size_t frontier = 0;         ///< index among the frontiers
  Vec2 goal = Vec2::Zero();         ///< [m]
  double travel_distance = 0.0;     ///< along a path from the robot, or from a fall-back's start [m]
  double euclidean_distance = 0.0;  ///< [m]
  ViewGain info;
  double obstacle_density = 0.0;  ///< relative to the greatest allowed, 0 to 1
  int visits = 0;
  double score = 0.0;
};

/// The terms of `score = w_info * info - w_dist * distance - w_obs * obs - w_visit * visited`, with their weights and
/// signs, each normalised: info to [0, 1) by area / (area + info_scale), or the unknown share as it is; distance in
/// units of distance_scale; obs the density over the greatest allowed; visited = visits / (visits + 1). [EXP-4]
struct ScoreTerms {
  double information;
  double distance;
  double obstacles;
  double visits;

  double sum() const { return information + distance + obstacles + visits; }
};

ScoreTerms scoreTerms(const GoalCandidate& candidate, const ScoreParameters& parameters);

inline double goalScore(const GoalCandidate& candidate, const ScoreParameters& parameters) {
  return scoreTerms(candidate, parameters).sum();
}

/// Index of the candidate with the best score, the first of equal ones; nullopt without candidates. A candidate within
/// 0.5 m of `current`, the goal being driven to, gets a bonus of switch_margin.
std::optional<std::size_t> chooseBestScore(const std::vector<GoalCandidate>& candidates,
                                           const std::optional<Vec2>& current, const ScoreParameters& parameters);

}  // namespace frontier_pilot::exploration
