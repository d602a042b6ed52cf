#pragma once

#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "frontier_pilot/behavior/collision_check.h"
#include "frontier_pilot/patrol/patrol.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/scan_motion_report.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// How the patrol server looks at what is around the robot.
struct PatrolSurroundingsParameters {
  bool check_collisions = true;
  double costmap_timeout = 1.0;
  behavior::CollisionCheckParameters check;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("check_collisions", check_collisions, "",
            "whether a patrol looks at the scan, and stops before an obstacle");
    v.field("costmap_timeout", costmap_timeout, "s", "greatest age of the last scan in the costmap", dataAge());
    check.describe(v);
  }
};

/// Keeps a costmap around the robot, from `scan` and odometry, and looks along the way of a patrol as the behaviours
/// do. Ground that no scan has seen counts as free. Where no scan was ever heard and the master knows nobody who
/// publishes one, patrols are driven by odometry alone.
class PatrolSurroundings {
 public:
  /// `tf` gives the scanner's mount, and must outlive it.
  PatrolSurroundings(const PatrolSurroundingsParameters& parameters, const RobotModel& robot, const TfBridge& tf);

  /// Subscribes to `scan`, unless it does not look. `connections` must outlive this.
  void subscribe(NodeConnections& connections);
  /// A jump makes it forget what it has seen: the costmap is in the frame of odometry.
  void addOdometry(Time stamp, const Pose2& T_odom_base);
  /// Makes the costmap as large as the look ahead of a patrol with these parameters takes.
  void lookAheadFor(const patrol::PatrolParameters& parameters);
  /// The look ahead at `now`, which refers to this object; empty if nobody looks.
  patrol::WayAhead wayAhead(Time now) const;
  /// Whether the node has just begun, so that a scanner may not have been found yet: at least until the master has told
  /// who publishes a scan.
  bool isConnecting() const;
  /// Whether patrols are driven without a look at the scan, although they should be with one.
  bool isBlind() const;
  /// Forgets everything, after a jump of the clock.
  void clear();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void handleScan(const sensor_msgs::LaserScan& msg);
  bool isPublished() const;

  PatrolSurroundingsParameters parameters_;
  std::string base_frame_;
  const TfBridge& tf_;
  behavior::CollisionCheck check_;
  ScanPlacer placer_;
  const NodeConnections* connections_ = nullptr;  ///< null if it does not look
  ros::Subscriber scan_;
  SteadyTime subscribed_;
  bool heard_ = false;  ///< a scan, ever
  ScanMotionReport scan_motion_;
  Rejections rejections_{"scan"};
};

}  // namespace frontier_pilot
