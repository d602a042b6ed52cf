#include "ros/common/tf/pose_in_frame.h"

#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {

std::optional<Pose2> poseInFrame(const geometry_msgs::PoseStamped& msg, const std::string& frame, const TfBridge& tf,
                                 std::string& why) {
  const auto pose = toPose(msg.pose, &why);
  if (!pose || isSameFrame(msg.header.frame_id, frame)) return pose;
  why = problemOfFrameName(msg.header.frame_id);
  if (!why.empty()) return std::nullopt;
  const auto T_frame_msg = tf.lookup(frame, msg.header.frame_id, Time{}, Duration::zero(), &why);
  if (!T_frame_msg) return std::nullopt;
  return *T_frame_msg * *pose;
}

}  // namespace frontier_pilot
