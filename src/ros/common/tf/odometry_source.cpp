#include "ros/common/tf/odometry_source.h"

namespace frontier_pilot {

std::optional<nav_msgs::Odometry> TransformOdometry::next() {
  constexpr Duration kLeast = std::chrono::milliseconds(10);
  const auto stamp = tf_.latestStamp(odom_frame_, base_frame_);
  if (!stamp) return std::nullopt;
  // After the clock was set back the previous pose cannot be used; the next transform has a velocity again.
  const bool went_back = last_ && *stamp < last_->stamp;
  if (last_ && !went_back && *stamp - last_->stamp < kLeast) return std::nullopt;
  const auto T_odom_base = tf_.lookup(odom_frame_, base_frame_, *stamp);
  if (!T_odom_base) return std::nullopt;
  MotionSample odometry{*stamp, *T_odom_base, {}};
  if (last_ && !went_back) {
    const Pose2 motion = last_->T_odom_base.inverse() * *T_odom_base;
    const double seconds = toSeconds(*stamp - last_->stamp);
    odometry.twist = {motion.x / seconds, motion.yaw / seconds};
  }
  last_ = odometry;
  return toOdometryMsg(odometry, odom_frame_, base_frame_);
}

}  // namespace frontier_pilot
