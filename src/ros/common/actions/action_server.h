#pragma once

#include <actionlib/goal_id_generator.h>
#include <actionlib/server/action_server_base.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <boost/thread/recursive_mutex.hpp>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/actions/action_requests.h"
#include "ros/common/callback_guard.h"
#include "ros/common/clock.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/checked_subscription.h"
#include "ros/common/messages/latched_repeats.h"

namespace frontier_pilot {

/// An action server. Goals and cancels are checked before actionlib's bookkeeping sees them: no stamp, id or number of
/// them can end the node, take precedence over later requests, or use memory without bound. The owner answers goal
/// handles as it would those of actionlib::ActionServer. [FLT-1]
template <class Action>
class ActionServer : public actionlib::ActionServerBase<Action> {
 public:
  using Base = actionlib::ActionServerBase<Action>;
  using typename Base::Feedback;
  using typename Base::Goal;
  using typename Base::GoalHandle;
  using typename Base::Result;
  using Handle = std::function<void(GoalHandle)>;

  /// `recalled()` is called for a goal whose cancel arrived before the goal itself. The goal would have replaced the
  /// active one, so the client wants neither of them.
  ActionServer(const ros::NodeHandle& node, const std::string& name, Handle goal, Handle cancel,
               std::function<void()> recalled)
      : Base(std::move(goal), std::move(cancel), false),
        node_(node),
        name_(name),
        recalled_(std::move(recalled)),
        rejections_("action " + name) {
    Base::start();
  }

  /// Takes a goal that comes from within the node, as if it had come over the topic but at once: a cancel that arrives
  /// after it finds it. Returns it with its id, to be published for those who watch the goals; when it then comes over
  /// the topic as well, it is ignored.
  typename Base::ActionGoalConstPtr offer(const Goal& goal) {
    const auto offered = boost::make_shared<typename Base::ActionGoal>();
    offered->goal_id.id = ids_.generateID().id;  // without a stamp: it is sent now
    offered->goal = goal;
    callbacks_.run(name_ + "/goal", [&] { takeGoal(offered); });
    return offered;
  }

  const Rejections& rejections() const { return rejections_; }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
    rejections_.report(status);
    if (callbacks_.total() > 0) callbacks_.report(status);
    unreadable_.report(status);
  }

 private:
  using typename Base::ActionFeedback;
  using typename Base::ActionGoal;
  using typename Base::ActionGoalConstPtr;
  using typename Base::ActionResult;
  using GoalID = actionlib_msgs::GoalID;
  using GoalStatus = actionlib_msgs::GoalStatus;
  using Lock = boost::recursive_mutex::scoped_lock;
  using Tracked = actionlib::StatusTracker<Action>;

  static constexpr std::uint32_t kQueue = 50;
  static constexpr double kStatusPeriod = 0.2;                           ///< [s]
  static constexpr Duration kMemory = std::chrono::seconds(5);           ///< of a goal that has ended
  static constexpr Duration kMemoryOfCancels = std::chrono::minutes(2);  ///< of goals that a link may hold back

  void initialize() override {
    const std::string goal_topic = name_ + "/goal", cancel_topic = name_ + "/cancel", status_topic = name_ + "/status";
    const std::string feedback_topic = name_ + "/feedback", result_topic = name_ + "/result";
    result_ = node_.advertise<ActionResult>(result_topic, kQueue);
    feedback_ = node_.advertise<ActionFeedback>(feedback_topic, kQueue);
    status_ = node_.advertise<actionlib_msgs::GoalStatusArray>(status_topic, kQueue, true);
    goals_ = listen<ActionGoal>(goal_topic, [this, goal_topic](const ros::MessageEvent<const ActionGoal>& event) {
      if (repeats_.isRepeat(event.getConnectionHeaderPtr(), steadyNow())) {
        sayRepeat(goal_topic, event.getPublisherName());
      } else {
        takeGoal(event.getConstMessage());
      }
    });
    cancels_ = listen<GoalID>(cancel_topic, [this](const auto& event) { takeCancel(*event.getConstMessage()); });
    // On steady time: clients take the status for a sign of life, also while the ROS clock stands still.
    timer_ = node_.createSteadyTimer(ros::WallDuration(kStatusPeriod), [this](const ros::SteadyTimerEvent&) {
      callbacks_.run(name_ + "/status", [&] {
        const Lock lock(this->lock_);
        repeats_.look(steadyNow());
        tidy(bounds::kMostTrackedGoals);
        publishStatus();
      });
    });
  }

