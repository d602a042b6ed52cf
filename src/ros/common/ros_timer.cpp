#include "ros/common/ros_timer.h"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/names.h"

namespace frontier_pilot {

namespace {

constexpr double kLeastWait = 0.002;   ///< before the next look at a real clock, which may be slower than assumed [s]
constexpr double kLongestWait = 0.05;  ///< because a clock may be set, and may be read before roscpp has set it [s]

}  // namespace

RosTimer::RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick)
    : schedule_(period), tick_(std::move(tick)) {
  ros::NodeHandle handle(node);
  poll_ = handle.createSteadyTimer(ros::WallDuration(kLongestWait), [this](const ros::SteadyTimerEvent&) { look(); });
  if (!ros::Time::isSimTime()) return;
  ros::SubscribeOptions options = checkedSubscription<rosgraph_msgs::Clock>(
      names::kClock, 1, unreadable_, [this](const auto&) { look(); }, ros::TransportHints().tcpNoDelay());
  clock_ = handle.subscribe(options);
}

void RosTimer::look() {
  // The clock is read only once: if a tick takes longer than its period, the node has to process its messages before
  // the next tick.
  const Time now = rosNow();
  while (schedule_.isDue(now)) tick_();
  if (clock_) return;
  poll_.setPeriod(ros::WallDuration(std::clamp(toSeconds(schedule_.left(now)), kLeastWait, kLongestWait)));
}

}  // namespace frontier_pilot
