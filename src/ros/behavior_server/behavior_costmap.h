#pragma once

#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "frontier_pilot/behavior/collision_check.h"
#include "ros/behavior_server/waiting_scans.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/scan_motion_report.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// The frames that the behaviours use.
struct BehaviorFrames {
  std::string odom_frame;  ///< empty: the robot's
  std::string base_frame;  ///< empty: the robot's

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("odom_frame", odom_frame, "", "frame of odometry; empty: robot/odom_frame", FrameName::kMayBeEmpty);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
  }
};

/// Keeps the costmap around the robot up to date from `scan` and TF, and provides the inputs of a behaviour.
class BehaviorCostmap {
 public:
  /// Empty names in `frames` stand for the robot's.
  BehaviorCostmap(const behavior::CollisionCheckParameters& parameters, const RobotModel& robot, BehaviorFrames frames,
                  const TfBridge& tf);

  /// Subscribes to `scan`.
  void subscribe(NodeConnections& connections);

  /// The frames, with the robot's base frame where none was given.
  const BehaviorFrames& frames() const { return frames_; }
  /// The stamp of the latest transform from `odom_frame` to the base; nothing if there is none.
  std::optional<Time> poseStamp() const { return tf_.latestStamp(frames_.odom_frame, frames_.base_frame); }
  /// Pose and look-ahead at `now`, with a costmap at most `max_age` [s] old.
  behavior::BehaviorInputs inputs(double max_age, Time now);
  /// Makes it as large as motions that end `reach` [m] from where the last scan was measured take.
  void setReach(double reach) { surroundings_.setReach(reach); }
  /// Clears the costmap, after a jump of the clock.
  void clear();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void handleScan(const sensor_msgs::LaserScan& msg);
  void takeIn();
  void insert(LaserScan2& scan, const Pose2& T_odom_base);
  /// The poses from the first to the last beam of `scan`, by TF.
  PoseTrack motionDuring(const LaserScan2& scan) const;

  behavior::CollisionCheck surroundings_;
  BehaviorFrames frames_;
  const TfBridge& tf_;
  WaitingScans waiting_;  ///< for TF
  BeamTiming timing_;
  ScanMotionReport scan_motion_;
  Rejections rejections_{"scan"};
};

}  // namespace frontier_pilot
