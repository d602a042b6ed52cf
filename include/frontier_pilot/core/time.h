#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

namespace frontier_pilot {

/// A length of time [ns].
using Duration = std::chrono::nanoseconds;

/// ROS time as the algorithms see it: always passed as an argument. The clock has no `now()` on purpose.
struct RobotClock {
  using rep = Duration::rep;
  using period = Duration::period;
  using duration = Duration;
  using time_point = std::chrono::time_point<RobotClock, Duration>;
  static constexpr bool is_steady = false;
};
using Time = RobotClock::time_point;

/// Time that neither stops nor jumps, for liveness checks. A type of its own: it cannot be confused with ROS time.
struct SteadyClock {
  using rep = Duration::rep;
  using period = Duration::period;
  using duration = Duration;
  using time_point = std::chrono::time_point<SteadyClock, Duration>;
  static constexpr bool is_steady = true;
};
using SteadyTime = SteadyClock::time_point;

/// `seconds` [s], rounded to the nearest nanosecond and clamped to 146 years either way; zero for NaN.
inline Duration fromSeconds(double seconds) {
  constexpr double kMost = 4.6e9;  // so that sums of two still fit
  if (std::isnan(seconds)) return Duration::zero();
  return Duration(std::llround(std::clamp(seconds, -kMost, kMost) * 1e9));
}

/// `duration` in [s].
inline double toSeconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// Seconds since the clock's epoch [s].
template <class Clock>
double toSeconds(std::chrono::time_point<Clock, Duration> time) {
  return toSeconds(time.time_since_epoch());
}

/// The time point `seconds` [s] after the epoch.
template <class T = Time>
T timeFromSeconds(double seconds) {
  return T(fromSeconds(seconds));
}

}  // namespace frontier_pilot
