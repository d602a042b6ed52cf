#pragma once

#include <chrono>
#include <optional>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// For a line about an input that may be wrong again and again, and is counted: one line in five seconds. See
/// LogThrottle for lines that are logged in full in ordinary operation.
class LogInterval {
 public:
  /// Whether a line may be written at `now`, which then counts as the last one.
  bool admit(SteadyTime now) {
    if (last_ && now - *last_ < kPeriod) return false;
    last_ = now;
    return true;
  }

 private:
  static constexpr Duration kPeriod = std::chrono::seconds(5);

  std::optional<SteadyTime> last_;
};

}  // namespace frontier_pilot
