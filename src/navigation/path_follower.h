#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/outline_check.h"
#include "frontier_pilot/planning/path.h"
#include "navigation/scan_points.h"

namespace frontier_pilot::navigation {

/// What the follower looks at; all of it in the map frame.
struct FollowerInputs {
  Pose2 T_map_base;  ///< present one
  Twist2 twist;      ///< present one
  double age;        ///< of what these and the scan were measured by [s]
  const ScanPoints& scan;
  const planning::ClearanceMap& map;
};

struct FollowerOutput {
  Twist2 command;
  bool blocked = false;  ///< no motion along the path is safe; the command is zero
};

/// Follows a path with a differential drive and keeps the outline off the scan's points: pure pursuit (Coulter,
/// CMU-RI-TR-92-01, 1992), tried out before it is done. Some variants of it, bold and timid, are simulated over the
/// horizon with the acceleration limits, as the Dynamic Window Approach does with constant twists (Fox, Burgard &
/// Thrun, IEEE RAM 4(1), 1997); the one that gets farthest along the path wins among those that can still brake before
/// anything they meet.
class PathFollower {
 public:
  explicit PathFollower(const FollowerParams& params = {}, const RobotModel& robot = {});

  /// Starts on a new path; must not be empty. The robot need not stop.
  void setPath(planning::Path path);
  FollowerOutput update(const FollowerInputs& inputs);
  /// Turns on the spot by `angle` [rad], as fast as can be stopped in time.
  FollowerOutput turn(double angle, const FollowerInputs& inputs) const;

  const planning::Path& path() const { return path_; }
  /// How far the robot has come along the path [m].
  double progress() const { return progress_; }
  double remaining() const { return path_.length() - progress_; }
  /// Where the last update expects to be over the horizon, in the map frame.
  const std::vector<Vec2>& prediction() const { return prediction_; }

 private:
  /// A way to pursue the path.
  struct Policy {
    double lookahead;   ///< [m]
    double speed;       ///< [m/s]
    double turn_angle;  ///< [rad]
  };
  /// What became of it.
  struct Trial {
    Twist2 command;          ///< the first one
    double progress = 0.0;   ///< along the path at its end [m]
    double deviation = 0.0;  ///< from the path at its end [m]
    double free_time = 0.0;  ///< until it would touch something, or the horizon [s]
    std::vector<Vec2> points;

    double score() const;
  };
  /// What is near in one update, and how near it may come.
  struct Vicinity {
    ScanPoints points;
    const planning::ClearanceMap& map;
    const PathFollower& follower;
    /// How near each of the points may come [m]: to the middle of a disc, or to the outline. Where one is too near
    /// already, the others still keep their distance.
    std::vector<float> least_distances;
    double least_clearance;  ///< in the map [m]; 0 is no check
    bool corners_count;      ///< in the map

    bool isFree(const Pose2& pose, double speed) const;
    bool isFreeOfPoints(const Pose2& pose, float more) const;
    bool isDiscFreeOfPoints(const Vec2& position, float more) const;
  };

  Vicinity vicinity(const FollowerInputs& inputs) const;
  /// How far away a point is from the middle of a disc, or from the outline [m].
  double distanceTo(const Vec2& point, const Pose2& pose) const;
  /// How near a point may come that is as far away as `now` [m].
  double leastDistance(double now) const;
  Twist2 pursue(const Policy& policy, const Pose2& pose, const Twist2& twist, double along) const;
  double turnRate(double angle, const Twist2& twist) const;
  Trial tryOut(const Policy& policy, const FollowerInputs& inputs, const Vicinity& around) const;
  bool isSafe(const Trial& trial, const FollowerInputs& inputs) const;

  FollowerParams params_;
  RobotLimits limits_;
  Outline outline_;
  planning::OutlineCheck outline_on_map_;
  double radius_;  ///< of the disc that the outline is; 0 where it is none [m]
  planning::Path path_;
  double progress_ = 0.0;
  std::vector<Vec2> prediction_;
};

/// The rate to turn by `angle` [rad] with, as fast as can be stopped in time.
double stoppableRate(double angle, const RobotLimits& limits);

}  // namespace frontier_pilot::navigation
