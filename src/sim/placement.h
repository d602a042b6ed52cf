#pragma once

#include <string>

#include "frontier_pilot/sim/simulator.h"
#include "sim/collision/collision_scene.h"

namespace frontier_pilot::sim {

/// Where a robot of the scene starts that is given no place: at the free place nearest to the middle of the world, in
/// the world's frame. Throws std::runtime_error if there is none, and says why.
Pose2 startInTheMiddle(const CollisionScene& scene, const Footprint& robot, const OccupancyGrid& map, double yaw);

/// Why the robot called `name` cannot start at `start`, with the nearest place where it can.
std::string cannotStart(const std::string& name, const Footprint& robot, const Pose2& start, Placement placement,
                        const CollisionScene& scene, const OccupancyGrid& map);

}  // namespace frontier_pilot::sim
