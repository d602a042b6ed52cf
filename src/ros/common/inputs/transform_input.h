#pragma once

#include <sensor_msgs/LaserScan.h>

#include <functional>
#include <string>

#include "ros/common/inputs/input_watch.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// A frame that a node needs, and the launch files' argument that names it; empty if there is none.
struct NeededFrame {
  std::string name;
  std::string argument;
};

/// What to give to InputWatch::need for the transform from `source` to `target`. A frame that does not exist is named,
/// with the one that may be meant. `tf` must outlive it.
InputWatch::Missing needTransform(const TfBridge& tf, NeededFrame target, NeededFrame source);

/// The same for the mount of a scanner whose frame `scan_frame()` gives; nothing is missing while that is empty.
InputWatch::Missing needMount(const TfBridge& tf, std::string base_frame, std::function<std::string()> scan_frame);

/// Says of a scan whether a node could use it: it is well-formed, and TF has its mount.
std::function<bool(const sensor_msgs::LaserScan&)> scansThatCanBeUsed(const TfBridge& tf, std::string base_frame);

}  // namespace frontier_pilot
