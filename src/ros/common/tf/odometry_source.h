#pragma once

#include <nav_msgs/Odometry.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/core/robot_model.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// Odometry of a robot that publishes it as a transform alone: a message for each new transform from `odom` to the
/// base, with the twist that lies between the last two. [ROB-1]
class TransformOdometry {
 public:
  /// `tf` must outlive it.
  TransformOdometry(const TfBridge& tf, std::string odom_frame, std::string base_frame)
      : tf_(tf), odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

  /// None while there is no new transform, which is at least 10 ms after the last one: the velocity is a quotient.
  std::optional<nav_msgs::Odometry> next();

 private:
  const TfBridge& tf_;
  std::string odom_frame_, base_frame_;
  std::optional<MotionSample> last_;
};

/// Calls `handle` with each message of odometry, whether `robot` publishes it as a topic or as a transform alone.
template <class Node>
void followOdometry(NodeConnections& connections, const TfBridge& tf, const RobotModel& robot,
                    const std::string& base_frame, std::uint32_t queue_size,
                    void (Node::*handle)(const nav_msgs::Odometry&), Node* node,
                    const ros::TransportHints& hints = {}) {
  constexpr double kPeriod = 0.02;  // between two looks at TF [s]
  if (robot.hasOdometryTopic()) {
    connections.subscribeToOne(names::kOdom, queue_size, handle, node, hints);
    return;
  }
  const auto source = std::make_shared<TransformOdometry>(tf, robot.odom_frame, base_frame);
  connections.every(ros::Duration(kPeriod), [source, handle, node] {
    if (const auto msg = source->next()) (node->*handle)(*msg);
  });
}

}  // namespace frontier_pilot
