#pragma once

#include <deque>
#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/scan_verdict.h"

namespace frontier_pilot::mapping {

/// What has been remarkable about the scans of late: the line to read at a glance, where counts since the beginning
/// would hide it.
class MappingHealth {
 public:
  /// What is to be said of a scan; nullptr: nothing, it is in the map and so is the robot.
  void add(Time now, const char* remark);
  /// The most frequent remark of the last seconds, if it was more than a slip.
  std::optional<ScanRemark> worst(Time now) const;

 private:
  struct Entry {
    Time time;
    const char* remark;
  };
  std::deque<Entry> entries_;
};

}  // namespace frontier_pilot::mapping
