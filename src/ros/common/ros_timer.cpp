#include "ros/common/ros_timer.h"

#include <algorithm>
#include <utility>

#include "ros/common/clock.h"

namespace frontier_pilot {

namespace {

constexpr double kSimulatedPoll = 0.005;  ///< a simulated clock may run much faster than the real one [s]
constexpr double kFastestPoll = 0.002;    ///< [s]
constexpr double kSlowestPoll = 0.01;     ///< [s]

/// How often the clock is looked at: a real one ten times in a period.
ros::WallDuration pollPeriod(Duration period) {
  if (ros::Time::isSimTime()) return ros::WallDuration(kSimulatedPoll);
  return ros::WallDuration(std::clamp(0.1 * toSeconds(period), kFastestPoll, kSlowestPoll));
}

}  // namespace

RosTimer::RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick)
    : schedule_(period), tick_(std::move(tick)) {
  poll_ = ros::NodeHandle(node).createSteadyTimer(pollPeriod(period), [this](const ros::SteadyTimerEvent&) { poll(); });
}

void RosTimer::poll() {
  // The time of this look alone: a tick that takes longer than its period must not be followed by the next one before
  // the node has taken in its messages.
  const Time now = rosNow();
  while (schedule_.isDue(now)) tick_();
}

}  // namespace frontier_pilot
