#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/global_planner.h"
#include "frontier_pilot/sim/simulator.h"
#include "navigation/path_follower.h"
#include "sim/random.h"

namespace frontier_pilot::test {

/// A simulated robot that is driven by its true pose from place to place over the reachable floor: the same drive for
/// every seed, whatever its scanner and odometry report. The places are random, the paths between them are planned on
/// the true map.
class GuidedDrive {
 public:
  /// Throws what sim::Simulator throws. The drive ends when the robot has driven `distance` [m].
  GuidedDrive(sim::World world, const sim::SimulatorParameters& parameters, double distance);

  /// Drives on until there is a new scan; nullptr at the end of the drive. Throws std::runtime_error when stuck.
  const LaserScan2* nextScan();

  sim::Simulator& simulator() { return simulator_; }
  /// The true pose in the frame of the start pose, where odometry and the map begin.
  Pose2 T_map_base() const { return simulator_.startPose(0).inverse() * simulator_.pose(0); }
  const Pose2& T_odom_base() const { return simulator_.odometry(0); }
  /// `T_map_base` and `T_odom_base` at the end of each of the last steps, for scans of earlier stamps.
  const PoseTrack& truth() const { return truth_; }
  const PoseTrack& odometry() const { return odometry_; }
  Time now() const { return simulator_.now(); }
  double distance() const { return distance_; }

 private:
  void steer();
  void headForNextPlace();

  sim::Simulator simulator_;
  planning::ClearanceMap clearance_;
  planning::GlobalPlanner planner_;
  navigation::PathFollower follower_;
  std::vector<Cell> places_;  ///< possible destinations, away from walls
  sim::Random random_{1};
  PoseTrack truth_, odometry_;
  double wanted_distance_;
  double distance_ = 0.0;
  Vec2 last_;
  int steps_ = 0;
  int moved_ = 0;    ///< the last step that moved the robot
  int blocked_ = 0;  ///< number of control cycles in a row in which the path was blocked
};

}  // namespace frontier_pilot::test
