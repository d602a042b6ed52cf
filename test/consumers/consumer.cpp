// A program of somebody else that builds on the installed modules: it matches two scans, plans a path and explores a
// world. Exit code 0 if all three come out as they must; else what did not is printed.
#include <cstdio>
#include <string>
#include <vector>

#include "examples.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/planning/global_planner.h"
#include "frontier_pilot/system/closed_loop.h"

namespace fp = frontier_pilot;

namespace {

// Each character stands for a square of 0.25 m: '#' is a wall, '.' is free, 'S' is where the robot starts.
const std::vector<std::string> kRooms = {
    "##########################",  //
    "#...........#............#",  //
    "#...........#............#",  //
    "#...S.......#............#",  //
    "#........................#",  //
    "#........................#",  //
    "#...........#............#",  //
    "#...........#............#",  //
    "##########################",
};
constexpr int kMagnification = 5;  // cells of 0.05 m for each character

fp::sim::World drawnWorld() {
  fp::GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.width = static_cast<int>(kRooms.front().size()) * kMagnification;
  geometry.height = static_cast<int>(kRooms.size()) * kMagnification;
  fp::sim::World world{fp::OccupancyGrid(geometry, fp::kFree), std::nullopt};
  for (std::size_t i = 0; i < world.map.size(); ++i) {
    const fp::Cell cell = geometry.cell(i);
    const std::size_t row = kRooms.size() - 1 - static_cast<std::size_t>(cell.y / kMagnification);
    const char drawn = kRooms[row][static_cast<std::size_t>(cell.x / kMagnification)];
    if (drawn == '#') world.map[i] = fp::kOccupied;
    if (drawn == 'S') world.start = fp::Pose2(geometry.centre(cell), 0.0);
  }
  return world;
}

bool plansAPath(const fp::sim::World& world) {
  fp::planning::ClearanceMap clearance;
  clearance.setMap(world.map, world.map.geometry().rect());
  clearance.refresh();
  const fp::Vec2 goal(5.5, 0.6);
  const fp::planning::PlanResult result =
      fp::planning::GlobalPlanner().plan(clearance, {world.start->position(), goal});
  return result.found() && result.path.length() >= (goal - world.start->position()).norm();
}

bool explores(fp::sim::World world) {
  fp::system::ClosedLoop loop(std::move(world), {});
  while (!loop.done() && fp::toSeconds(loop.now()) < 600.0) loop.step();
  return loop.done() && loop.simulator().contactCount(0) == 0;
}

bool say(const char* what, bool succeeded) {
  if (!succeeded) std::printf("failed: %s\n", what);
  return succeeded;
}

}  // namespace

int main() {
  const bool matched = say("two scans are matched", examples::scanMatching());
  const bool planned = say("a path is planned", plansAPath(drawnWorld()));
  const bool explored = say("a world is explored without contact", explores(drawnWorld()));
  return matched && planned && explored ? 0 : 1;
}
