#include "sim/placement.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace frontier_pilot::sim {
namespace {

/// Why there is no place for a robot.
std::string whyNowhere(const OccupancyGrid& map) {
  const bool any_free = std::count(map.cells().begin(), map.cells().end(), kFree) > 0;
  if (any_free) return "the robot fits nowhere: every free place of the world is too narrow for it";
  return "the world has no free cell: in its picture, free floor has to be lighter than free_thresh says (white), or "
         "darker with 'negate: 1'";
}

}  // namespace

const char* toString(Placement placement) {
  switch (placement) {
    case Placement::kDone:
      return "done";
    case Placement::kUnknownRobot:
      return "there is no robot of that name";
    case Placement::kUnknownObstacle:
      return "there is no obstacle of that name";
    case Placement::kNameTaken:
      return "there is an obstacle of that name already";
    case Placement::kBadRadius:
      return "the radius must be positive";
    case Placement::kTooLarge:
      return "the radius must be at most 10 m: draw larger things into the world";
    case Placement::kTooFar:
      return "the place is farther than 1000 km from the origin";
    case Placement::kTooMany:
      return "there are 1000 obstacles already";
    case Placement::kNameTooLong:
      return "the name must have at most 256 characters";
    case Placement::kNotFinite:
      return "the pose is not finite";
    case Placement::kOutside:
      return "the place is outside of the world";
    case Placement::kInWall:
      return "the place is in or too near to a wall";
    case Placement::kOnRobot:
      return "the place is taken by a robot";
    case Placement::kOnObstacle:
      return "the place is taken by an obstacle";
  }
  return "?";
}

Pose2 startInTheMiddle(const CollisionScene& scene, const Footprint& robot, const OccupancyGrid& map, double yaw) {
  const GridGeometry& geometry = map.geometry();
  const Vec2 middle = geometry.origin + 0.5 * geometry.resolution * Vec2(geometry.width, geometry.height);
  const std::optional<Vec2> free = scene.nearestFree(robot, {middle.x(), middle.y(), yaw});
  if (!free) throw std::runtime_error(whyNowhere(map));
  return {free->x(), free->y(), yaw};
}

std::string cannotStart(const std::string& name, const Footprint& robot, const Pose2& start, Placement placement,
                        const CollisionScene& scene, const OccupancyGrid& map) {
  std::ostringstream text;
  text << name << " cannot start at (" << start.x << ", " << start.y << "): ";
  const std::optional<Vec2> free = start.isFinite() ? scene.nearestFree(robot, start) : std::nullopt;
  if (start.isFinite() && !free) return text.str() + whyNowhere(map);
  text << toString(placement);
  if (free) text << "; the nearest free place is (" << free->x() << ", " << free->y() << ")";
  return text.str();
}

}  // namespace frontier_pilot::sim
