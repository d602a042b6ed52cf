#pragma once

#include <actionlib/client/client_helpers.h>
#include <actionlib/client/connection_monitor.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>
#include <ros/this_node.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ros/common/callback_guard.h"
#include "ros/common/clock.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/checked_subscription.h"

namespace frontier_pilot {

/// How the goal with this id ended according to the server's status; LOST if the status does not show an end.
inline actionlib::TerminalState endOf(const std::string& id, const actionlib_msgs::GoalStatusArray& statuses) {
  using Status = actionlib_msgs::GoalStatus;
  using State = actionlib::TerminalState;
  static const std::map<std::uint8_t, State::StateEnum> ends{
      {Status::SUCCEEDED, State::SUCCEEDED}, {Status::ABORTED, State::ABORTED},   {Status::REJECTED, State::REJECTED},
      {Status::PREEMPTED, State::PREEMPTED}, {Status::RECALLED, State::RECALLED},
  };
  for (const Status& status : statuses.status_list) {
    const auto end = ends.find(status.status);
    if (status.goal_id.id == id && end != ends.end()) return State(end->second, status.text);
  }
  return State(State::LOST, "the server did not report how the goal ended");
}

/// A client of an action that pursues one goal at a time. actionlib keeps track of the goal; the subscriptions check
/// every message before it is read. Nothing here blocks, not even for the first /clock. For the node's thread. [FLT-1]
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
        goal_(offer<ActionGoal>(name + "/goal", &ActionClient::goalTakerCame, &ActionClient::goalTakerWent)),
        cancel_(offer<GoalID>(name + "/cancel", &ActionClient::cancelTakerCame, &ActionClient::cancelTakerWent)) {
    manager_.registerSendGoalFunc([this](const ActionGoalConstPtr& goal) {
      sent_.push_back(goal->goal_id.id);
      if (sent_.size() > kRemembered) sent_.pop_front();
      goal_.publish(goal);
    });
    manager_.registerCancelFunc([this](const GoalID& id) { cancel_.publish(id); });
  }

  /// Whether a server is connected now: it subscribes to goals and cancels, and has published its status since then.
  /// One that was restarted may have got a goal of another client first, which only its status tells.
  bool isServerConnected() { return server_heard_ && monitor_.isServerConnected(); }

  /// Sends a goal; the end of the previous one is not reported any more. `done` is called once, when the goal has
  /// ended, and `heard` with each feedback. A result that the server published before this client was connected is
  /// lost: `done` is then called with a null result, once the status has shown the end for a second. So it is for a
  /// goal that went with the server before its status had shown it, once the next server has been heard.
  void send(const Goal& goal, Done done, Heard heard = {}) {
    done_ = done;
    ended_at_.reset();
    idle_since_.reset();
    may_be_lost_ = false;
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
  /// Whether the server's status shows a goal of another client that has not ended, or did a moment ago: a client that
  /// sends its goals one after the other leaves short gaps between them, and one whose goal ended with the server sends
  /// it to the next one. [EXP-11]
  bool servesOthers() const { return others_now_ || (others_expected_until_ && steadyNow() < *others_expected_until_); }
  /// From now on nothing is reported about that goal.
  void forget() { handle_.reset(); }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
    if (callbacks_.total() > 0) callbacks_.report(status);
    if (strangers_.total() > 0) strangers_.report(status);
    unreadable_.report(status);
  }

 private:
  using GoalHandle = actionlib::ClientGoalHandle<Action>;
  using GoalID = actionlib_msgs::GoalID;
  using Monitor = actionlib::ConnectionMonitor;
  using Connection = ros::SingleSubscriberPublisher;

  static constexpr std::uint32_t kQueue = 50;
  static constexpr std::size_t kRemembered = 100;                           ///< more than a server's status lists
  static constexpr Duration kResultPatience = std::chrono::seconds(1);      ///< of the steady clock
  static constexpr Duration kGapOfOthers = std::chrono::milliseconds(700);  ///< more than three statuses
  static constexpr Duration kReturnOfOthers = std::chrono::seconds(2);      ///< to a server that was restarted
  static constexpr Duration kServerPatience = std::chrono::seconds(2);      ///< the same; a status comes at 5 Hz

