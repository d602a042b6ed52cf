#include "frontier_pilot/ros/ros_timer.h"

#include <algorithm>
#include <utility>

#include "frontier_pilot/ros/clock.h"

namespace frontier_pilot {

namespace {

constexpr double kSimulatedPoll = 0.002;  ///< a simulated clock may run much faster than the real one [s]
constexpr double kSlowestPoll = 0.01;     ///< [s]
constexpr int kMostAtOnce = 10;           ///< ticks that a fast simulation makes due between two looks

/// How often the clock is looked at: a real one ten times in a period.
ros::WallDuration pollPeriod(Duration period) {
  if (ros::Time::isSimTime()) return ros::WallDuration(kSimulatedPoll);
  return ros::WallDuration(std::clamp(0.1 * toSeconds(period), kSimulatedPoll, kSlowestPoll));
}

}  // namespace

RosTimer::RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick)
    : schedule_(period), tick_(std::move(tick)) {
  poll_ = ros::NodeHandle(node).createSteadyTimer(pollPeriod(period), [this](const ros::SteadyTimerEvent&) { poll(); });
}

void RosTimer::poll() {
  for (int i = 0; i < kMostAtOnce && schedule_.isDue(rosNow()); ++i) tick_();
}

}  // namespace frontier_pilot
