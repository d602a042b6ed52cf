#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exploration/observed_map.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Places that are not to be tried again until the map around them changes. [EXP-5]
class Blacklist {
 public:
  explicit Blacklist(const BlacklistParameters& parameters) : parameters_(parameters) {}

  void add(const Vec2& position, const std::string& reason, const ObservedMap& map);
  /// Lifts the entries around which enough cells have changed; returns how many.
  std::size_t expire(const ObservedMap& map);
  /// Removes the entries but remembers how often each place was listed: a repeated entry needs more changes to be
  /// lifted.
  void clear() { entries_.clear(); }
  /// Removes the entries and forgets how often places were listed.
  void reset();
  /// Compares every entry with the change counts of `map` from now on: they have restarted.
  void rebase(const ObservedMap& map);

  /// The entry that covers `position`, or null.
  const BlacklistedPlace* find(const Vec2& position) const;
  const std::vector<BlacklistedPlace>& entries() const { return entries_; }

 private:
  std::uint64_t timesListed(const Vec2& position) const;

  BlacklistParameters parameters_;
  std::vector<BlacklistedPlace> entries_;
  std::vector<Vec2> history_;  ///< positions of all entries made since the last reset
};

}  // namespace frontier_pilot::exploration
