#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>

#include <optional>
#include <string>

#include "frontier_pilot/avoid/avoider.h"
#include "ros/common/diagnostics.h"
#include "ros/common/inputs/earlier_stops.h"
#include "ros/common/memory/safe_switch.h"
#include "ros/common/messages/scan_motion_report.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/tuning/reconfigure_server.h"

namespace frontier_pilot {

/// The parameters of the node: those of the avoider, and the node's own.
struct ObstacleAvoiderNodeParameters {
  avoid::AvoiderParameters avoider;
  std::string base_frame;  ///< empty: the robot's
  bool enabled = true;

  template <class Visitor>
  void describe(Visitor& v) {
    avoider.describe(v);
    v.field("base_frame", base_frame, "", "frame that the sectors refer to; empty: robot/base_frame",
            FrameName::kMayBeEmpty);
    v.field("enabled", enabled, "", "whether it is enabled at the start");
  }
  void check(Problems& problems) const { avoider.check(problems); }
};

/// The node `obstacle_avoider`: hands each scan, with the scanner's mount, to the avoider and publishes its commands.
/// Odometry only serves to put the beams of rolling scans where the robot was; without it scans are used as they are.
class ObstacleAvoiderAdapter {
 public:
  ObstacleAvoiderAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Publishes one all-zero command, with which the avoider gives up the wheels.
  void sayLastWords();

 private:
  void handleScan(const sensor_msgs::LaserScan& msg);
  void handleOdometry(const nav_msgs::Odometry& msg);
  std::optional<LaserScan2> read(const sensor_msgs::LaserScan& msg, std::string* why);
  bool handleEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void handleStop(const std_msgs::Bool& msg);
  void handleArbiter(const ArbiterStatus& msg);
  void handleCommand(const geometry_msgs::Twist& msg);
  void followStops();
  /// Why the avoider has to rest; empty if it has not.
  std::string whyRest() const;
  void updateRest();
  void tick();
  void publish(const std::optional<avoid::AvoiderCommand>& command);
  void publishStatus(bool always);

  ros::NodeHandle node_;
  ObstacleAvoiderNodeParameters parameters_;
  std::string base_frame_;
  avoid::Avoider avoider_;
  TfBridge tf_;
  Rejections rejections_{"scan"};
  Rejections bad_odometry_{"odometry"};
  ScanPlacer placer_{parameters_.avoider.robot.scanner};
  ScanMotionReport scan_motion_;
  ros::Publisher cmd_vel_, status_;
  NodeDiagnostics diagnostics_;
  std::string last_summary_;
  bool stopped_ = false;      ///< by an emergency stop
  bool was_stopped_ = false;  ///< and has not been driven since
  EarlierStops earlier_stops_;
  std::optional<SafeSwitch> switched_on_;
  std::optional<ReconfigureServer> tuning_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
