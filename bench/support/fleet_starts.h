#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/sim/parameters.h"

namespace frontier_pilot::bench {

/// The cells within `distance` [m] of `first` around which a disc of `radius` [m] is free, and to which it can be moved
/// from `first` over such cells alone; that of `first` in any case. `truth` and `first` are in the world's frame.
std::vector<Cell> placesAround(const OccupancyGrid& truth, const Vec2& first, double radius, double distance);

/// The starts of `count` robots, named robot_1 and so on: the first one at `first`, the others drawn at random by
/// `seed` from the free places within 3 m of all drawn before, that the disc of `radius` [m] around a robot can be
/// moved to from `first` without leaving that distance. They keep 0.3 m from each other and from walls. `truth` and
/// poses are in the world's frame. Throws std::runtime_error when there is no room for so many.
std::vector<sim::RobotSpec> fleetStarts(const OccupancyGrid& truth, const Pose2& first, std::size_t count,
                                        double radius, int seed);

}  // namespace frontier_pilot::bench
