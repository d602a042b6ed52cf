#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/system/closed_loop.h"

namespace frontier_pilot::bench {

/// The arguments of explore_bench, see kUsage.
struct ExploreOptions {
  std::vector<std::string> worlds;
  std::vector<int> seeds = {1, 2, 3, 4, 5};
  int robots = 1;
  std::string robot, limits;  ///< empty: the default robot, and the limits of the robot
  std::string strategy = "tour";
  std::optional<Pose2> start;
  double off_from = std::numeric_limits<double>::infinity();   ///< when the last robot is switched off [s]
  double off_until = std::numeric_limits<double>::infinity();  ///< when it is switched on again [s]
  double until = 2.0, limit = 7200.0, latency = 0.0;
  bool at_once = false, skewed = false, odom_noise = false, curve = false, log = false, twice = false,
       omniscient = false, no_agreement = false, driving = false, decisions = false;
  bool no_rule = false;
  std::string svg;
};

/// Throws std::invalid_argument with what is wrong.
ExploreOptions parseExploreOptions(const std::vector<std::string>& words);

RobotModel robotOf(const ExploreOptions& options);

/// The radius of the disc that reaches the floor which counts [m].
double floorRadius(const RobotModel& robot);

/// Throws what sim::loadWorld and fleetStarts throw.
system::ClosedLoopParameters parametersFor(const ExploreOptions& options, const std::string& world, int seed);

}  // namespace frontier_pilot::bench
