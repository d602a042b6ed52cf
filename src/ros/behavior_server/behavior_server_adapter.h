#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Bool.h>

#include <memory>
#include <string>
#include <vector>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "ros/behavior_server/behavior_actions.h"
#include "ros/behavior_server/behavior_costmap.h"
#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/tuning/reconfigure_server.h"

namespace frontier_pilot {

/// The parameters of the node.
struct BehaviorServerParameters {
  behavior::BehaviorParameters behavior;
  behavior::CollisionCheckParameters surroundings;
  BehaviorFrames frames;

  template <class Visitor>
  void describe(Visitor& v) {
    behavior.describe(v);
    surroundings.describe(v);
    frames.describe(v);
  }
  void check(Problems& problems) const {
    behavior.check(problems);
    const RobotModel& robot = behavior.robot;
    // The robot's own frames are checked with the robot.
    const bool are_the_robots = frames.odom_frame.empty() && frames.base_frame.empty();
    if (!are_the_robots)
      robot.checkIsNotBase(problems, "odom_frame", robot.odomFrameOr(frames.odom_frame), frames.base_frame);
  }
};

/// The node `behavior_server`: the actions spin, back_up, drive_on_heading and wait, which share one TimedBehavior. A
/// newer goal on any of them replaces the active one; a cancel or an emergency stop acts at once, in its callback.
/// [SPN-5]
class BehaviorServerAdapter {
 public:
  BehaviorServerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Ends an active behaviour, with a zero.
  void sayLastWords();

 private:
  template <class Action, class Result, class Feedback>
  void addPort(const char* name);
  void take(const BehaviorServerParameters& changed);
  void start(BehaviorPort& port, const behavior::BehaviorGoal& goal);
  void cancel(const std::string& why);
  void handleStop(const std_msgs::Bool& msg);
  void tick();
  void step(const std::optional<Time>& now);
  void put(const behavior::BehaviorOutput& output);
  /// The robot's outline, for rviz.
  void publishFootprint();
  void fillDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  ros::NodeHandle node_;
  BehaviorServerParameters parameters_;
  behavior::TimedBehavior behavior_;
  TfBridge tf_;
  BehaviorCostmap around_;
  bool emergency_stop_ = false;
  std::string last_result_ = "none yet";
  ros::Publisher cmd_vel_, footprint_;
  BehaviorPort* port_ = nullptr;  ///< the port of the latest goal
  std::vector<std::unique_ptr<BehaviorPort>> ports_;
  NodeDiagnostics diagnostics_;
  std::optional<ReconfigureServer> tuning_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
