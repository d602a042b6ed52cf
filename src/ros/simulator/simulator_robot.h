#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>

#include <list>
#include <string>

#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/sim/simulator.h"
#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// The topics and frames of one simulated robot: topics in the namespace of its name, frames prefixed by it. A robot
/// without a name has the frames that its description names, in a fleet they are always <name>/odom and
/// <name>/base_footprint.
class SimulatorRobot {
 public:
  SimulatorRobot(const ros::NodeHandle& node, NodeConnections& connections, TfBridge& tf, sim::Simulator& simulator,
                 std::size_t index, const RobotModel& model);

  /// The pose by odometry.
  FramePose odometryPose() const;
  /// Publishes odometry, the ground truth, and whether the robot is in contact.
  void publishState();
  /// Whether the last step has measured a scan.
  bool hasNewScan() const { return simulator_.newScan(index_) != nullptr; }
  /// Publishes the results of the last step: a new scan, and a change of contact.
  void publishNews();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  std::string frame(const std::string& name) const;
  void publishStaticFrames(const RobotModel& model);
  void publishStalled();
  void handleCommand(const geometry_msgs::Twist& msg);

  TfBridge& tf_;
  sim::Simulator& simulator_;
  std::size_t index_;
  std::string base_frame_, odom_frame_;
  double scan_time_;  ///< [s]
  bool stalled_ = false;
  std::string command_topic_;  ///< relative to the node's namespace
  Rejections rejections_;
  ros::Publisher odometry_;
  ros::Publisher truth_;
  ros::Publisher scan_;
  ros::Publisher stalled_topic_;
};

/// Whether the last step has measured a scan of any robot.
bool newScans(const std::list<SimulatorRobot>& robots);
/// Publishes the states of all robots, and their transforms in one message: every node with a TF listener reads every
/// message of /tf.
void publishStates(std::list<SimulatorRobot>& robots, TfBridge& tf, Time now);

}  // namespace frontier_pilot