  template <class Msg>
  ros::Subscriber listen(const std::string& topic, void (ActionClient::*take)(const ros::MessageEvent<const Msg>&)) {
    ros::SubscribeOptions options = checkedSubscription<Msg>(
        topic, kQueue, unreadable_, [this, topic, take](const ros::MessageEvent<const Msg>& event) {
          callbacks_.run(node_.resolveName(topic), [&] { (this->*take)(event); });
        });
    return node_.subscribe(options);
  }
  template <class Msg>
  ros::Publisher offer(const std::string& topic, void (ActionClient::*come)(const Connection&),
                       void (ActionClient::*gone)(const Connection&)) {
    return node_.advertise<Msg>(
        topic, kQueue, [this, come](const Connection& connection) { (this->*come)(connection); },
        [this, gone](const Connection& connection) { (this->*gone)(connection); });
  }
  void goalTakerCame(const Connection& connection) {
    takers_.insert(connection.getSubscriberName());
    monitor_.goalConnectCallback(connection);
  }
  void goalTakerWent(const Connection& connection) {
    const auto taker = takers_.find(connection.getSubscriberName());
    if (taker != takers_.end()) takers_.erase(taker);
    if (takers_.count(server_) == 0) {
      server_heard_.reset();
      others_return_ = others_return_ || (servesOthers() && isIdle());  // otherwise they had just given way
      others_now_ = false;
      others_expected_until_.reset();
      may_be_lost_ = true;
    }
    monitor_.goalDisconnectCallback(connection);
  }
  void cancelTakerCame(const Connection& connection) { monitor_.cancelConnectCallback(connection); }
  void cancelTakerWent(const Connection& connection) { monitor_.cancelDisconnectCallback(connection); }

