#pragma once

#include <ros/time.h>

#include <functional>

namespace frontier_pilot::test {

/// Waits for what happens on other threads, for 15 s at most; whether it has happened.
inline bool waitFor(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(15.0);
  while (!condition() && ros::WallTime::now() < end) ros::WallDuration(0.02).sleep();
  return condition();
}

}  // namespace frontier_pilot::test
