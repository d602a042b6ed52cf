#pragma once

#include <frontier_pilot/FleetStopStatus.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"
#include "ros/teleop_gui/gui_bridge.h"
#include "ros/teleop_gui/service_caller.h"
#include "teleop/fleet_link.h"

namespace frontier_pilot {

/// Connects the operator's window to a fleet, whose robots are those that fleet_stop lists in `fleet/stop_status`. It
/// has one thread for what the robots say, one for the stop of all, and one that watches whether that is available; the
/// robot that is shown has a GuiBridge. [GUI-2] [MUL-4]
class FleetBridge : public teleop::FleetLink {
 public:
  /// `running` says whether the window may stay open.
  FleetBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters, std::function<bool()> running);
  ~FleetBridge() override;

  teleop::FleetView fleet() override;
  teleop::TeleopParameters parametersOf(const std::string& robot) override;
  std::unique_ptr<teleop::OperatorLink> open(const std::string& robot,
                                             const teleop::TeleopParameters& parameters) override;
  void stopAll() override;

 private:
  /// The latest that a robot has said.
  struct Robot {
    Latest<ArbiterStatus> arbiter;
    Latest<ExplorerStatus> explorer;
    Latest<NavigatorProgress> navigation;
  };

  void handleStopStatus(const FleetStopStatus& msg);
  void listenTo(const std::string& name);
  template <class Msg>
  void keep(const std::string& name, const std::string& topic, Latest<Msg> Robot::*latest);

  const teleop::TeleopParameters parameters_;
  const std::function<bool()> running_;
  std::mutex mutex_;                    ///< guards what follows, up to stop_answer_
  std::map<std::string, Robot> heard_;  ///< all that were ever listed
  std::map<std::string, bool> listed_;  ///< those that are, and whether a stop of the fleet reaches them
  teleop::OperatorAnswer stop_answer_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ServiceCaller stop_caller_;
  ServiceWatch watch_;
  NodeConnections connections_;
  ros::AsyncSpinner spinner_;
};

}  // namespace frontier_pilot
