#include "ros/common/throttled_log.h"

#include <algorithm>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

std::optional<std::uint64_t> LogThrottle::admit(SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const SteadyTime filled = filled_.value_or(now);
  const auto periods = static_cast<std::uint64_t>(std::max<Duration::rep>(0, (now - filled) / kPeriod));
  tokens_ = std::min(kBurst, tokens_ + std::min(kBurst, periods));
  // The rest of a period that has begun counts towards the next token.
  filled_ = tokens_ == kBurst ? now : filled + kPeriod * static_cast<Duration::rep>(periods);
  if (tokens_ == 0) {
    ++left_out_;
    return std::nullopt;
  }
  --tokens_;
  return std::exchange(left_out_, 0);
}

std::optional<std::uint64_t> admitNow(LogThrottle& throttle) { return throttle.admit(steadyNow()); }

std::string throttledLine(const std::string& text, std::uint64_t left_out) {
  std::string line = printable(text, bounds::kMostLine);
  if (left_out > 0) line += " (" + std::to_string(left_out) + " similar lines suppressed before it)";
  return line;
}

}  // namespace frontier_pilot
