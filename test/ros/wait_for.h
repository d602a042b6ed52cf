#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <functional>

#include "ros/common/clock.h"

namespace frontier_pilot::test {

/// Waits for what happens on other threads, for 15 s at most; whether it has happened.
inline bool waitFor(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(15.0);
  while (!condition() && ros::WallTime::now() < end) ros::WallDuration(0.02).sleep();
  return condition();
}

/// Serves the callbacks of this process until `condition` holds, which may take what it asks for; false if it does not
/// within `patience`.
inline bool serveUntil(const std::function<bool()>& condition, Duration patience = std::chrono::seconds(10)) {
  const SteadyTime end = steadyNow() + patience;
  while (!condition()) {
    if (steadyNow() >= end) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return true;
}

}  // namespace frontier_pilot::test
