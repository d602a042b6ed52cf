#pragma once

#include <frontier_pilot/RemoveObstacle.h>
#include <frontier_pilot/SetPose.h>
#include <frontier_pilot/SpawnObstacle.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>

#include <list>
#include <vector>

#include "frontier_pilot/sim/real_time_pacer.h"
#include "frontier_pilot/sim/simulator.h"
#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/simulator/simulator_robot.h"

namespace frontier_pilot {

struct SimulatorNodeParameters : sim::SimulatorParameters {
  double state_rate = 50.0;  ///< of odometry, ground truth and the transform of odometry [Hz]
  bool common_map = false;   ///< whether the robots' maps lie in a common one, see describe

  template <class Visitor>
  void describe(Visitor& v) {
    sim::SimulatorParameters::describe(v);
    v.fixed({"state_rate"});
    v.field(
        "common_map", common_map, "",
        "several robots: whether `map_merger` places the robots' maps in the frame `map`, which then begins where the "
        "first robot does; otherwise each map frame is placed in the world");
  }

  void check(Problems& problems) const {
    sim::SimulatorParameters::check(problems);
    if (world.empty()) problems.emplace_back("world: missing; name a map_server YAML");
  }
};

/// The node `simulator`: steps the simulator at the requested speed, publishes /clock and the robots' topics, and
/// serves its services. [SIM-4]
class SimulatorAdapter {
 public:
  /// Throws a ConfigurationError, or std::runtime_error if the world cannot be loaded or a robot cannot start in it.
  SimulatorAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);

 private:
  void advertise(ros::NodeHandle& node);
  void publishWorld();
  void tick();
  void step();
  void publishClock();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  bool resetPositions(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response);
  bool setPose(SetPose::Request& request, SetPose::Response& response);
  bool spawnObstacle(SpawnObstacle::Request& request, SpawnObstacle::Response& response);
  bool removeObstacle(RemoveObstacle::Request& request, RemoveObstacle::Response& response);
  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  SimulatorNodeParameters parameters_;
  sim::Simulator simulator_;
  sim::RealTimePacer pace_;
  TfBridge tf_;
  std::list<SimulatorRobot> robots_;
  Duration state_period_;
  Time next_state_{}, clock_published_{};
  bool paused_ = false;
  Time reported_sim_{};
  SteadyTime reported_real_{};
  ros::Publisher clock_;
  ros::Publisher world_;
  NodeDiagnostics diagnostics_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
