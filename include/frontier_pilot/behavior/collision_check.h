#pragma once

#include <memory>

#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::behavior {

/// The parameters of a CollisionCheck.
struct CollisionCheckParameters {
  FootprintParameters footprint;
  LocalCostmapParameters costmap;

  template <class Visitor>
  void describe(Visitor& v) {
    v.group("footprint", footprint, "what has to be free around the robot");
    v.group("costmap", costmap, "the local costmap that is built from the scan");
  }
};

/// Checks a behaviour's motion ahead: the footprint on a costmap that the scans fill, as long as the last scan is
/// recent. The costmap is a square window of the odometry frame that moves with the robot.
class CollisionCheck {
 public:
  explicit CollisionCheck(const CollisionCheckParameters& parameters = {}, const RobotModel& robot = {});
  ~CollisionCheck();
  CollisionCheck(CollisionCheck&&) noexcept;
  CollisionCheck& operator=(CollisionCheck&&) noexcept;
  CollisionCheck(const CollisionCheck&) = delete;
  CollisionCheck& operator=(const CollisionCheck&) = delete;

  /// Inserts a scan into the costmap; `T_odom_base` is the pose at its stamp. Beams clear the cells that they cross,
  /// hits occupy theirs, invalid beams change nothing. Unknown cells under the robot become free. Returns whether the
  /// scan was inserted: one that does not look ahead is not, because what was free when it was last seen may no longer
  /// be. A pose that the robot cannot have driven to since the last scan clears the costmap first: odometry was reset.
  bool insert(const LaserScan2& scan, const Pose2& T_odom_base);
  /// Motions are looked along as far as `reach` [m] from where the last scan was measured: from the next scan on, the
  /// window is as large as that takes, but at most `kMostSide`.
  void setReach(double reach);
  /// Forgets all scans.
  void clear();

  /// The costmap, in the odometry frame: -1 unknown, 0 free, 100 occupied; empty before the first scan.
  const OccupancyGrid& grid() const;
  /// The robot's outline with the padding around it, in the base frame.
  const Outline& footprint() const;
  /// The look-ahead for `BehaviorInputs` at `now`. It is empty, so that every motion is blocked, when the last scan is
  /// older than `max_age` [s]. [SPN-3] It refers to this object.
  LookAhead lookAhead(double max_age, Time now) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What is in the way of a robot that drives the arc `T_odom_base` -> [m] and [rad] of `arc`, in the order of the way.
/// It is looked at in pieces of at most 0.25 rad, each along its chord and at the turn at its end. A piece that was
/// never seen is no reason not to look at the next one.
SweepResult lookAlongArc(const LookAhead& look_ahead, const Pose2& T_odom_base, const Twist2& arc);

}  // namespace frontier_pilot::behavior
