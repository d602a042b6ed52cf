#include "support/slam_worlds.h"

#include "support/buildings.h"
#include "support/campus.h"
#include "support/closed_loop/corridor_world.h"

namespace frontier_pilot::bench {
sim::World slamWorld(const std::string& name) {
  if (name == "corridor") return test::corridorWorld();
  if (name == "campus") return campus();
  if (name != "willow") return sim::loadWorld(name);
  sim::World world = sim::loadWorld(willowGarage());
  world.start = Pose2(16.6, 21.6, 0.0);
  return world;
}

}  // namespace frontier_pilot::bench
