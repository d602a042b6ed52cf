#pragma once

#include <actionlib/goal_id_generator.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/PatrolActionFeedback.h>
#include <frontier_pilot/PatrolActionResult.h>
#include <ros/node_handle.h>

#include <mutex>
#include <string>

#include "frontier_pilot/ros/service_caller.h"

namespace frontier_pilot {

/// The patrol action as an operator has it: it shows and stops everybody's patrols, not only those started here, which
/// a SimpleActionClient cannot. May be used from any thread.
class PatrolLink {
 public:
  PatrolLink(ros::NodeHandle& node, OperatorLog log);

  void start(int shape, double side, int laps);
  /// Every patrol, whoever started it.
  void cancelAll();
  /// The one that was started here, if it may still be going on.
  void cancelOwn();
  PatrolView view() const;

 private:
  void onStatus(const actionlib_msgs::GoalStatusArray& msg);
  void onFeedback(const PatrolActionFeedback& msg);
  void onResult(const PatrolActionResult& msg);

  OperatorLog log_;
  actionlib::GoalIDGenerator ids_;
  mutable std::mutex mutex_;  ///< guards the two that follow
  std::string own_id_;        ///< empty: none, or it has ended
  PatrolView view_;
  ros::Publisher goal_publisher_, cancel_publisher_;
  ros::Subscriber status_subscriber_, feedback_subscriber_, result_subscriber_;
};

}  // namespace frontier_pilot
