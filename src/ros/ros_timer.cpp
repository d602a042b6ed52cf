#include "frontier_pilot/ros/ros_timer.h"

#include <utility>

#include "frontier_pilot/ros/clock.h"

namespace frontier_pilot {

namespace {

constexpr double kClockPoll = 0.001;  ///< as often as roscpp looks at a simulated clock [s]
constexpr int kMostAtOnce = 10;       ///< ticks that a fast simulation makes due between two looks

}  // namespace

RosTimer::RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick)
    : schedule_(period), tick_(std::move(tick)) {
  poll_ = ros::NodeHandle(node).createSteadyTimer(ros::WallDuration(kClockPoll),
                                                  [this](const ros::SteadyTimerEvent&) { poll(); });
}

void RosTimer::poll() {
  for (int i = 0; i < kMostAtOnce && schedule_.isDue(rosNow()); ++i) tick_();
}

}  // namespace frontier_pilot
