#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::fleet {

/// Most robots of a fleet: each has a view with the maps of all others.
constexpr std::size_t kMostRobots = 20;

/// A robot of the fleet and where it started. Only the starts relative to each other count.
struct FleetRobot {
  std::string name;
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad]

  Pose2 start() const { return {x, y, yaw}; }

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("name", name, "", "namespace of the robot");
    v.field("x", x, "m", "start, in a frame that all robots have in common", coordinate());
    v.field("y", y, "m", "start, in a frame that all robots have in common", coordinate());
    v.field("yaw", yaw, "rad", "start, in a frame that all robots have in common", coordinate());
  }
};

struct MapMergerParameters {
  std::vector<FleetRobot> robots;
  bool known_starts = true;
  double max_contradicted = 0.25;
  double check_period = 1.0;  ///< [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.list("robots", robots, "the robots; the common map lies where the first one started");
    v.field("known_starts", known_starts, "",
            "whether the robots' starts are those of `robots`; if not, they are found once the maps overlap");
    v.field(
        "max_contradicted", max_contradicted, "",
        "share of a robot's walls in the free space of others, and the other way round, beyond which its map is left "
        "out; it is taken in again below half of that",
        between(0.01, 1.0));
    v.field("check_period", check_period, "s", "time between two checks of that, of one robot each", timeSpan());
  }
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot::fleet
