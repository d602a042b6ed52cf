#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
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
#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/common/publish_flush.h"
#include "ros/common/safe_switch.h"
#include "ros/common/session_memory.h"

namespace frontier_pilot {

/// Now, on both clocks.
inline Instant instantNow() { return {rosNow(), steadyNow()}; }

/// Throws std::runtime_error, naming it, if an arbiter of this namespace lives already, whatever its name. To be called
/// before the node is started: a node that starts under the name of another ends that one. [ARB-12]
void refuseASecondArbiter();

/// The node `cmd_vel_arbiter`: the only publisher of `cmd_vel`. A source's callback is convert, decide, publish; all
/// that is not needed to move the wheels happens at the tick.
class CmdVelArbiterAdapter {
 public:
  CmdVelArbiterAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Zero. [ARB-11]
  void sayLastWords();

 private:
  using SetBoolCall = ros::ServiceEvent<std_srvs::SetBool::Request, std_srvs::SetBool::Response>;
  using TriggerCall = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;

  /// Gives the status, which makes a node an arbiter. Arbiters that start at the same moment find nobody when they look
  /// for one; the master registers them one after the other, and so all agree which of them was the first. Any other
  /// throws std::runtime_error here, before it offers a service or could be taken for a rival. [ARB-12]
  static ros::Publisher takeItsPlace(ros::NodeHandle& node);
  void restoreStop();
  /// Sees to it that the next arbiter of this namespace finds a stop, or none.
  void keepStop();
  /// A stop that another arbiter of the namespace has answered is a stop of this one, also after that one's end.
  void takeOverStop();
  void addSource(std::size_t source);
  void restoreSwitch(std::size_t source);
  void addStopServices();
  /// Serves the calls that have waited for an arbiter that came up stopped to hear its sources.
  void endListening();
  /// Whether this process was suspended until a moment ago: what arrives now was sent while it was, nobody knows when.
  bool hasJustWoken();
  void handleCommand(std::size_t source, const geometry_msgs::Twist& msg);
  bool handleEnable(std::size_t source, std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool handleSetStop(SetBoolCall& call);
  bool handleStop(TriggerCall& call);
  arbiter::ArbiterAnswer stop(const std::string& cause);
  arbiter::ArbiterAnswer clear(const std::string& caller);
  void tick();
  void takeMasterReport();
  void handleStopState(const ros::MessageEvent<const std_msgs::Bool>& event);
  /// Who answered, for people who cannot tell otherwise.
  arbiter::ArbiterAnswer signedBy(arbiter::ArbiterAnswer answer) const;
  void publish(const std::optional<Twist2>& twist);
  void publishStopState();
  void publishStatus(bool always);

  ros::NodeHandle node_;
  arbiter::Arbiter arbiter_;
  SessionMemory memory_;
  ArbiterConnections around_;
  std::vector<Rejections> rejections_;
  ArrivalQueue calls_, clears_;
  ros::Publisher status_, cmd_vel_, stop_state_;  ///< in this order: a place, and then what only its holder has
  PublishFlush flush_;
  NodeDiagnostics diagnostics_;
  std::string last_summary_, last_content_;
  SteadyTime last_seen_ = steadyNow(), woken_until_{};
  std::deque<SafeSwitch> switches_;            ///< of the sources, which are safe while they are off
  Mailbox<std::vector<std::string>> session_;  ///< a new one of ROS, if the master is a new one
  std::optional<SteadyTime> listening_until_;  ///< while calls of `set_emergency_stop` wait
  NodeConnections connections_;
};

}  // namespace frontier_pilot
