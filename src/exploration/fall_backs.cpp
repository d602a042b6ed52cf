#include <array>
#include <string>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {

/// Tried in this order until one helps. If none does, the explorer waits done_settle_time for the map to change and is
/// then done.
const std::array<Explorer::Impl::FallBack, 5> Explorer::Impl::kFallBacks{{
    {"tight ways", FallBack::Scope::kEveryDecision, &Impl::judgeTightWays},
    {"ways from the start", FallBack::Scope::kEveryDecision, &Impl::judgeWaysFromStart},
    {"coverage", FallBack::Scope::kWithoutGoal, &Impl::goOnToCoverage},
    {"stepping back", FallBack::Scope::kWithoutGoal, &Impl::stepBack},
    {"blacklisted places once more", FallBack::Scope::kWithoutGoal, &Impl::retryBlacklisted},
}};

/// The first fall-back of the scope that helps; null if none does.
const Explorer::Impl::FallBack* Explorer::Impl::fallBack(FallBack::Scope scope, Time now) {
  for (const FallBack& candidate : kFallBacks) {
    if (candidate.scope == scope && (this->*candidate.attempt)(now)) return &candidate;
  }
  return nullptr;
}

/// Not tried if some frontiers were not judged: one of them might be selectable without tight ways.
bool Explorer::Impl::judgeTightWays(Time /*now*/) {
  return evaluator_.allJudged() && evaluator_.evaluateTightWays(context());
}

/// For a robot that the map shows as cut off from its start: it came from there, so the navigation may find the way
/// back.
bool Explorer::Impl::judgeWaysFromStart(Time /*now*/) {
  return evaluator_.allJudged() && evaluator_.evaluateWaysFromStart(context());
}

/// The text of the transition says how many frontiers are left for COVERAGE: those that can be selected and those that
/// `rich_min_density` has held back.
bool Explorer::Impl::goOnToCoverage(Time now) {
  if (status_.phase == ExplorerPhase::kCoverage) return false;
  status_.phase = ExplorerPhase::kCoverage;
  const std::size_t left = countRejected(Rejection::kNone) + countRejected(Rejection::kNotRich);
  const std::string text = std::string(toString(ExplorerReason::kRichFrontiersExhausted)) +
                           ", others that can be selected: " + std::to_string(left);
  enter(status_.state, ExplorerReason::kRichFrontiersExhausted, text, now);
  return true;
}

/// Drives a short distance away, so that frontiers that are too near become far enough to be goals.
bool Explorer::Impl::stepBack(Time now) {
  constexpr int kMaxStepBacks = 3;  // in a row; frontiers that are then still too near are given up
  if (countRejected(Rejection::kTooNear) == 0 || step_backs_ >= kMaxStepBacks) return false;
  const std::optional<Vec2> place = evaluator_.placeToStepBackTo(T_map_base_->position());
  if (!place) return false;
  ++step_backs_;
  Goal goal;
  goal.position = *place;
  goal.purpose = Goal::Purpose::kStepBack;
  goal.yaw = T_map_base_->yaw;
  send(goal, ExplorerReason::kGoalSent, "stepping back from a frontier that is too near", now);
  return true;
}

bool Explorer::Impl::retryBlacklisted(Time now) {
  if (countRejected(Rejection::kBlacklisted) == 0 || !history_.retryBlacklisted()) return false;
  note(true, toString(ExplorerReason::kBlacklistSaturated));
  enter(ExplorerState::kSelectGoal, ExplorerReason::kBlacklistSaturated, "", now);
  return true;
}

}  // namespace frontier_pilot::exploration
