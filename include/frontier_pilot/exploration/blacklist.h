#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/exploration/observed_map.h"

namespace frontier_pilot::exploration {

struct BlacklistParameters {
  double radius = 0.60;
  double change_radius = 1.0;
  int change_cells = 20;

  template <class V>
  void describe(V& v) {
    v.field("radius", radius, "m", "a frontier whose goal is within this of a blacklisted goal is not tried",
            positive());
    v.fixed({"change_radius", "change_cells"});
  }
};

/// Places that are not to be tried again until the map around them changes. [EXP-5]
class Blacklist {
 public:
  struct Entry {
    Vec2 position = Vec2::Zero();  ///< in the map's frame [m]
    std::string reason;
    std::uint64_t changes_then = 0;
    std::uint64_t changes_to_lift = 0;
  };

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
  const Entry* find(const Vec2& position) const;
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::uint64_t timesListed(const Vec2& position) const;

  BlacklistParameters parameters_;
  std::vector<Entry> entries_;
  std::vector<Vec2> history_;  ///< where entries have been made since the reset
};

}  // namespace frontier_pilot::exploration
