#include "ros/navigator/navigator_action.h"

#include <utility>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/tf/pose_in_frame.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

/// After a stop, for clients that hear it themselves to end their goals with that reason.
constexpr Duration kTimeToCancel = std::chrono::milliseconds(300);

}  // namespace

MoveBaseServer::MoveBaseServer(ros::NodeHandle& node, const TfBridge& tf, std::string map_frame, bool use_yaw)
    : tf_(tf),
      map_frame_(std::move(map_frame)),
      use_yaw_(use_yaw),
      simple_goals_(
          node.advertise<move_base_msgs::MoveBaseActionGoal>(std::string(names::kMoveBase) + names::kGoalOfAction, 5)),
      current_goal_(node.advertise<geometry_msgs::PoseStamped>(names::kCurrentGoal, 1)),
      server_(
          node, names::kMoveBase, [this](const Server::GoalHandle& handle) { handleGoal(handle); },
          [this](const Server::GoalHandle& handle) { handleCancel(handle); }, [this] { cancelAll(); }) {}

void MoveBaseServer::subscribe(NodeConnections& connections) {
  connections.subscribeToCommands(names::kSimpleGoal, 1, &MoveBaseServer::handleSimple, this);
  connections.subscribe(names::kMapReplaced, 1, &MoveBaseServer::handleReplaced, this);
}

std::optional<Pose2> MoveBaseServer::read(const geometry_msgs::PoseStamped& msg, std::string& why) const {
  return poseInFrame(msg, map_frame_, tf_, why);
}

void MoveBaseServer::endForReplacedMap() {
  map_replaced_ = true;
  if (!pending_) return;
  settle({pending_->id, navigation::NavResult::kAborted, navigation::NavReason::kMapReplaced});
  pending_.reset();
}

std::uint64_t MoveBaseServer::submit(const Pose2& T_map_goal) {
  // A goal that the navigator has not begun yet is preempted by the newer one.
  if (pending_) settle({pending_->id, navigation::NavResult::kPreempted, navigation::NavReason::kPreempted});
  pending_ = navigation::NavGoal{++last_id_, T_map_goal, use_yaw_};
  return last_id_;
}

void MoveBaseServer::handleGoal(const Server::GoalHandle& offered) {
  Server::GoalHandle handle = offered;
  std::string why;
  const auto goal = read(handle.getGoal()->target_pose, why);
  if (!goal) {
    THROTTLED_WARN("goal rejected: " << why);
    handle.setRejected({}, "invalid goal: " + why);
    return;
  }
  handle.setAccepted();
  handles_[submit(*goal)] = handle;
}

void MoveBaseServer::handleSimple(const geometry_msgs::PoseStamped& msg) {
  std::string why;
  if (!read(msg, why)) return bad_simple_goals_.add(why);
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = msg;
  simple_goals_.publish(server_.offer(goal));
}

void MoveBaseServer::handleCancel(const Server::GoalHandle& handle) {
  for (const auto& [id, known] : handles_) {
    if (known != handle) continue;
    if (pending_ && pending_->id == id) {
      cancelAll();  // the active goal had been replaced by this one
    } else {
      cancel_ = cancel_ || id == active_id_;
    }
    return;
  }
}

void MoveBaseServer::cancelAll() {
  if (pending_) settle({pending_->id, navigation::NavResult::kCanceled, navigation::NavReason::kCanceled});
  pending_.reset();
  cancel_ = cancel_ || active_id_ != 0;  // it may still be owed to a goal that was aborted
}

void MoveBaseServer::setStopped(bool stopped) {
  if (stopped) {
    stopped_since_ = stopped_since_.value_or(steadyNow());
    return;
  }
  if (stopped_since_) cancelForStop();
  stopped_since_.reset();
}

void MoveBaseServer::cancelForStop() {
  if (active_id_ == 0 && !pending_) return;
  THROTTLED_WARN("the goal is canceled because of the emergency stop");
  cancelAll();
}

void MoveBaseServer::fill(navigation::NavigatorInputs& inputs) {
  if (stopped_since_ && steadyNow() - *stopped_since_ > kTimeToCancel) cancelForStop();
  inputs.cancel = std::exchange(cancel_, false);
  inputs.map_replaced = std::exchange(map_replaced_, false);
  inputs.new_goal = std::exchange(pending_, std::nullopt);
  if (!inputs.new_goal) return;
  active_id_ = inputs.new_goal->id;
  goal_ = inputs.new_goal->T_map_goal;
  current_goal_.publish(toPoseStampedMsg(*goal_, map_frame_, rosNow()));
}

void MoveBaseServer::settle(const navigation::NavFinished& finished) {
  if (finished.id == active_id_) {
    active_id_ = 0;
    goal_.reset();
  }
  const auto found = handles_.find(finished.id);
  if (found == handles_.end()) return;
  Server::GoalHandle handle = found->second;
  handles_.erase(found);
  const std::string text = toString(finished.reason);
  switch (finished.result) {
    case navigation::NavResult::kSucceeded:
      return handle.setSucceeded({}, text);
    case navigation::NavResult::kPreempted:
    case navigation::NavResult::kCanceled:
      return handle.setCanceled({}, text);
    case navigation::NavResult::kAborted:
      THROTTLED_WARN("the goal is given up: " << text);
      return handle.setAborted({}, text);
  }
}

void MoveBaseServer::abortAll(const std::string& why) {
  cancel_ = true;
  active_id_ = 0;
  goal_.reset();
  for (auto& [id, handle] : std::exchange(handles_, {})) {
    if (pending_ && pending_->id == id) {
      handles_[id] = handle;
    } else {
      handle.setAborted({}, why);
    }
  }
}

void MoveBaseServer::feedback(const Pose2& T_map_base, Time stamp) {
  const auto active = handles_.find(active_id_);
  if (active == handles_.end()) return;
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position = toPoseStampedMsg(T_map_base, map_frame_, stamp);
  active->second.publishFeedback(feedback);
}

}  // namespace frontier_pilot
