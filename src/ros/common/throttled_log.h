#pragma once

#include <ros/console.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>

#include "frontier_pilot/core/time.h"

/// Log lines that anybody on the network can bring about as often as they like: a service that is called in a loop, a
/// goal that is sent again and again. Each line of the source code may speak `LogThrottle::kBurst` times in a row and
/// then once a second, so that ordinary work is logged as it always was and a flood cannot fill the disk.
///
///     THROTTLED_INFO("saved " << path);
///
/// A line's budget is its own: "stopped" and "cleared" in two lines of code do not take each other's place.
namespace frontier_pilot {

/// The budget of one log line: a bucket of tokens, filled on steady time.
class LogThrottle {
 public:
  static constexpr std::uint64_t kBurst = 20;                   ///< lines at once
  static constexpr Duration kPeriod = std::chrono::seconds(1);  ///< in which one more is allowed

  /// How many lines were left out since the last one that was admitted; nothing if this one is left out as well. May
  /// be called from any thread.
  std::optional<std::uint64_t> admit(SteadyTime now);

 private:
  std::mutex mutex_;
  std::uint64_t tokens_ = kBurst;
  std::optional<SteadyTime> filled_;
  std::uint64_t left_out_ = 0;
};

/// The line as it is logged: cut to a length that what came in with a request cannot exceed, on one line, with the
/// number of those that were left out before it.
std::string throttledLine(const std::string& text, std::uint64_t left_out);

/// `admit` at the present steady time.
std::optional<std::uint64_t> admitNow(LogThrottle& throttle);

}  // namespace frontier_pilot

// Macros, because a log line says where in the source code it stands, and its budget belongs to that place. In
// parentheses `stream` would be an expression of its own, without the stream that it is written to.
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
#define THROTTLED_INFO(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Info, stream)
#define THROTTLED_WARN(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Warn, stream)
#define THROTTLED_ERROR(stream) FRONTIER_PILOT_THROTTLED(::ros::console::levels::Error, stream)
