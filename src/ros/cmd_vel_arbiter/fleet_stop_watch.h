#pragma once

#include <frontier_pilot/FleetStopStatus.h>

#include <string>

#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// Whether the stop of the whole fleet would stop this robot: fleet_stop says once a second whom it reaches. [MUL-4]
class FleetStopWatch {
 public:
  /// An empty `topic` belongs to a robot without a fleet: it never has a problem.
  explicit FleetStopWatch(std::string topic) : topic_(std::move(topic)), since_(steadyNow()) {}

  /// `service` is the resolved name of this robot's stop.
  void listen(NodeConnections& connections, const std::string& service);
  /// What is wrong, as a sentence; empty if nothing is.
  std::string problem(SteadyTime now) const;

 private:
  std::string topic_, service_;
  SteadyTime since_;  ///< that it has been reached; the start, if it never was
  Latest<FleetStopStatus> heard_;
};

}  // namespace frontier_pilot
