#pragma once

#include <string>
#include <vector>

#include "exploration/history/blacklist.h"
#include "exploration/observed_map.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// How earlier goals ended, and what follows for the choice of the next one: where goals were reached, which places are
/// blacklisted because the navigation failed to get there, and which are fruitless because they did not show the area
/// expected of them. Positions are in the map frame [m]; `map` is the current one. [EXP-4] [EXP-5]
class GoalHistory {
 public:
  /// A goal may fail `max_retries` times within the blacklist's radius before its place is blacklisted.
  GoalHistory(const BlacklistParameters& parameters, int max_retries);

  void reached(const Vec2& goal) { reached_.push_back(goal); }
  /// The navigation failed to reach the goal, for the reason that it gave. Returns whether the place is blacklisted
  /// now.
  bool failed(const Vec2& goal, const std::string& reason, const ObservedMap& map);
  /// The goal took too long: its place is blacklisted at once.
  void timedOut(const Vec2& goal, const ObservedMap& map);
  /// A goal was reached, but most of the area expected there stayed unknown: its place is fruitless.
  void stayedUnknown(const Vec2& goal, const ObservedMap& map);
  /// A goal was dropped on the way because nothing was left to see there. Where the cells of thin objects alternate
  /// between free and occupied, the area behind them opens and closes with every scan: a place where this happens for
  /// the third time is fruitless.
  void vanished(const Vec2& goal, const ObservedMap& map);

  /// Why a goal at `place` must not be sent: kBlacklisted, kFruitless, or kNone.
  Rejection judge(const Vec2& place) const;
  /// Goals reached within `radius` [m] of `place`.
  int visits(const Vec2& place, double radius) const;
  const std::vector<BlacklistedPlace>& blacklist() const { return blacklist_.entries(); }

  /// Lifts the entries of both lists around which enough cells have changed.
  void expire(const ObservedMap& map);
  /// The map's counts of changes have restarted: those around the entries are counted from now on.
  void rebase(const ObservedMap& map);
  /// Allows blacklisted places to be tried again, once until `allowRetry`: clears the blacklist and the failures, but
  /// remembers how often each place was listed. Returns false if that has been done already.
  bool retryBlacklisted();
  void allowRetry() { retried_ = false; }
  void reset();

 private:
  Blacklist blacklist_;
  Blacklist fruitless_;
  double radius_;
  int max_retries_;
  std::vector<Vec2> reached_;
  std::vector<Vec2> failed_;
  std::vector<Vec2> vanished_;
  bool retried_ = false;
};

}  // namespace frontier_pilot::exploration
