#pragma once

#include <string>
#include <vector>

#include "exploration/blacklist.h"
#include "exploration/observed_map.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// How earlier goals ended, and what that says of places that are considered as the next one: where goals were reached,
/// which places are blacklisted because the navigation failed to get there, and which are fruitless because they did
/// not show what they promised. Positions are in the map's frame [m]; `map` is the present one. [EXP-4] [EXP-5]
class GoalHistory {
 public:
  /// A goal may fail `max_retries` times within the blacklist's radius before its place is blacklisted.
  GoalHistory(const BlacklistParameters& parameters, int max_retries);

  void reached(const Vec2& goal) { reached_.push_back(goal); }
  /// The navigation did not get there, for the reason that it gives. Gives whether the place is blacklisted now.
  bool failed(const Vec2& goal, const std::string& reason, const ObservedMap& map);
  /// It took too long: blacklisted at once.
  void timedOut(const Vec2& goal, const ObservedMap& map);
  /// A goal was reached and still promises what it promised before: it will never show it, and is fruitless.
  void stayedUnknown(const Vec2& goal, const ObservedMap& map);
  /// A goal was dropped on the way because nothing was left to see there. Where thin things flicker between free and
  /// occupied, what lies behind them comes into sight and goes again with every scan: a place where this happens for
  /// the third time is fruitless.
  void vanished(const Vec2& goal, const ObservedMap& map);

  /// Why a goal at `place` is not to be sent: kBlacklisted, kFruitless, or kNone.
  Rejection judge(const Vec2& place) const;
  /// Goals reached within `radius` [m] of `place`.
  int visits(const Vec2& place, double radius) const;
  const std::vector<BlacklistedPlace>& blacklist() const { return blacklist_.entries(); }

  /// Lifts the entries of both lists around which enough has changed.
  void expire(const ObservedMap& map);
  /// The map has a new geometry: what has changed around the entries is counted from now on.
  void rebase(const ObservedMap& map);
  /// Gives what is blacklisted another try, once until `allowRetry`: forgets the blacklist and the failures. How often
  /// a place has been listed stays known, as what makes it hard to lift. Gives false when that has been done already.
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
