#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/PatrolAction.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <std_msgs/Bool.h>

#include <optional>
#include <string>

#include "frontier_pilot/patrol/patrol.h"
#include "ros/common/actions/action_server.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/tuning/reconfigure_server.h"
#include "ros/patrol_server/patrol_surroundings.h"

namespace frontier_pilot {

/// The parameters of the node: those of the patrol, and the node's own.
struct PatrolServerParameters {
  patrol::PatrolParameters patrol;
  PatrolSurroundingsParameters surroundings;
  std::string source = "patrol";

  template <class Visitor>
  void describe(Visitor& v) {
    patrol.describe(v);
    surroundings.describe(v);
    v.field("source", source, "",
            "the arbiter's name for this node, where none of its sources has the topic `cmd_vel_patrol` of this node");
  }
  void check(Problems& problems) const { patrol.check(problems); }
};

/// The node `patrol_server`: a Patrol as the action `turtlebot3`. Goals, cancels and an emergency stop act at once, in
/// their callbacks, not at the next tick; a zero velocity is published before any result. [PAT-4] [PAT-7]
class PatrolServerAdapter {
 public:
  PatrolServerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Ends an active patrol, with a zero.
  void sayLastWords();

 private:
  using Server = SingleGoalServer<PatrolAction>;

  /// The arbiter says once a second who drives. One that has fallen silent says nothing about the wheels.
  static constexpr Duration kArbiterPatience = std::chrono::seconds(2);

  void subscribe();
  void handleGoal(const PatrolGoal& msg);
  void handleOdometry(const nav_msgs::Odometry& msg);
  void handleStop(const std_msgs::Bool& msg);
  void handleArbiter(const ArbiterStatus& msg);
  void tick();
  void step(const std::optional<Time>& now);
  void put(const patrol::PatrolOutput& output);
  void finish(const patrol::PatrolOutput& output);
  void fillDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  ros::NodeHandle node_;
  PatrolServerParameters parameters_;
  patrol::Patrol patrol_;
  patrol::PatrolInputs inputs_;
  Time odometry_stamp_;                                ///< of the last odometry, by the clock of the base
  Latest<std::optional<std::string>> wheels_held_by_;  ///< the other source that holds the wheels
  std::string last_text_ = "no patrol yet";
  Rejections bad_odometry_{"odometry"};
  ros::Publisher cmd_vel_;
  Server server_;
  NodeDiagnostics diagnostics_;
  TfBridge tf_;
  PatrolSurroundings surroundings_;
  std::optional<ReconfigureServer> tuning_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
