// A program of somebody else that builds on the installed modules: it matches two scans, plans a path and explores a
// world. Exit code 0 if all three come out as they must; else what did not is printed.
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/planning/global_planner.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/surfaces/surface_points.h"
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

// What a scanner at `pose` sees in a room of 6 m by 4 m around the origin.
fp::LaserScan2 scanFrom(const fp::Pose2& pose) {
  fp::LaserScan2 scan;
  constexpr int kBeams = 360;
  scan.angle_increment = 2.0 * fp::kPi / kBeams;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  for (int i = 0; i < kBeams; ++i) {
    const fp::Vec2 beam = fp::direction(pose.yaw + scan.angle(static_cast<std::size_t>(i)));
    const double to_x = ((beam.x() > 0.0 ? 3.0 : -3.0) - pose.x) / beam.x();
    const double to_y = ((beam.y() > 0.0 ? 2.0 : -2.0) - pose.y) / beam.y();
    scan.ranges.push_back(static_cast<float>(std::fmin(to_x, to_y)));
  }
  return scan;
}

bool matchesTwoScans() {
  const fp::Pose2 truth(0.06, -0.04, 0.03);
  fp::scan_matching::SurfaceMap map;
  map.add(fp::surfaces::filled(fp::surfaces::readSurface(scanFrom({}))), {});
  const fp::surfaces::SurfacePoints points = fp::surfaces::readSurface(scanFrom(truth));
  const fp::Pose2 found = fp::scan_matching::refine(map.surfels(), points, {}, std::nullopt, {}).pose;
  return (found.position() - truth.position()).norm() < 0.01 && std::abs(found.yaw - truth.yaw) < 0.005;
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
  const bool matched = say("two scans are matched", matchesTwoScans());
  const bool planned = say("a path is planned", plansAPath(drawnWorld()));
  const bool explored = say("a world is explored without contact", explores(drawnWorld()));
  return matched && planned && explored ? 0 : 1;
}
