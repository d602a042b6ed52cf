#pragma once

#include <frontier_pilot/FleetStopStatus.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/worker.h"
#include "ros/teleop_gui/gui_bridge.h"
#include "ros/teleop_gui/service_caller.h"
#include "ros/teleop_gui/service_watch.h"
#include "teleop/fleet_link.h"

namespace frontier_pilot {

/// Connects the operator's window to a fleet, whose robots are those that fleet_stop lists in `fleet/stop_status`. It
/// has one thread for what the robots say, one for the stop of all, one that watches whether that is available, and two
/// for the robot that is shown, which has a GuiBridge: they open that and end it, which asks the master and may last.
/// [GUI-2] [GUI-3] [MUL-4]
class FleetBridge : public teleop::FleetLink {
 public:
  /// `running` says whether the window may stay open.
  FleetBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters, std::function<bool()> running);
  ~FleetBridge() override;

  teleop::FleetView fleet() override;
  teleop::OpenedRobot openOwn() override;
  void open(const std::string& robot) override;
  std::optional<teleop::OpenedRobot> takeOpened() override;
  void retire(std::unique_ptr<teleop::OperatorLink> link) override;
  void stopAll() override;
  void stop(const std::string& robot) override;

 private:
  /// The latest that a robot has said.
  struct Robot {
    Latest<ArbiterStatus> arbiter;
    Latest<ExplorerStatus> explorer;
    Latest<NavigatorProgress> navigation;
  };
  struct Retired {
    std::shared_ptr<teleop::OperatorLink> link;
    SteadyTime since;
  };

  void handleStopStatus(const FleetStopStatus& msg);
  void makeRoom(const std::map<std::string, bool>& listed);
  void listenTo(const std::string& name);
  template <class Msg>
  void keep(const std::string& name, const std::string& topic, Latest<Msg> Robot::*latest);
  teleop::RobotView viewOf(const std::string& name, bool reached, SteadyTime now) const;
  void describe(teleop::OpenedRobot& opened) const;
  void endRetired(SteadyTime now);
  void showAnswer(bool success, const std::string& text);

  const teleop::TeleopParameters parameters_;
  const std::function<bool()> running_;
  std::mutex mutex_;                    ///< guards what follows, up to answered_at_
  std::map<std::string, Robot> heard_;  ///< all that were ever listed, as long as there is room
  std::map<std::string, bool> listed_;  ///< those that are, and whether a stop of the fleet reaches them
  std::optional<SteadyTime> listed_at_;
  teleop::FleetStopView stop_;
  SteadyTime answered_at_;  ///< when the last call was answered
  const ros::NodeHandle own_node_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ServiceCaller stop_caller_, robot_stop_caller_;
  ServiceWatch watch_;
  NodeConnections connections_;
  std::map<std::string, std::vector<ros::Subscriber>> topics_;  ///< by robot; used only by the thread that hears them
  ros::AsyncSpinner spinner_;
  // What follows is for the window's thread.
  std::deque<Retired> retired_;  ///< the oldest first
  Worker<bool> ender_;
  Worker<teleop::OpenedRobot> opener_;
};

/// One line on stderr for a window that cannot be opened.
void sayWhyNoWindow(const std::string& why);

}  // namespace frontier_pilot