  template <class Msg, class Take>
  ros::Subscriber listen(const std::string& topic, Take take) {
    ros::SubscribeOptions options = checkedSubscription<Msg>(
        topic, kQueue, unreadable_, [this, topic, take](const ros::MessageEvent<const Msg>& event) {
          callbacks_.run(topic, [&] { take(event); });
        });
    return node_.subscribe(options);
  }

  void takeGoal(const ActionGoalConstPtr& msg) {
    const Lock lock(this->lock_);
    if (const char* why = problemOf(msg->goal_id)) return rejections_.add(why);
    tidy(bounds::kMostTrackedGoals);
    const bool recalled = isRecalling(msg->goal_id.id);
    Base::goalCallback(withSafeStamp(msg));
    if (recalled) recalled_();
  }

  static ActionGoalConstPtr withSafeStamp(const ActionGoalConstPtr& msg) {
    const ros::Time stamp = goalStamp(msg->goal_id.stamp, rosNow());
    if (stamp == msg->goal_id.stamp) return msg;
    const auto goal = boost::make_shared<ActionGoal>(*msg);
    goal->goal_id.stamp = stamp;
    return goal;
  }

  static bool isRecalling(const Tracked& tracked) { return tracked.status_.status == GoalStatus::RECALLING; }

  bool isRecalling(const std::string& id) const {
    const auto recalls = [&](const Tracked& goal) { return goal.status_.goal_id.id == id && isRecalling(goal); };
    return std::any_of(this->status_list_.begin(), this->status_list_.end(), recalls);
  }

  void takeCancel(const GoalID& msg) {
    const Lock lock(this->lock_);
    if (const char* why = problemOf(msg)) return rejections_.add(why);
    tidy(bounds::kMostTrackedGoals);
    const auto cancel = boost::make_shared<GoalID>(msg);
    cancel->stamp = stampOrNow(msg.stamp, rosNow());
    Base::cancelCallback(cancel);
  }

  /// Moves stamps that lie in the future, because the clock was set back, to the present. Then drops goals that have
  /// ended: those that ended long ago, and the oldest where more than `most` goals are tracked. Not to be called from
  /// within actionlib's own methods, which use a goal again after they have published its end.
  void tidy(std::size_t most) {
    const Time now = rosNow();
    this->last_cancel_ = stampOrNow(this->last_cancel_, now);
    auto& list = this->status_list_;
    std::size_t excess = list.size() > most ? list.size() - most : 0;
    for (auto it = list.begin(); it != list.end();) {
      it->status_.goal_id.stamp = stampOrNow(it->status_.goal_id.stamp, now);
      const bool has_ended = it->handle_tracker_.expired();
      ros::Time& ended = it->handle_destruction_time_;
      if (has_ended) it->goal_.reset();  // which may be large; nobody can ask for it any more
      if (has_ended) ended = ended.isZero() ? toRosTime(now) : stampOrNow(ended, now);
      const Duration memory = isRecalling(*it) ? kMemoryOfCancels : kMemory;
      if (has_ended && (excess > 0 || now - toTime(ended) > memory)) {
        it = list.erase(it);
        excess -= excess > 0 ? 1U : 0U;
      } else {
        ++it;
      }
    }
  }

  /// Whether clients are told of it. They take a cancel that waits for its goal for a goal that is pursued.
  static bool isShown(const Tracked& tracked, Time now) {
    const ros::Time& ended = tracked.handle_destruction_time_;
    return !isRecalling(tracked) || ended.isZero() || now - toTime(ended) <= kMemory;
  }

