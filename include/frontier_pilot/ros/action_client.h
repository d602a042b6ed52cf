#pragma once

#include <actionlib/client/client_helpers.h>
#include <actionlib/client/connection_monitor.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>

#include <boost/make_shared.hpp>
#include <functional>
#include <string>
#include <utility>

#include "frontier_pilot/ros/callback_guard.h"
#include "frontier_pilot/ros/checked_subscription.h"

namespace frontier_pilot {

/// An action as somebody has it who pursues one goal at a time, with actionlib's bookkeeping behind subscriptions that
/// check what they read. Nothing here waits, not even for the first /clock. For the node's own thread. [FLT-1]
template <class Action>
class ActionClient {
 public:
  ACTION_DEFINITION(Action)
  using Done = std::function<void(const actionlib::TerminalState&, const ResultConstPtr&)>;
  using Heard = std::function<void(const FeedbackConstPtr&)>;

  ActionClient(const ros::NodeHandle& node, const std::string& name)
      : node_(node),
        manager_(boost::make_shared<actionlib::DestructionGuard>()),
        status_(listen<actionlib_msgs::GoalStatusArray>(name + "/status", &ActionClient::takeStatus)),
        feedback_(listen<ActionFeedback>(name + "/feedback", &ActionClient::takeFeedback)),
        result_(listen<ActionResult>(name + "/result", &ActionClient::takeResult)),
        monitor_(feedback_, result_),
        goal_(offer<ActionGoal>(name + "/goal", &Monitor::goalConnectCallback, &Monitor::goalDisconnectCallback)),
        cancel_(offer<GoalID>(name + "/cancel", &Monitor::cancelConnectCallback, &Monitor::cancelDisconnectCallback)) {
    manager_.registerSendGoalFunc([this](const ActionGoalConstPtr& goal) { goal_.publish(goal); });
    manager_.registerCancelFunc([this](const GoalID& id) { cancel_.publish(id); });
  }

  /// Whether a server is there now that takes goals and cancels, and has said so.
  bool isServerConnected() { return monitor_.isServerConnected(); }

  /// Sends a goal; the end of the one before is not told. `done` is called once, when it has ended, and `heard` with
  /// each feedback.
  void send(const Goal& goal, Done done, Heard heard = {}) {
    const auto changed = [done = std::move(done)](const GoalHandle& handle) {
      if (handle.getCommState() == actionlib::CommState::DONE) done(handle.getTerminalState(), handle.getResult());
    };
    const auto told = [heard = std::move(heard)](const GoalHandle&, const FeedbackConstPtr& feedback) {
      if (heard) heard(feedback);
    };
    handle_ = manager_.initGoal(goal, changed, told);
  }
  /// Asks the server to end the goal that was sent last.
  void cancel() {
    if (!handle_.isExpired()) handle_.cancel();
  }
  /// What becomes of that goal is not told any more.
  void forget() { handle_.reset(); }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
    if (callbacks_.total() > 0) callbacks_.report(status);
  }

 private:
  using GoalHandle = actionlib::ClientGoalHandle<Action>;
  using GoalID = actionlib_msgs::GoalID;
  using Monitor = actionlib::ConnectionMonitor;
  using Connection = ros::SingleSubscriberPublisher;

  static constexpr std::uint32_t kQueue = 50;

  template <class Msg>
  ros::Subscriber listen(const std::string& topic, void (ActionClient::*take)(const ros::MessageEvent<const Msg>&)) {
    ros::SubscribeOptions options =
        checkedSubscription<Msg>(topic, kQueue, [this, topic, take](const ros::MessageEvent<const Msg>& event) {
          callbacks_.run(node_.resolveName(topic), [&] { (this->*take)(event); });
        });
    return node_.subscribe(options);
  }
  template <class Msg>
  ros::Publisher offer(const std::string& topic, void (Monitor::*come)(const Connection&),
                       void (Monitor::*gone)(const Connection&)) {
    return node_.advertise<Msg>(
        topic, kQueue, [this, come](const Connection& connection) { (monitor_.*come)(connection); },
        [this, gone](const Connection& connection) { (monitor_.*gone)(connection); });
  }

  void takeStatus(const ros::MessageEvent<const actionlib_msgs::GoalStatusArray>& event) {
    monitor_.processStatus(event.getConstMessage(), event.getPublisherName());
    manager_.updateStatuses(event.getConstMessage());
  }
  void takeFeedback(const ros::MessageEvent<const ActionFeedback>& event) {
    manager_.updateFeedbacks(event.getConstMessage());
  }
  void takeResult(const ros::MessageEvent<const ActionResult>& event) {
    manager_.updateResults(event.getConstMessage());
  }

  ros::NodeHandle node_;
  CallbackGuard callbacks_;
  actionlib::GoalManager<Action> manager_;
  GoalHandle handle_;
  // Callbacks run on the node's own thread: none comes before the last of these is there.
  ros::Subscriber status_, feedback_, result_;
  Monitor monitor_;  ///< knows servers by their subscriptions, too
  ros::Publisher goal_, cancel_;
};

}  // namespace frontier_pilot
