#include "ros/common/tf/odometry_source.h"

namespace frontier_pilot {

std::optional<nav_msgs::Odometry> TransformOdometry::next() {
  const auto stamp = tf_.latestStamp(names::kOdomFrame, base_frame_);
  if (!stamp || (last_ && *stamp == last_->stamp)) return std::nullopt;
  const auto T_odom_base = tf_.lookup(names::kOdomFrame, base_frame_, *stamp);
  if (!T_odom_base) return std::nullopt;
  Odometry2 odometry{*stamp, *T_odom_base, {}};
  if (last_ && *stamp > last_->stamp) {
    const Pose2 motion = last_->T_odom_base.inverse() * *T_odom_base;
    const double seconds = toSeconds(*stamp - last_->stamp);
    odometry.twist = {motion.x / seconds, motion.yaw / seconds};
  }
  last_ = odometry;
  return toOdometryMsg(odometry, names::kOdomFrame, base_frame_);
}

}  // namespace frontier_pilot
