#include "support/slam_worlds.h"

#include "support/buildings.h"
#include "support/campus.h"
#include "support/closed_loop/corridor_world.h"
#include "support/drives/open_place.h"

namespace frontier_pilot::bench {
namespace {

sim::World openPlace() {
  const Grid<std::uint8_t> solid = test::openPlace();
  OccupancyGrid map(solid.geometry(), kFree);
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (solid[i] != 0) map[i] = kOccupied;
  }
  return {map, Pose2(10.0, 10.0, 0.0)};
}

}  // namespace

sim::World slamWorld(const std::string& name) {
  if (name == "open-place") return openPlace();
  if (name == "corridor") return test::corridorWorld();
  if (name == "campus") return campus();
  if (name != "willow") return sim::loadWorld(name);
  sim::World world = sim::loadWorld(willowGarage());
  world.start = Pose2(16.6, 21.6, 0.0);
  return world;
}

}  // namespace frontier_pilot::bench
