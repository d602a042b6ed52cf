#include "ros/cmd_vel_arbiter/fleet_stop_watch.h"

#include <algorithm>

#include "ros/common/clock.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

/// Three messages, or the restart of fleet_stop by its launch file.
constexpr Duration kPatience = std::chrono::seconds(4);

}  // namespace

void FleetStopWatch::listen(NodeConnections& connections, const std::string& service) {
  service_ = service;
  if (topic_.empty()) return;
  connections.subscribe<FleetStopStatus>(topic_, 2, [this](const FleetStopStatus& msg) {
    heard_.put(msg, steadyNow());
    if (std::find(msg.reached.begin(), msg.reached.end(), service_) != msg.reached.end()) since_ = steadyNow();
  });
}

std::string FleetStopWatch::problem(SteadyTime now) const {
  if (topic_.empty() || now - since_ <= kPatience) return {};
  const std::string stop = std::string(names::kFleetEmergencyStop) + " does not stop this robot: ";
  if (!heard_.fresh(now, kPatience)) return stop + "nothing has been heard on " + topic_ + " for some seconds";
  return stop + "fleet_stop does not reach " + service_;
}

}  // namespace frontier_pilot
