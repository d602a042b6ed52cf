#include "exploration/goal_strategy.h"

#include <cstdio>
#include <stdexcept>
#include <vector>

#include "exploration/goal_score.h"
#include "exploration/tour/tour_strategy.h"

namespace frontier_pilot::exploration {
namespace {

/// Takes one of the frontiers' goals.
class CandidateStrategy : public GoalStrategy {
 public:
  std::optional<ChosenGoal> choose(FrontierEvaluator& evaluator, const Situation& situation) override {
    const Vec2 robot = situation.T_map_robot.position();
    std::vector<GoalCandidate> all = evaluator.candidates(robot);
    if (situation.current && situation.keep_current) {
      if (const auto present = evaluator.candidateAt(*situation.current, robot)) all.push_back(*present);
    }
    const auto current = situation.current ? std::make_optional(situation.current->position()) : std::nullopt;
    const ScoreParameters& weights = evaluator.scoreWeights();
    const std::optional<std::size_t> best = bestOf(all, current, weights);
    if (!best) return std::nullopt;
    const GoalCandidate& chosen = all[*best];
    ChosenGoal goal;
    goal.position = chosen.goal;
    const bool has_frontier = chosen.frontier < evaluator.frontiers().size();
    goal.yaw = has_frontier ? evaluator.view().yawTowards(evaluator.frontiers()[chosen.frontier].heading)
                            : situation.current->yaw;  // it is the present goal
    goal.distance = chosen.travel_distance;
    goal.area = chosen.info.area;
    goal.why = why(chosen, weights);
    return goal;
  }

 private:
  virtual std::optional<std::size_t> bestOf(const std::vector<GoalCandidate>& candidates,
                                            const std::optional<Vec2>& current,
                                            const ScoreParameters& weights) const = 0;
  virtual std::string why(const GoalCandidate& chosen, const ScoreParameters& weights) const = 0;
};

/// The goal with the best score. [EXP-4]
class GreedyStrategy : public CandidateStrategy {
  std::optional<std::size_t> bestOf(const std::vector<GoalCandidate>& candidates, const std::optional<Vec2>& current,
                                    const ScoreParameters& weights) const override {
    return chooseBestScore(candidates, current, weights);
  }

  std::string why(const GoalCandidate& chosen, const ScoreParameters& weights) const override {
    const ScoreTerms terms = scoreTerms(chosen, weights);
    char text[120];
    std::snprintf(text, sizeof text, "score %.2f: information %+.2f, distance %+.2f, obstacles %+.2f, visits %+.2f",
                  chosen.score, terms.information, terms.distance, terms.obstacles, terms.visits);
    return text;
  }
};

/// The goal with the shortest way. The present goal is kept unless another one is nearer by a fifth.
class NearestStrategy : public CandidateStrategy {
  std::optional<std::size_t> bestOf(const std::vector<GoalCandidate>& candidates, const std::optional<Vec2>& current,
                                    const ScoreParameters& /*weights*/) const override {
    constexpr double kAdvantage = 0.8;
    constexpr double kSamePlace = 0.5;  // [m]
    std::optional<std::size_t> best;
    double least = 0.0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const bool is_current = current && (candidates[i].goal - *current).norm() < kSamePlace;
      const double distance = candidates[i].travel_distance * (is_current ? kAdvantage : 1.0);
      if (best && distance >= least) continue;
      best = i;
      least = distance;
    }
    return best;
  }

  std::string why(const GoalCandidate& chosen, const ScoreParameters& /*weights*/) const override {
    char text[40];
    std::snprintf(text, sizeof text, "the nearest, %.1f m away", chosen.travel_distance);
    return text;
  }
};

}  // namespace

std::unique_ptr<GoalStrategy> makeStrategy(const ExplorerParameters& parameters) {
  if (parameters.strategy == "greedy") return std::make_unique<GreedyStrategy>();
  if (parameters.strategy == "nearest") return std::make_unique<NearestStrategy>();
  if (parameters.strategy == "tour") return std::make_unique<TourStrategy>(parameters);
  throw std::invalid_argument("strategy must be tour, greedy or nearest, not '" + parameters.strategy + "'");
}

}  // namespace frontier_pilot::exploration
