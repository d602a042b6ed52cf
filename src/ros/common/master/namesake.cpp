#include "ros/common/master/namesake.h"

#include <ros/this_node.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "ros/common/clock.h"
#include "ros/common/master/master_state.h"

namespace frontier_pilot {
namespace {

constexpr Duration kLastWords = std::chrono::seconds(2);
constexpr std::chrono::milliseconds kLook(200);

}  // namespace

std::string waitUntilGone(const std::function<std::string()>& find) {
  const SteadyTime end = steadyNow() + kLastWords;
  std::string other = find();
  while (!other.empty() && steadyNow() < end) {
    std::this_thread::sleep_for(kLook);
    other = find();
  }
  return other;
}

void refuseANamesake() {
  const std::string& self = ros::this_node::getName();
  if (waitUntilGone([&self] { return nodeLives(self) ? self : std::string(); }).empty()) return;
  throw std::runtime_error("a node " + self + " runs already, and ROS would end it for this one: end it first " +
                           "(rosnode kill " + self + "), or start this one under another name (__name:=...)");
}

}  // namespace frontier_pilot
