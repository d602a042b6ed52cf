#pragma once

#include <ros/time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

#include "frontier_pilot/core/time.h"

/// The only place where the nodes read a clock, or turn what came in into a ROS time: conversions saturate, where those
/// of roscpp throw.
///
/// Control logic ticks on ROS time (`RosTimer`, `rosNow`), so that it follows a simulation at any speed. Liveness,
/// that is the age of a message or a heartbeat that must survive a stopped or jumping clock, is on steady time
/// (`ros::SteadyTimer`, `steadyNow`). `ros::WallTimer` follows the wall clock, which may be set: it is not used.
namespace frontier_pilot {

inline Time toTime(const ros::Time& time) {
  return Time(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec));
}

/// The nearest time that ROS has: the epoch for what lies before it, the last second of the year 2106 for what lies
/// beyond. roscpp's own conversion throws.
inline ros::Time toRosTime(Time time) {
  const auto nanoseconds = time.time_since_epoch().count();
  constexpr auto kLast = std::int64_t{std::numeric_limits<std::uint32_t>::max()} * 1'000'000'000;
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, kLast)));
}

inline Duration toDuration(const ros::Duration& duration) {
  return std::chrono::seconds(duration.sec) + std::chrono::nanoseconds(duration.nsec);
}
/// The nearest duration that ROS has: 68 years at most.
inline ros::Duration toRosDuration(Duration duration) {
  constexpr auto kLongest = std::int64_t{std::numeric_limits<std::int32_t>::max()} * 1'000'000'000;
  return ros::Duration().fromNSec(std::clamp<std::int64_t>(duration.count(), -kLongest, kLongest));
}
/// Of `seconds` [s]; zero if they are not a number.
inline ros::Duration toRosDuration(double seconds) { return toRosDuration(fromSeconds(seconds)); }

/// ROS time; the epoch until the first /clock when it is simulated.
inline Time rosNow() { return toTime(ros::Time::now()); }

inline SteadyTime steadyNow() {
  return SteadyTime(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

}  // namespace frontier_pilot
