#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_check/observation.h"
#include "ros/check_robot/stream_recorder.h"
#include "ros/common/callback_guard.h"
#include "ros/common/messages/checked_subscription.h"

namespace frontier_pilot {

/// Listens to a robot without moving it: scan, odometry and TF. For the thread that runs the callbacks.
class RobotObserver {
 public:
  explicit RobotObserver(ros::NodeHandle& node);

  /// What was heard so far; without what only the master knows.
  robot_check::Observation observation() const;

 private:
  template <class Msg>
  using Event = ros::MessageEvent<const Msg>;
  struct Link {
    StreamRecorder stream;
    std::optional<Eigen::Isometry3d> T_parent_child;  ///< the latest that the nodes would take
    bool is_static = false;
  };

  template <class Msg>
  void listen(ros::NodeHandle& node, const std::string& topic, std::function<void(const Event<Msg>&)> handle);
  void takeScan(const Event<sensor_msgs::LaserScan>& event);
  void takeOdometry(const Event<nav_msgs::Odometry>& event);
  void takeTransforms(const Event<tf2_msgs::TFMessage>& event, bool is_static);

  CallbackGuard guard_;
  UnreadableMessages unreadable_;
  StreamRecorder scan_, odometry_;
  robot_check::ScanStream last_scan_;                          ///< the fields that only a scan has
  std::map<std::pair<std::string, std::string>, Link> links_;  ///< by child and parent
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace frontier_pilot