  void takeStatus(const ros::MessageEvent<const actionlib_msgs::GoalStatusArray>& event) {
    if (!isFromServer(event.getPublisherName())) {
      if (server_heard_) strangers_.add("not from the server");  // before, this may be the server, not yet connected
      return;
    }
    monitor_.processStatus(event.getConstMessage(), event.getPublisherName());
    lookForOthers(*event.getConstMessage());  // first, for those who are told below how their goal ended
    manager_.updateStatuses(event.getConstMessage());
    endUnacknowledged(*event.getConstMessage());
    endWithoutResult(*event.getConstMessage());
    cancelStrays(*event.getConstMessage());
  }
  /// Whether a status comes from the server: a node that takes this client's goals, and of several the one that was
  /// heard first, until it has been silent for a while. A status of another node would end goals that are still
  /// pursued, and actionlib would log each change of the sender.
  bool isFromServer(const std::string& publisher) {
    if (takers_.count(publisher) == 0) return false;
    const SteadyTime now = steadyNow();
    if (publisher != server_ && server_heard_ && now - *server_heard_ < kServerPatience) return false;
    if (std::exchange(others_return_, false)) others_expected_until_ = now + kReturnOfOthers;
    server_ = publisher;
    server_heard_ = now;
    return true;
  }
  /// Whether no goal is under way, as far as this client was told.
  bool isIdle() const { return handle_.isExpired() || isIn(actionlib::CommState::DONE); }
  bool isIn(actionlib::CommState::StateEnum state) const {
    return !handle_.isExpired() && handle_.getCommState() == state;
  }
  bool wasSent(const std::string& id) const { return std::find(sent_.begin(), sent_.end(), id) != sent_.end(); }
  /// Whether a goal is of this node or of an earlier one of its name: actionlib begins the ids with the name.
  static bool isOwn(const std::string& id) { return id.rfind(ros::this_node::getName() + "-", 0) == 0; }
  void lookForOthers(const actionlib_msgs::GoalStatusArray& statuses) {
    using Status = actionlib_msgs::GoalStatus;
    const auto of_others = [this](const Status& status) {
      const bool pursued = status.status == Status::PENDING || status.status == Status::ACTIVE ||
                           status.status == Status::PREEMPTING || status.status == Status::RECALLING;
      return pursued && !wasSent(status.goal_id.id) && !isOwn(status.goal_id.id);
    };
    const bool before =
        std::exchange(others_now_, std::any_of(statuses.status_list.begin(), statuses.status_list.end(), of_others));
    if (before && !others_now_) others_expected_until_ = steadyNow() + kGapOfOthers;
  }
  /// Cancels goals that are still pursued although nobody waits for them: those of an earlier process of the same name,
  /// which was killed before it could cancel them itself, and those whose end this client was told by somebody else
  /// than the server, once no goal has been under way for a moment. [FLT-2]
  void cancelStrays(const actionlib_msgs::GoalStatusArray& statuses) {
    using Status = actionlib_msgs::GoalStatus;
    const bool idle = isIdle();
    if (!idle) idle_since_.reset();
    if (idle && !idle_since_) idle_since_ = steadyNow();
    const bool long_idle = idle && steadyNow() - *idle_since_ >= kResultPatience;
    for (const Status& status : statuses.status_list) {
      const bool pursued = status.status == Status::PENDING || status.status == Status::ACTIVE;
      if (!pursued || !isOwn(status.goal_id.id) || (wasSent(status.goal_id.id) && !long_idle)) continue;
      GoalID goal;  // without a stamp, which would cancel every goal that is older
      goal.id = status.goal_id.id;
      cancel_.publish(goal);
    }
  }
  /// actionlib would wait for ever for a status that shows the goal.
  void endUnacknowledged(const actionlib_msgs::GoalStatusArray& statuses) {
    if (std::exchange(may_be_lost_, false) && isIn(actionlib::CommState::WAITING_FOR_GOAL_ACK)) end(statuses);
  }
  void endWithoutResult(const actionlib_msgs::GoalStatusArray& statuses) {
    if (!isIn(actionlib::CommState::WAITING_FOR_RESULT)) return;
    const SteadyTime now = steadyNow();
    if (!ended_at_) ended_at_ = now;
    if (now - *ended_at_ < kResultPatience) return;
    end(statuses);
  }
  void end(const actionlib_msgs::GoalStatusArray& statuses) {
    forget();
    if (const Done done = std::exchange(done_, {})) done(endOf(sent_.back(), statuses), nullptr);
  }
  void takeFeedback(const ros::MessageEvent<const ActionFeedback>& event) {
    manager_.updateFeedbacks(event.getConstMessage());
  }
  void takeResult(const ros::MessageEvent<const ActionResult>& event) {
    manager_.updateResults(event.getConstMessage());
  }

  ros::NodeHandle node_;
  CallbackGuard callbacks_;
  UnreadableMessages unreadable_;
  Rejections strangers_{"action status"};
  std::multiset<std::string> takers_;  ///< the nodes that subscribe to the goals, once for each connection
  std::string server_;                 ///< the node whose statuses are believed
  std::optional<SteadyTime> server_heard_;
  bool others_now_ = false;     ///< whether the last status showed a goal of another client
  bool others_return_ = false;  ///< the server went while it served them; to the next one they come first
  std::optional<SteadyTime> others_expected_until_;  ///< while the statuses show none of their goals
  actionlib::GoalManager<Action> manager_;
  GoalHandle handle_;
  std::deque<std::string> sent_;          ///< the ids of the last goals, the newest last
  Done done_;                             ///< called when a goal has ended but its result was lost
  bool may_be_lost_ = false;              ///< the server went after the goal was sent
  std::optional<SteadyTime> ended_at_;    ///< since when the status has shown the end while the result is missing
  std::optional<SteadyTime> idle_since_;  ///< since when isIdle()
  // Callbacks run on the node's own thread, so none can arrive before all of these members are constructed.
  ros::Subscriber status_, feedback_, result_;
  Monitor monitor_;  ///< recognises a server by its publishers and its subscriptions
  ros::Publisher goal_, cancel_;
};

}  // namespace frontier_pilot
