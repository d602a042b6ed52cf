#include <algorithm>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {

/// Whether something is left, although not for this robot: others claim it, or they are looking at what this robot's
/// map does not show as reachable, or not any more.
bool Explorer::Impl::leavesWorkToOthers() const {
  return !shared_.alone() && (countRejected(Rejection::kClaimed) > 0 || shared_.othersHaveWork());
}

void Explorer::Impl::standAside(Time now) {
  nothing_left_since_.reset();
  if (status_.state == ExplorerState::kSelectGoal && status_.reason == ExplorerReason::kLeftToOthers) return;
  enter(ExplorerState::kSelectGoal, ExplorerReason::kLeftToOthers, "", now);
}

/// The frontiers of the tour just planned. A robot that goes on to its goal without a new tour goes on with its claims.
void Explorer::Impl::noteClaims() {
  std::vector<Claim> claims;
  for (const Frontier& frontier : evaluator_.frontiers()) {
    if (frontier.place > 0) claims.push_back({evaluator_.map().geometry().centre(frontier.anchor), frontier.cost});
  }
  const bool goes_on = goal_ && claims.empty() && (goal_->position - chosen_.position).norm() < 1e-9;
  if (goes_on && !claims_.empty()) {
    const double passed = toSeconds(last_decision_ - claims_at_);
    for (Claim& claim : claims_) claim.cost = std::max(0.0, claim.cost - passed);
  } else {
    claims_ = std::move(claims);
  }
  claims_at_ = last_decision_;
  shared_.setOwn(claims_);
}

std::vector<Claim> Explorer::Impl::claims() const {
  const bool explores = status_.state != ExplorerState::kIdle && status_.state != ExplorerState::kDone && !ended_by_ &&
                        !done_reason_ && status_.reason != ExplorerReason::kRobotOutOfBounds && !unable_at_;
  if (!explores || !last_update_) return {};
  std::vector<Claim> claims = claims_;
  for (Claim& claim : claims) claim.cost = std::max(0.0, claim.cost - toSeconds(*last_update_ - claims_at_));
  return claims;
}

}  // namespace frontier_pilot::exploration
