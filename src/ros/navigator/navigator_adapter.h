#pragma once

#include <nav_msgs/GetPlan.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Empty.h>

#include <optional>
#include <string>

#include "frontier_pilot/navigation/navigator.h"
#include "ros/common/diagnostics.h"
#include "ros/common/inputs/localization_input.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/messages/map_mirror.h"
#include "ros/common/messages/scan_motion_report.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/tuning/reconfigure_server.h"
#include "ros/navigator/fleet_motions.h"
#include "ros/navigator/navigator_action.h"
#include "ros/navigator/navigator_publisher.h"

namespace frontier_pilot {

struct NavigatorNodeParameters : navigation::NavigatorParams {
  std::string map_frame = names::kMapFrame;
  std::string base_frame;     ///< empty: the robot's
  double rate = 20.0;         ///< of the control loop [Hz]
  bool use_goal_yaw = true;   ///< whether a goal's direction matters
  bool map_must_live = true;  ///< stand still while the map has no publisher
  TrafficParameters fleet;

  template <class Visitor>
  void describe(Visitor& v) {
    navigation::NavigatorParams::describe(v);
    v.field("map_frame", map_frame, "", "frame of the map", FrameName::kGiven);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
    v.field("rate", rate, "Hz", "control cycles per second", between(1.0, 100.0));
    v.field("use_goal_yaw", use_goal_yaw, "", "whether a goal's direction matters");
    v.field("map_must_live", map_must_live, "", "stand still while the map has no publisher");
    v.group("fleet", fleet, "other robots that drive in the same building");
  }
  void check(Problems& problems) const { robot.checkIsNotBase(problems, "map_frame", map_frame, base_frame); }
};

/// The node `navigator`, with the interface of move_base; it takes map, scan, odometry and TF. [NAV-1]
class NavigatorAdapter {
 public:
  NavigatorAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  NavigatorAdapter(const NavigatorAdapter&) = delete;
  NavigatorAdapter& operator=(const NavigatorAdapter&) = delete;

  /// Publishes a zero if there is an active goal. [NAV-1]
  void sayLastWords();

 private:
  void tick(Time now);
  navigation::NavigatorOutput pursue(const navigation::NavigatorInputs& inputs, Time now);
  bool mustStand();
  navigation::NavigatorInputs gather(Time now);
  void handleScan(const sensor_msgs::LaserScan& msg);
  void handleOdometry(const nav_msgs::Odometry& msg);
  void handleStop(const std_msgs::Bool& msg);
  bool handlePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool handleClear(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response);
  void take(const NavigatorNodeParameters& changed);
  std::optional<StampedPose2> pose() const;
  std::optional<Vec2> positionNow() const;
  void takeMap();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  NavigatorNodeParameters parameters_;
  std::string base_frame_;
  navigation::Navigator navigator_;
  TfBridge tf_;
  MapMirror map_;
  LocalizationInput localization_;
  MoveBaseServer server_;
  FleetMotions motions_;
  NavigatorPublisher publisher_;
  NodeDiagnostics diagnostics_;
  Rejections bad_scans_{"scan"};
  Rejections bad_odometry_{"odometry"};
  ScanPlacer placer_{parameters_.robot.scanner};
  ScanMotionReport scan_motion_;
  std::optional<LaserScan2> scan_;
  Latest<Twist2> twist_;
  navigation::NavState state_ = navigation::NavState::kIdle;
  std::string failure_;  ///< why the last goal that ended was aborted; empty if it was not
  ros::Publisher command_;
  std::optional<ReconfigureServer> tuning_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
