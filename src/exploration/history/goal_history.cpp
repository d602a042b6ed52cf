#include "exploration/history/goal_history.h"

#include <algorithm>

namespace frontier_pilot::exploration {
namespace {

int countNear(const std::vector<Vec2>& places, const Vec2& centre, double radius) {
  return static_cast<int>(std::count_if(places.begin(), places.end(),
                                        [&](const Vec2& place) { return (place - centre).norm() <= radius; }));
}

/// Half the radius: the robot has been at a fruitless place or has seen it, so it is known better than a blacklisted
/// one.
BlacklistParameters fruitlessParameters(BlacklistParameters parameters) {
  parameters.radius /= 2.0;
  return parameters;
}

}  // namespace

GoalHistory::GoalHistory(const BlacklistParameters& parameters, int max_retries)
    : blacklist_(parameters),
      fruitless_(fruitlessParameters(parameters)),
      radius_(parameters.radius),
      max_retries_(max_retries) {}

bool GoalHistory::failed(const Vec2& goal, const std::string& reason, const ObservedMap& map) {
  failed_.push_back(goal);
  if (countNear(failed_, goal, radius_) <= max_retries_) return false;
  blacklist_.add(goal, reason, map);
  return true;
}

void GoalHistory::timedOut(const Vec2& goal, const ObservedMap& map) {
  failed_.push_back(goal);
  blacklist_.add(goal, "timed out", map);
}

void GoalHistory::stayedUnknown(const Vec2& goal, const ObservedMap& map) {
  fruitless_.add(goal, "reached, but the area expected there stayed unknown", map);
}

void GoalHistory::vanished(const Vec2& goal, const ObservedMap& map) {
  constexpr double kSamePlace = 0.5;  // [m]
  constexpr int kMaxTimes = 2;
  const auto times = std::count_if(vanished_.begin(), vanished_.end(),
                                   [&](const Vec2& place) { return (place - goal).norm() < kSamePlace; });
  vanished_.push_back(goal);
  if (times >= kMaxTimes) fruitless_.add(goal, "the area expected there appeared and disappeared repeatedly", map);
}

Rejection GoalHistory::judge(const Vec2& place) const {
  if (blacklist_.find(place) != nullptr) return Rejection::kBlacklisted;
  return fruitless_.find(place) != nullptr ? Rejection::kFruitless : Rejection::kNone;
}

int GoalHistory::visits(const Vec2& place, double radius) const { return countNear(reached_, place, radius); }

void GoalHistory::expire(const ObservedMap& map) {
  blacklist_.expire(map);
  fruitless_.expire(map);
}

void GoalHistory::rebase(const ObservedMap& map) {
  blacklist_.rebase(map);
  fruitless_.rebase(map);
}

bool GoalHistory::retryBlacklisted() {
  if (retried_) return false;
  retried_ = true;
  blacklist_.clear();
  failed_.clear();
  return true;
}

void GoalHistory::reset() {
  blacklist_.reset();
  fruitless_.reset();
  reached_.clear();
  failed_.clear();
  vanished_.clear();
  retried_ = false;
}

}  // namespace frontier_pilot::exploration
