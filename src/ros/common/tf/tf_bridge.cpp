#include "ros/common/tf/tf_bridge.h"

#include <chrono>
#include <exception>
#include <thread>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {

namespace {

/// Waits on steady time: TF's own wait runs on ROS time and would hang while the clock stands still.
std::optional<geometry_msgs::TransformStamped> wait(const tf2_ros::Buffer& buffer, const std::string& target,
                                                    const std::string& source, Time stamp, Duration timeout,
                                                    std::string* why) {
  const SteadyTime deadline = steadyNow() + timeout;
  while (true) {
    try {
      return buffer.lookupTransform(plain(target), plain(source), toRosTime(stamp));
    } catch (const std::exception& error) {  // not only TF's exceptions: the arithmetic of ROS time throws, too
      if (steadyNow() >= deadline) {
        if (why != nullptr) *why = printable(error.what(), bounds::kMostLine);  // it names the frames, however long
        return std::nullopt;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

geometry_msgs::TransformStamped stamped(const std::string& target, const std::string& source, const Pose2& pose,
                                        Time stamp) {
  geometry_msgs::TransformStamped msg;
  msg.header.frame_id = target;
  msg.header.stamp = toRosTime(stamp);
  msg.child_frame_id = source;
  msg.transform = toTransformMsg(pose);
  return msg;
}

}  // namespace

TfBridge::TfBridge() : listener_(buffer_) {}

std::optional<Pose2> TfBridge::lookup(const std::string& target, const std::string& source, Time stamp,
                                      Duration timeout, std::string* why) const {
  const auto msg = wait(buffer_, target, source, stamp, timeout, why);
  return msg ? toPose(msg->transform, why) : std::nullopt;
}

std::optional<Eigen::Isometry3d> TfBridge::lookup3d(const std::string& target, const std::string& source, Time stamp,
                                                    Duration timeout, std::string* why) const {
  const auto msg = wait(buffer_, target, source, stamp, timeout, why);
  return msg ? toIsometry(msg->transform, why) : std::nullopt;
}

std::optional<Time> TfBridge::latestStamp(const std::string& target, const std::string& source) const {
  const auto msg = wait(buffer_, target, source, Time{}, Duration::zero(), nullptr);
  return msg ? std::optional<Time>(toTime(msg->header.stamp)) : std::nullopt;
}

std::optional<Pose2> TfBridge::latest(const std::string& target, const std::string& source, Duration oldest) const {
  if (isSameFrame(target, source)) return Pose2();
  const auto stamp = latestStamp(target, source);
  const bool is_static = stamp && *stamp == Time{};
  if (!stamp || (!is_static && rosNow() - *stamp > oldest)) return std::nullopt;
  return lookup(target, source, *stamp);
}

std::set<std::string> TfBridge::frames() const {
  std::vector<std::string> names;
  buffer_._getFrameStrings(names);
  return {names.begin(), names.end()};
}

void TfBridge::broadcast(const std::vector<FramePose>& poses, Time stamp) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const FramePose& pose : poses) {
    const auto [sent, first] = sent_.try_emplace(pose.source, stamp);
    if (!first && sent->second == stamp) continue;
    sent->second = stamp;
    transforms.push_back(stamped(pose.target, pose.source, pose.T_target_source, stamp));
  }
  if (!transforms.empty()) broadcaster_.sendTransform(transforms);
}

void TfBridge::broadcastStatic(const std::string& target, const std::string& source, const Pose2& T_target_source,
                               double height) {
  auto msg = stamped(target, source, T_target_source, rosNow());
  msg.transform.translation.z = height;
  static_broadcaster_.sendTransform(msg);
}

}  // namespace frontier_pilot
