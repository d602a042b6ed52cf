#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>
#include <vector>

#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/fleet_stop/fleet_stop_parameters.h"
#include "ros/fleet_stop/known_robots.h"
#include "ros/fleet_stop/regained_services.h"
#include "ros/fleet_stop/stop_line.h"

namespace frontier_pilot {

/// The node `fleet_stop`: `fleet/emergency_stop` stops every robot, and answers when each has confirmed it or after
/// `patience`, naming those that have not. It keeps no stop itself: that is in each robot's arbiter, and is cleared
/// there. The arbiters listen to its status, so that its death does not go unnoticed. [MUL-4]
class FleetStopAdapter {
 public:
  FleetStopAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  ~FleetStopAdapter();
  FleetStopAdapter(const FleetStopAdapter&) = delete;
  FleetStopAdapter& operator=(const FleetStopAdapter&) = delete;

 private:
  using Call = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;

  bool handleStop(Call& call);
  /// Whether this robot is stopped with the others: there may be too many.
  bool addRobot(const std::string& service);
  /// Adds the robots whose arbiters the master knows.
  void takeMasterReport();
  /// Drops the lines to robots that have been gone for long.
  void forgetRobots();
  bool canStop(const StopLine& line) const { return line.connected() && !has_rival_; }
  void tick();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  FleetStopParameters parameters_;
  ros::NodeHandle node_;
  KnownRobots known_;
  RegainedServices regained_;
  std::vector<std::unique_ptr<StopLine>> lines_;      ///< to each that is known
  std::vector<std::unique_ptr<StopLine>> forgotten_;  ///< whose threads have not ended yet
  ros::Publisher status_;
  std::vector<std::string> not_reached_;  ///< as published last
  bool has_rival_ = false;                ///< another node has fleet/emergency_stop, and gets the calls
  SteadyTime published_{};
  std::string last_stop_;  ///< the answer to the last call; empty before the first
  NodeDiagnostics diagnostics_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
