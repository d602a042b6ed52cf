#include "exploration/history/blacklist.h"

#include <algorithm>

namespace frontier_pilot::exploration {

void Blacklist::add(const Vec2& position, const std::string& reason, const ObservedMap& map) {
  constexpr std::uint64_t kMaxDoublings = 16;
  const std::uint64_t doublings = std::min(timesListed(position), kMaxDoublings);
  entries_.push_back({position, reason, map.changesAround(position, parameters_.change_radius),
                      static_cast<std::uint64_t>(parameters_.change_cells) << doublings});
  history_.push_back(position);
}

std::size_t Blacklist::expire(const ObservedMap& map) {
  const auto changes = [&](const BlacklistedPlace& entry) {
    return map.changesAround(entry.position, parameters_.change_radius);
  };
  for (BlacklistedPlace& entry : entries_) {
    entry.changes_then = std::min(entry.changes_then, changes(entry));  // fewer where the map has become smaller
  }
  const auto lifted = std::remove_if(entries_.begin(), entries_.end(), [&](const BlacklistedPlace& entry) {
    return changes(entry) >= entry.changes_then + entry.changes_to_lift;
  });
  const auto count = static_cast<std::size_t>(entries_.end() - lifted);
  entries_.erase(lifted, entries_.end());
  return count;
}

void Blacklist::reset() {
  entries_.clear();
  history_.clear();
}

void Blacklist::rebase(const ObservedMap& map) {
  for (BlacklistedPlace& entry : entries_)
    entry.changes_then = map.changesAround(entry.position, parameters_.change_radius);
}

const BlacklistedPlace* Blacklist::find(const Vec2& position) const {
  for (const BlacklistedPlace& entry : entries_) {
    if ((entry.position - position).norm() <= parameters_.radius) return &entry;
  }
  return nullptr;
}

std::uint64_t Blacklist::timesListed(const Vec2& position) const {
  return static_cast<std::uint64_t>(std::count_if(history_.begin(), history_.end(), [&](const Vec2& listed) {
    return (listed - position).norm() <= parameters_.radius;
  }));
}

}  // namespace frontier_pilot::exploration
