#pragma once

#include <ros/console.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>

#include "frontier_pilot/core/time.h"

/// For log lines that anybody on the network can cause as often as they like, by calling a service in a loop or sending
/// a goal again and again. Each log statement may print `LogThrottle::kBurst` lines in a row and then one a second, so
/// that ordinary operation is logged in full and a flood cannot fill the disk.
///
///     THROTTLED_INFO("saved " << path);
///
/// Each statement has a budget of its own: a flood of "stopped" does not suppress "cleared".
namespace frontier_pilot {

/// The budget of one log statement: a token bucket, refilled on steady time.
class LogThrottle {
 public:
  static constexpr std::uint64_t kBurst = 20;                   ///< lines at once
  static constexpr Duration kPeriod = std::chrono::seconds(1);  ///< in which one more is allowed

  /// How many lines were suppressed since the last one that was admitted; nothing if this one is suppressed as well.
  /// May be called from any thread.
  std::optional<std::uint64_t> admit(SteadyTime now);

 private:
  std::mutex mutex_;
  std::uint64_t tokens_ = kBurst;
  std::optional<SteadyTime> filled_;
  std::uint64_t left_out_ = 0;
};

/// The line as it is logged: escaped onto one line and cut to a maximum length, however long the input it quotes, with
/// the number of lines that were suppressed before it.
std::string throttledLine(const std::string& text, std::uint64_t left_out);

/// `admit` at the present steady time.
std::optional<std::uint64_t> admitNow(LogThrottle& throttle);

}  // namespace frontier_pilot

// Macros, because a log line contains its place in the source code, and the budget belongs to that place. `stream`
// cannot be parenthesised: it continues the expression that starts with the output stream.
#define FRONTIER_PILOT_THROTTLED(level, stream)                                         \
  do {                                                                                  \
    static ::frontier_pilot::LogThrottle line_throttle;                                 \
    if (const auto line_left_out = ::frontier_pilot::admitNow(line_throttle)) {         \
      std::ostringstream line_text;                                                     \
      line_text << stream; /* NOLINT(bugprone-macro-parentheses) */                     \
      ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME,                                    \
                     ::frontier_pilot::throttledLine(line_text.str(), *line_left_out)); \
    }                                                                                   \
  } while (false)
#define THROTTLED_LOG(level, stream) FRONTIER_PILOT_THROTTLED(level, stream)
#define THROTTLED_INFO(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Info, stream)
#define THROTTLED_WARN(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Warn, stream)
#define THROTTLED_ERROR(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Error, stream)
