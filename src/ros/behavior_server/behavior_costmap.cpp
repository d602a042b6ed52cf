#include "ros/behavior_server/behavior_costmap.h"

#include <algorithm>
#include <utility>

#include "ros/common/messages/conversions.h"
#include "ros/common/messages/message_problems.h"

namespace frontier_pilot {

BehaviorCostmap::BehaviorCostmap(const behavior::CollisionCheckParameters& parameters, const RobotModel& robot,
                                 BehaviorFrames frames, const TfBridge& tf)
    : surroundings_(parameters, robot), frames_(std::move(frames)), tf_(tf), timing_(robot.scanner) {
  frames_.base_frame = robot.baseFrameOr(frames_.base_frame);
  frames_.odom_frame = robot.odomFrameOr(frames_.odom_frame);
}

void BehaviorCostmap::subscribe(NodeConnections& connections) {
  connections.subscribeToScanner(tf_, frames_.base_frame, 1, &BehaviorCostmap::handleScan, this,
                                 ros::TransportHints().tcpNoDelay());
  connections.needPoseIn(frames_.odom_frame, "odom_frame", tf_, frames_.base_frame);
}

void BehaviorCostmap::handleScan(const sensor_msgs::LaserScan& msg) {
  std::string why;
  // The latest transform, not the one at the scan's stamp: the mount does not move, but its publisher may be late.
  const auto T_base_sensor = tf_.lookup3d(frames_.base_frame, msg.header.frame_id, Time{}, Duration::zero(), &why);
  if (!T_base_sensor) return rejections_.addWaiting(why);
  auto scan = toLaserScan(msg, *T_base_sensor, &why);
  if (!scan) return rejections_.add(why);
  timing_.apply(*scan);
  waiting_.add(std::move(*scan));
  takeIn();
}

void BehaviorCostmap::takeIn() {
  waiting_.take([this](Time time) { return tf_.lookup(frames_.odom_frame, frames_.base_frame, time); },
                [this](LaserScan2& scan, const Pose2& T_odom_base) { insert(scan, T_odom_base); });
}

void BehaviorCostmap::insert(LaserScan2& scan, const Pose2& T_odom_base) {
  const bool covered = placeBeams(motionDuring(scan), ScanReference::kEnd, scan);
  if (!scan_motion_.note(timing_, covered, scan, T_odom_base)) {
    rejections_.add(kFrozenScan);
  } else if (!surroundings_.insert(scan, T_odom_base)) {
    rejections_.add(kDoesNotShowAhead);
  }
}

PoseTrack BehaviorCostmap::motionDuring(const LaserScan2& scan) const {
  constexpr Duration kStep = std::chrono::milliseconds(10);
  constexpr int kMostSteps = 100;
  PoseTrack track;
  const Time end = scan.end();
  const Duration step = std::max(kStep, (end - scan.stamp) / kMostSteps);
  for (Time time = scan.stamp; time < end; time += step) {
    if (const auto pose = tf_.lookup(frames_.odom_frame, frames_.base_frame, time)) track.add(time, *pose);
  }
  if (const auto pose = tf_.lookup(frames_.odom_frame, frames_.base_frame, end)) track.add(end, *pose);
  return track;
}

void BehaviorCostmap::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  scan_motion_.report(status);
  rejections_.report(status);
}

void BehaviorCostmap::clear() {
  waiting_.clear();
  surroundings_.clear();
}

behavior::BehaviorInputs BehaviorCostmap::inputs(double max_age, Time now) {
  takeIn();
  behavior::BehaviorInputs inputs;
  const auto stamp = poseStamp();
  const auto T_odom_base = stamp ? tf_.lookup(frames_.odom_frame, frames_.base_frame, *stamp) : std::nullopt;
  if (T_odom_base) inputs.pose = StampedPose2{*stamp, *T_odom_base};
  inputs.look_ahead = surroundings_.lookAhead(max_age, now);
  return inputs;
}

}  // namespace frontier_pilot
