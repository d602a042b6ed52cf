#pragma once

#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "sim/diff_drive.h"
#include "sim/disc_index.h"
#include "sim/odometry.h"
#include "sim/random.h"

namespace frontier_pilot::sim {

/// The state of one robot of a simulation. Poses are in the world's frame.
struct SimulatedRobot {
  std::string name;
  std::size_t kind;  ///< the index of its kind in the simulation
  Pose2 start;
  Pose2 pose;
  Pose2 before;  ///< the pose at the beginning of the last step
  DiffDrive drive;
  Odometry odometry;
  Random lidar_noise;
  DiscIndex::Id disc;
  LaserScan2 scan;
  LaserScan2 unfinished;  ///< the beams of a rolling scan measured so far
  bool stalled = false;
  int contacts = 0;
};

}  // namespace frontier_pilot::sim
