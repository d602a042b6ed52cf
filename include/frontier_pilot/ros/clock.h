#pragma once

#include <ros/time.h>

#include <chrono>

#include "frontier_pilot/core/time.h"

/// The only place where the nodes read a clock.
///
/// Control logic ticks on ROS time (`ros::Timer`, `rosNow`), so that it follows a simulation at any speed. Liveness,
/// that is the age of a message or a heartbeat that must survive a stopped or jumping clock, is on steady time
/// (`ros::SteadyTimer`, `steadyNow`). `ros::WallTimer` follows the wall clock, which may be set: it is not used.
namespace frontier_pilot {

inline Time toTime(const ros::Time& time) {
  return Time(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec));
}

/// The epoch if `time` lies before it: ROS has no earlier one.
inline ros::Time toRosTime(Time time) {
  const auto nanoseconds = time.time_since_epoch().count();
  return nanoseconds <= 0 ? ros::Time() : ros::Time().fromNSec(static_cast<std::uint64_t>(nanoseconds));
}

inline Duration toDuration(const ros::Duration& duration) { return Duration(duration.toNSec()); }
inline ros::Duration toRosDuration(Duration duration) { return ros::Duration().fromNSec(duration.count()); }

/// ROS time; the epoch until the first /clock when it is simulated.
inline Time rosNow() { return toTime(ros::Time::now()); }

inline SteadyTime steadyNow() {
  return SteadyTime(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

}  // namespace frontier_pilot
