#pragma once

#include <dynamic_reconfigure/Config.h>
#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/NavigatorProgress.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "frontier_pilot/avoid/parameters.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/teleop_gui/action_link.h"
#include "ros/teleop_gui/map_link.h"
#include "ros/teleop_gui/service_caller.h"
#include "ros/teleop_gui/service_watch.h"
#include "teleop/manual_output.h"
#include "teleop/operator_link.h"
#include "teleop/parameters.h"

namespace frontier_pilot {

/// Connects the operator's window to ROS. It has one thread for the topics and `cmd_vel_manual`, one for the map, one
/// for service calls, one for those of the arbiter, one for the emergency stop alone, so that neither waits behind a
/// node that hangs, one for maps that are saved and loaded, which takes seconds, and one that watches which services
/// are available. The window's thread only copies data. [GUI-3]
class GuiBridge : public teleop::OperatorLink {
 public:
  /// When `cmd_vel_manual` is published: always at the rate, or only from the first motion until a second after the
  /// last, so that an unused panel does not interfere with a window that is used for driving.
  enum class Manual { kAlways, kOnDemand };

  /// `running` says whether the window may stay open.
  GuiBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters, Manual manual,
            std::function<bool()> running);
  ~GuiBridge() override;

  teleop::OperatorState state() override;
  SteadyTime now() const override;
  void beat(const Twist2& set_point) override;
  void request(const teleop::OperatorRequest& request) override;
  teleop::MapView takeMap() override { return map_.take(); }
  std::vector<teleop::OperatorLogLine> takeLog() override;
  bool running() const override { return running_(); }
  void close() override;

 private:
  void subscribe();
  void watchServices();
  void goTo(const Pose2& goal);
  void followWaypoints(const std::vector<Pose2>& poses);
  void onScan(const sensor_msgs::LaserScan& msg);
  void onArbiter(const ros::MessageEvent<const ArbiterStatus>& event);
  /// For a node that no longer listens to the manual velocity. The end of the arbiter is known by that before the next
  /// one listens.
  void onListenerLost(const ros::SingleSubscriberPublisher& listener);
  void refuseClear(const std::string& reason);
  void onAnswer(const std::string& service, bool success, const std::string& message);
  void onMapAnswer(bool success, const std::string& message);
  /// Whether somebody has asked for a stop since the last status.
  bool isAnotherStop(const ArbiterStatus& msg) const;
  /// Drops the calls that a stop which came after them has overtaken, and cancels the goals that are still on their
  /// way: they would begin after its clear.
  void dropWhatWaits(const std::string& why);
  void watchSwitchOf(const std::string& source);
  void onServiceUp(const std::string& service);
  void onAvoiderTuned(const dynamic_reconfigure::Config& msg);
  /// What the publisher of the manual velocity needs. The master is asked for it, which may hang, so that no lock must
  /// be held meanwhile: the window's thread would wait, too.
  enum class TopicNeed { kNone, kOpen, kClose };
  void publishManual();
  TopicNeed publishManual(SteadyTime now);
  bool masterAnswers() const;
  void openManual();
  void closeManual();
  bool manualWanted(SteadyTime now);
  bool isContested();
  bool manualOn(SteadyTime now) const;
  std::optional<bool> stopState(SteadyTime now) const;
  OperatorLog logger();
  void log(teleop::Severity severity, const std::string& text);

  std::mutex log_mutex_;  ///< guards only the log, because lines are added while other locks are held
  std::vector<teleop::OperatorLogLine> log_;
  mutable std::mutex mutex_;  ///< guards the members that follow, up to avoider_parameters_
  teleop::ManualOutput manual_output_;
  SteadyTime last_motion_{};
  Latest<ArbiterStatus> arbiter_;
  boost::shared_ptr<ros::M_string> arbiter_header_;  ///< of the connection that the last status came by
  std::uint64_t arbiter_changes_ = 0;
  Latest<AvoiderStatus> avoider_;
  Latest<ExplorerStatus> explorer_;
  Latest<NavigatorProgress> navigation_;
  Latest<bool> stop_, contact_;
  std::string clear_refusal_;
  teleop::OperatorAnswer map_answer_;
  Latest<Twist2> command_;
  Latest<LaserScan2> scan_;
  std::optional<avoid::AvoiderParameters> avoider_parameters_;  ///< none before the avoider was there

  Rejections nameless_{"switch of a source"};  ///< this and the next are used by the topics' thread alone
  std::set<std::string> said_nameless_;
  const teleop::TeleopParameters parameters_;
  const Manual manual_;
  const std::function<bool()> running_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  TfBridge tf_;
  ros::Publisher manual_publisher_;
  ros::Subscriber stop_subscriber_, navigation_subscriber_;
  NodeConnections connections_;
  PatrolLink patrol_;
  SpinLink spin_;
  NavigationLink navigate_;
  MapLink map_;
  WaypointsLink waypoints_;
  ServiceCaller caller_, arbiter_caller_, stop_caller_, map_caller_;
  ServiceWatch watch_;
  ros::AsyncSpinner spinner_;
};

}  // namespace frontier_pilot
