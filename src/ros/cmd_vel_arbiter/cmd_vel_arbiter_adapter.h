#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <ros/this_node.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/arbiter.h"
#include "ros/cmd_vel_arbiter/arbiter_report.h"
#include "ros/cmd_vel_arbiter/arrival_queue.h"
#include "ros/cmd_vel_arbiter/fleet_stop_watch.h"
#include "ros/cmd_vel_arbiter/stop_listeners.h"
#include "ros/common/diagnostics.h"
#include "ros/common/hold_up_watch.h"
#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/safe_switch.h"
#include "ros/common/memory/session_memory.h"
#include "ros/common/node_connections.h"
#include "ros/common/publish_flush.h"
#include "ros/common/tuning/reconfigure_server.h"

namespace frontier_pilot {

/// The present on both clocks, ROS time and steady time.
inline Instant instantNow() { return {rosNow(), steadyNow()}; }

/// Throws std::runtime_error with its name if an arbiter of this namespace is already running, whatever its name. To be
/// called before the node is started, because a node that starts under the name of another one ends that one. [ARB-12]
void refuseASecondArbiter();

/// The node `cmd_vel_arbiter`: the only publisher of `cmd_vel`. The callback of a source converts the message, decides
/// and publishes; everything else happens at the tick.
class CmdVelArbiterAdapter {
 public:
  CmdVelArbiterAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Publishes a zero. [ARB-11]
  void sayLastWords();

 private:
  using SetBoolCall = ros::ServiceEvent<std_srvs::SetBool::Request, std_srvs::SetBool::Response>;
  using TriggerCall = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;

  /// Advertises the status, by which other nodes recognise an arbiter. Arbiters that start at the same moment do not
  /// find each other in refuseASecondArbiter(); but the master registers their status one after the other, so that all
  /// of them agree which was first. All others throw std::runtime_error here, before they offer a service or could be
  /// taken for a rival. [ARB-12]
  static ros::Publisher takeItsPlace(ros::NodeHandle& node);
  ros::Publisher advertiseStopState();
  void restoreStop();
  /// Stores a latched stop for the next arbiter of this namespace, or removes the stored one once it is cleared.
  void keepStop();
  /// Goes on with the count of stops of the arbiter before this one: a node that was away can tell by it whether the
  /// robot was stopped meanwhile. [ARB-8] [FLT-2]
  void restoreCount();
  void keepCount() { stops_->set(std::to_string(arbiter_.stops())); }
  /// Latches a stop that another arbiter of this namespace has stored, even if that arbiter has ended.
  void takeOverStop();
  void addSource(std::size_t source);
  void restoreSwitch(std::size_t source);
  void addServices();
  void addStopServices();
  /// Lets calls of `set_emergency_stop` wait while the arbiter cannot tell which sources command motion, or which nodes
  /// know of the stop.
  void listenBeforeClears();
  /// Ends the listening phase of an arbiter that is new or was held up, and serves the calls that have waited for it.
  void endListening();
  void listListeners(std::vector<std::string> nodes);
  void handleCommand(std::size_t source, const geometry_msgs::Twist& msg);
  bool handleEnable(std::size_t source, std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool handleSetStop(SetBoolCall& call);
  bool handleStop(TriggerCall& call);
  arbiter::ArbiterAnswer stop(const std::string& cause);
  arbiter::ArbiterAnswer clear(const std::string& caller);
  void tick();
  void takeMasterReport();
  void handleStopState(const ros::MessageEvent<const std_msgs::Bool>& event);
  /// Adds the name of this node to the answer, so that the caller knows which node has answered.
  arbiter::ArbiterAnswer signedBy(arbiter::ArbiterAnswer answer) const;
  void publish(const std::optional<Twist2>& twist);
  void publishStopState();
  void publishStatus(bool always);

  ros::NodeHandle node_;
  arbiter::Arbiter arbiter_;
  SessionMemory memory_;
  ArbiterConnections around_;
  std::vector<Rejections> rejections_;
  ArrivalQueue calls_, clears_{[this] { listenBeforeClears(); }};
  StopListeners stop_listeners_{ros::this_node::getName()};
  ros::Publisher status_, cmd_vel_, stop_state_;  ///< in this order: see takeItsPlace()
  PublishFlush flush_;
  FleetStopWatch fleet_{arbiter_.parameters().fleet_stop_status};
  NodeDiagnostics diagnostics_;
  std::string last_summary_, last_content_;
  /// Just after this process was held up, commands may have been sent long before, and are dropped.
  HoldUpWatch hold_ups_{std::chrono::milliseconds(100), Duration::max()};
  std::deque<SafeSwitch> switches_;            ///< of the sources; the safe side is disabled
  bool looks_at_others_ = true;                ///< in each second round, in place of keeping its own stop
  std::optional<RememberedText> stops_;        ///< how many were asked for; nothing as long as none was
  Mailbox<std::vector<std::string>> session_;  ///< names of the new ROS session after a restart of the master
  std::optional<ReconfigureServer> tuning_;
  std::optional<SteadyTime> listening_until_;  ///< until then at least calls of `set_emergency_stop` wait
  NodeConnections connections_;
};

}  // namespace frontier_pilot
