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
  /// Lifts the entries around which enough has changed; gives their number.
  std::size_t expire(const ObservedMap& map);
  /// Forgets the entries. How often a place has been listed stays known, as what makes it hard to lift.
  void clear() { entries_.clear(); }
  /// Forgets that as well.
  void reset();
  /// Takes the map as it is now as the reference of every entry: its counts began anew with a new geometry.
  void rebase(const ObservedMap& map);

  /// The entry that covers `position`, or null.
  const BlacklistedPlace* find(const Vec2& position) const;
  const std::vector<BlacklistedPlace>& entries() const { return entries_; }

 private:
  std::uint64_t timesListed(const Vec2& position) const;

  BlacklistParameters parameters_;
  std::vector<BlacklistedPlace> entries_;
  std::vector<Vec2> history_;  ///< where entries have been made since the reset
};

}  // namespace frontier_pilot::exploration
