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

/// Odometry of a robot that publishes only the transform from `odom` to the base: one message for each new transform,
/// with the twist computed from the difference of the last two. [ROB-1]
class TransformOdometry {
 public:
  /// `tf` must outlive it.
  TransformOdometry(const TfBridge& tf, std::string odom_frame, std::string base_frame)
      : tf_(tf), odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

  /// The next message; nothing while there is no new transform. Transforms less than 10 ms after the last one are
  /// skipped, because dividing by a short time amplifies the noise of the velocity.
  std::optional<nav_msgs::Odometry> next();

 private:
  const TfBridge& tf_;
  std::string odom_frame_, base_frame_;
  std::optional<MotionSample> last_;
};

/// Calls `handle` with each odometry message, whether `robot` publishes odometry as a topic or only as a transform. The
/// node waits for odometry only if it is `need`ed.
template <class Node>
void followOdometry(NodeConnections& connections, const TfBridge& tf, const RobotModel& robot,
                    const std::string& base_frame, std::uint32_t queue_size,
                    void (Node::*handle)(const nav_msgs::Odometry&), Node* node, const ros::TransportHints& hints = {},
                    Need need = Need::kNeeded) {
  constexpr double kPeriod = 0.02;  // between two looks at TF [s]
  if (robot.hasOdometryTopic()) {
    connections.subscribeToOne(names::kOdom, queue_size, handle, node, hints, need);
    return;
  }
  const auto source = std::make_shared<TransformOdometry>(tf, robot.odom_frame, base_frame);
  if (need == Need::kNeeded) connections.needPoseIn(robot.odom_frame, "odom_frame", tf, base_frame);
  connections.every(ros::Duration(kPeriod), [source, handle, node] {
    if (const auto msg = source->next()) (node->*handle)(*msg);
  });
}

}  // namespace frontier_pilot
