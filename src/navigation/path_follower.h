#pragma once

#include <functional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/navigation/navigator_types.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/outline_check.h"
#include "frontier_pilot/planning/path.h"
#include "navigation/neighbours.h"
#include "navigation/scan_points.h"

namespace frontier_pilot::navigation {

/// Inputs of the follower. Poses and points are in the map frame, the twist is in the base frame.
struct FollowerInputs {
  Pose2 T_map_base;  ///< current one
  Twist2 twist;      ///< current one
  double age;        ///< of the older of the measured pose and the scan [s]
  const ScanPoints& scan;
  const planning::ClearanceMap& map;
  Neighbours neighbours = {};
};

struct FollowerOutput {
  Twist2 command;
  bool blocked = false;  ///< no motion along the path is safe; the command is zero
};

/// Follows a path with a differential drive and keeps the outline off the scan's points: pure pursuit (Coulter,
/// CMU-RI-TR-92-01, 1992), simulated before it is executed. Variants with different look-aheads and speeds are
/// simulated over the horizon with the acceleration limits, as the Dynamic Window Approach does with constant twists
/// (Fox, Burgard & Thrun, IEEE RAM 4(1), 1997); of those that can still brake before any contact, the one that gets
/// farthest along the path wins.
class PathFollower {
 public:
  explicit PathFollower(const FollowerParams& params = {}, const RobotModel& robot = {});

  /// Other limits, from the next update on.
  void setLimits(const RobotLimits& limits) { limits_ = limits; }
  /// Starts on a new path; must not be empty. The robot need not stop.
  void setPath(planning::Path path);
  FollowerOutput update(const FollowerInputs& inputs);
  /// Turns on the spot by `angle` [rad], as fast as can be stopped in time.
  FollowerOutput turn(double angle, const FollowerInputs& inputs) const;

  const planning::Path& path() const { return path_; }
  /// How far the robot has come along the path [m].
  double progress() const { return progress_; }
  double remaining() const { return path_.length() - progress_; }
  /// Positions that the last update expects over the horizon, in the map frame.
  const std::vector<Vec2>& prediction() const { return prediction_; }

 private:
  /// A variant of pure pursuit.
  struct Policy {
    double lookahead;   ///< [m]
    double speed;       ///< [m/s]
    double turn_angle;  ///< [rad]
  };
  /// The simulated outcome of a policy.
  struct Trial {
    Twist2 command;          ///< the first one
    double progress = 0.0;   ///< along the path at its end [m]
    double deviation = 0.0;  ///< from the path at its end [m]
    double free_time = 0.0;  ///< until it would touch something, or the horizon [s]
    std::vector<Vec2> points;

    double score() const;
  };
  /// Obstacles near the robot in one update, and how near they may come.
  struct Vicinity {
    ScanPoints points;
    const planning::ClearanceMap& map;
    const PathFollower& follower;
    /// How near each of the points may come [m]: to the centre of a disc, or to the outline. If one is too near
    /// already, the distances of the others still apply.
    std::vector<float> least_distances;
    double least_clearance;  ///< in the map [m]; 0: not checked
    bool corners_count;      ///< whether corners are checked in the map

    NeighbourCheck neighbours;

    bool isFree(const Pose2& pose, double speed) const;
    /// Whether the scan's points are `more` [m] farther away than the least distances.
    bool isFreeOfPoints(const Pose2& pose, float more) const;
    bool isOutlineFreeOfPoints(const Pose2& pose, float more) const;
    bool isDiscFreeOfPoints(const Vec2& position, float more) const;
  };

  Vicinity vicinity(const FollowerInputs& inputs) const;
  /// Distance of a point from the centre of a disc, or from the outline [m].
  double distanceTo(const Vec2& point, const Pose2& pose) const;
  /// How near a point may come [m] whose present distance is `now` [m].
  double leastDistance(double now) const;
  Twist2 pursue(const Policy& policy, const Pose2& pose, const Twist2& twist, double along) const;
  double turnRate(double angle, const Twist2& twist) const;
  Trial tryOut(const Policy& policy, const FollowerInputs& inputs, const Vicinity& around) const;
  bool isSafe(const Trial& trial, const FollowerInputs& inputs, const Vicinity& around) const;
  /// Whether the robot touches nothing, and stays on its side of what may move, when it follows `command` for
  /// `reaction` [s] and then brakes to a standstill. An outline needs that: while it brakes it may turn where the rest
  /// of the trial would not.
  bool canStop(const Twist2& command, double reaction, const FollowerInputs& inputs, const Vicinity& around) const;
  /// Whether it stays on its side of what may move meanwhile.
  bool staysOnItsSide(const Twist2& command, double reaction, const FollowerInputs& inputs,
                      const Vicinity& around) const;
  /// Whether the robot touches nothing that the scan shows if the navigator falls silent after `command`, which the
  /// base follows then for its lifetime. What a turn on the spot would touch is not looked at: a disc sweeps no new
  /// ground, and robots of another outline could not turn in narrow places any more. The idea is that of braking
  /// inevitable collision states (Bouraine, Fraichard and Salhi, Provably safe navigation for mobile robots with
  /// limited field-of-views in dynamic environments, Autonomous Robots 32, 2012), with the time to stop made longer.
  bool canBeTheLast(const Twist2& command, const FollowerInputs& inputs, const Vicinity& around) const;
  /// Whether `is_free` of each pose, twist and time [s] if the robot follows `command` for so many seconds and brakes.
  bool stopsWhere(const std::function<bool(const Pose2&, const Twist2&, double)>& is_free, const Twist2& command,
                  double seconds, const FollowerInputs& inputs) const;

  FollowerParams params_;
  RobotLimits limits_;
  Outline outline_;
  planning::OutlineCheck outline_on_map_;
  double radius_;  ///< of an outline that is a disc, else 0 [m]
  planning::Path path_;
  double progress_ = 0.0;
  std::vector<Vec2> prediction_;
};

/// The greatest rate [rad/s] from which a turn by `angle` [rad] can be stopped in time.
double stoppableRate(double angle, const RobotLimits& limits);

}  // namespace frontier_pilot::navigation