  void publishStatus() override {
    const Lock lock(this->lock_);
    actionlib_msgs::GoalStatusArray msg;
    msg.header.stamp = ros::Time::now();
    msg.status_list.reserve(this->status_list_.size());
    for (const Tracked& tracked : this->status_list_) {
      if (isShown(tracked, rosNow())) msg.status_list.push_back(tracked.status_);
    }
    status_.publish(msg);
  }

  void publishResult(const GoalStatus& status, const Result& result) override {
    const Lock lock(this->lock_);
    const auto msg = stamped<ActionResult>(status);
    msg->result = result;
    result_.publish(msg);
    publishStatus();
  }

  void publishFeedback(const GoalStatus& status, const Feedback& feedback) override {
    const Lock lock(this->lock_);
    const auto msg = stamped<ActionFeedback>(status);
    msg->feedback = feedback;
    feedback_.publish(msg);
  }

  template <class Message>
  static boost::shared_ptr<Message> stamped(const GoalStatus& status) {
    auto msg = boost::make_shared<Message>();
    msg->header.stamp = ros::Time::now();
    msg->status = status;
    return msg;
  }

  ros::NodeHandle node_;
  std::string name_;
  std::function<void()> recalled_;
  Rejections rejections_;
  LatchedRepeats repeats_{node_.resolveName(name_ + "/goal"), steadyNow(), settlingOfARestart()};  ///< of goals
  actionlib::GoalIDGenerator ids_;  ///< of goals from within the node
  CallbackGuard callbacks_;
  UnreadableMessages unreadable_;
  ros::Publisher result_, feedback_, status_;
  ros::Subscriber goals_, cancels_;
  ros::SteadyTimer timer_;
};

/// An action server that pursues one goal at a time: a newer goal replaces the active one.
template <class Action>
class SingleGoalServer {
 public:
  using Server = ActionServer<Action>;
  using Goal = typename Server::Goal;
  using Result = typename Server::Result;
  using Feedback = typename Server::Feedback;
  using Start = std::function<void(const Goal&)>;
  /// Called when the active goal has to end, because a newer one has replaced it or because it was cancelled; `why`
  /// says so. Where the newer one was itself cancelled before it came, it is called without an active goal as well: the
  /// owner of several actions may pursue one of another, which it would have replaced.
  using Cancel = std::function<void(const std::string& why)>;

  SingleGoalServer(const ros::NodeHandle& node, const std::string& name, Start start, Cancel cancel)
      : start_(std::move(start)),
        cancel_(std::move(cancel)),
        server_(
            node, name, [this](const GoalHandle& handle) { take(handle); },
            [this](const GoalHandle& handle) {
              if (current_ && *current_ == handle) end("canceled");
            },
            [this] { end("replaced by a newer goal, which was canceled"); }) {}

  void publishFeedback(const Feedback& feedback) {
    if (current_) current_->publishFeedback(feedback);
  }
  void setSucceeded(const Result& result, const std::string& text) {
    if (auto handle = release()) handle->setSucceeded(result, text);
  }
  void setAborted(const Result& result, const std::string& text) {
    if (auto handle = release()) handle->setAborted(result, text);
  }
  void setPreempted(const Result& result, const std::string& text) {
    if (auto handle = release()) handle->setCanceled(result, text);
  }
  /// As ActionServer::offer.
  typename Action::_action_goal_type::ConstPtr offer(const Goal& goal) { return server_.offer(goal); }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const { server_.report(status); }

 private:
  using GoalHandle = typename Server::GoalHandle;

  std::optional<GoalHandle> release() { return std::exchange(current_, std::nullopt); }

  void take(const GoalHandle& handle) {
    if (current_) end("replaced by a newer goal");
    current_ = handle;
    current_->setAccepted();
    try {
      start_(*handle.getGoal());
    } catch (...) {
      setAborted({}, "could not be started");
      cancel_("could not be started");  // in case the behaviour had begun before the exception
      throw;
    }
  }

  void end(const std::string& why) {
    cancel_(why);
    setPreempted({}, why);  // unless the owner has done so in its callback
  }

  Start start_;
  Cancel cancel_;
  std::optional<GoalHandle> current_;
  Server server_;  ///< the last member, because its callbacks use the others
};

}  // namespace frontier_pilot
