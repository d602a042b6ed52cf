#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// The pose in `frame`, by the latest transform: the stamp of a goal is only the time when it was sent. Nothing if the
/// pose is malformed or no transform is known; `why` then says what is wrong.
std::optional<Pose2> poseInFrame(const geometry_msgs::PoseStamped& msg, const std::string& frame, const TfBridge& tf,
                                 std::string& why);

}  // namespace frontier_pilot
