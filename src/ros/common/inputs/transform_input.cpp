#include "ros/common/inputs/transform_input.h"

#include <utility>

#include "robot_check/other_names.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

std::string sayMissing(const TfBridge& tf, const NeededFrame& target, const NeededFrame& source) {
  if (tf.lookup3d(target.name, source.name, Time{})) return {};
  const std::set<std::string> frames = tf.frames();
  for (const NeededFrame& needed : {target, source}) {
    if (frames.count(needed.name) > 0) continue;
    if (needed.argument.empty()) return "no frame " + needed.name + " in TF";
    return robot_check::sayMissingFrame(needed.name, frames, needed.argument);
  }
  return "no transform from " + target.name + " to " + source.name + " in TF";
}

}  // namespace

InputWatch::Missing needTransform(const TfBridge& tf, NeededFrame target, NeededFrame source) {
  return [&tf, target = std::move(target), source = std::move(source)](const InputWatch::Topics&) {
    return sayMissing(tf, target, source);
  };
}

InputWatch::Missing needMount(const TfBridge& tf, std::string base_frame, std::function<std::string()> scan_frame) {
  return [&tf, base_frame = std::move(base_frame), scan_frame = std::move(scan_frame)](const InputWatch::Topics&) {
    const std::string frame = scan_frame();
    return frame.empty() ? std::string() : sayMissing(tf, {base_frame, "base_frame"}, {frame, {}});
  };
}

std::function<bool(const sensor_msgs::LaserScan&)> scansThatCanBeUsed(const TfBridge& tf, std::string base_frame) {
  return [&tf, base_frame = std::move(base_frame)](const sensor_msgs::LaserScan& msg) {
    const auto T_base_sensor = tf.lookup3d(base_frame, msg.header.frame_id, Time{});
    return T_base_sensor && toLaserScan(msg, *T_base_sensor);
  };
}

}  // namespace frontier_pilot
