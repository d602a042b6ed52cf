#pragma once

#include <ros/time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

#include "frontier_pilot/core/time.h"

/// The only place where the nodes read a clock, or convert between ROS times and their own. These conversions saturate
/// at the limits of ROS time, where roscpp's throw.
///
/// Control logic ticks on ROS time (`RosTimer`, `rosNow`), so that it follows a simulation at any speed. Liveness, that
/// is the age of a message or a heartbeat, has to be judged while the ROS clock stands still or jumps: it uses steady
/// time (`ros::SteadyTimer`, `steadyNow`). `ros::WallTimer` follows the wall clock, which may be set: it is not used.
namespace frontier_pilot {

inline Time toTime(const ros::Time& time) {
  return Time(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec));
}

/// The nearest time that ROS can represent: the epoch for earlier times, and the last second that fits into 32 bits (in
/// the year 2106) for later ones. roscpp's own conversion throws.
inline ros::Time toRosTime(Time time) {
  const auto nanoseconds = time.time_since_epoch().count();
  constexpr auto kLast = std::int64_t{std::numeric_limits<std::uint32_t>::max()} * 1'000'000'000;
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, kLast)));
}

inline Duration toDuration(const ros::Duration& duration) {
  return std::chrono::seconds(duration.sec) + std::chrono::nanoseconds(duration.nsec);
}
/// The nearest duration that ROS can represent: 68 years at most.
inline ros::Duration toRosDuration(Duration duration) {
  constexpr auto kLongest = std::int64_t{std::numeric_limits<std::int32_t>::max()} * 1'000'000'000;
  return ros::Duration().fromNSec(std::clamp<std::int64_t>(duration.count(), -kLongest, kLongest));
}
/// A duration of `seconds` [s]; zero for NaN.
inline ros::Duration toRosDuration(double seconds) { return toRosDuration(fromSeconds(seconds)); }

/// ROS time; with simulated time the epoch until the first /clock.
inline Time rosNow() { return toTime(ros::Time::now()); }

inline SteadyTime steadyNow() {
  return SteadyTime(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

}  // namespace frontier_pilot
