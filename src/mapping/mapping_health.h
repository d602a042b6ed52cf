#pragma once

#include <deque>
#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::mapping {

/// Scans are inserted, but only where the map has cells already.
constexpr const char* kMemoryUsedUp =
    "nothing new is mapped, max_memory of the map is used up: raise it, choose a coarser resolution or a smaller "
    "max_clear_range";

/// Problems with the scans of the last seconds, for a summary at a glance: counts since the start would hide a recent
/// one. Of very many scans only the last thousand count. [FLT-1]
class MappingHealth {
 public:
  /// Adds the problem with a scan, a text that outlives this object; nullptr: there was none.
  void add(Time now, const char* remark);
  /// The most frequent problem of the last seconds, if it was not just a few scans.
  std::optional<ScanRemark> worst(Time now) const;

 private:
  struct Entry {
    Time time;
    const char* remark;
  };
  std::deque<Entry> entries_;
};

}  // namespace frontier_pilot::mapping
