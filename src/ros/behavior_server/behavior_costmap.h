#pragma once

#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "frontier_pilot/behavior/collision_check.h"
#include "ros/common/diagnostics.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// The frames that behaviours are driven in.
struct BehaviorFrames {
  std::string odom_frame = names::kOdomFrame;
  std::string base_frame;  ///< empty: the robot's

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("odom_frame", odom_frame, "", "frame of odometry", FrameName::kGiven);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
  }
};

/// Keeps a behaviour's surroundings from `scan` and TF, and its inputs.
class BehaviorCostmap {
 public:
  /// Frames as in `frames`, where an empty `base_frame` is the robot's.
  BehaviorCostmap(const behavior::CollisionCheckParameters& parameters, const RobotModel& robot, BehaviorFrames frames,
                  const TfBridge& tf);

  /// Begins to listen.
  void subscribe(NodeConnections& connections);

  /// With the robot's own frame where none was given.
  const BehaviorFrames& frames() const { return frames_; }
  /// When TF last knew where the robot is in `odom_frame`; nothing where it does not.
  std::optional<Time> poseStamp() const { return tf_.latestStamp(frames_.odom_frame, frames_.base_frame); }
  /// Pose and look-ahead at `now`, with a costmap at most `max_age` [s] old.
  behavior::BehaviorInputs inputs(double max_age, Time now);
  /// Forgets what was seen, after the clock has jumped back.
  void clear();
  const Rejections& rejections() const { return rejections_; }

 private:
  void handleScan(const sensor_msgs::LaserScan& msg);
  void takeIn();

  behavior::CollisionCheck surroundings_;
  BehaviorFrames frames_;
  const TfBridge& tf_;
  std::optional<LaserScan2> waiting_;  ///< until TF knows where the robot was
  Rejections rejections_{"scan"};
};

}  // namespace frontier_pilot
