#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "sim/collision/collision_map.h"
#include "sim/collision/outline_collision.h"
#include "sim/disc_index.h"

namespace frontier_pilot::sim {

/// What an outline overlaps.
enum class Obstruction { kNone, kWall, kRobot, kObstacle };

/// The result of a motion.
struct Motion {
  Pose2 pose;                 ///< where it ended, T_world_base
  Twist2 driven;              ///< the arc that was driven [m], [rad]
  bool blocked = false;       ///< something was in the way
  bool turn_blocked = false;  ///< and the rest of the turn, in place, was blocked as well
};

/// The outline of a robot, and that of what it touches.
struct Footprint {
  explicit Footprint(const Outline& given);

  double radius() const { return outline.circumscribedRadius(); }

  Outline outline;
  Outline touching;  ///< the outline, 1 mm larger on every side
};

/// Everything that robots can collide with: walls, obstacles and each other, with the outlines of both. For each
/// other's scanners robots are the disc around their outline. [SIM-3]
class CollisionScene {
 public:
  /// `solid`: see solidCells. `world`: the area in which most discs lie. `greatest_radius` [m]: of all robots.
  CollisionScene(const GridGeometry& world, const Grid<std::uint8_t>& solid, double greatest_radius);

  const DiscIndex& discs() const { return discs_; }
  /// `robot` must outlive it.
  DiscIndex::Id addRobot(const Footprint& robot, const Pose2& pose);
  DiscIndex::Id addObstacle(const Disc& disc);
  void moveRobot(DiscIndex::Id id, const Pose2& pose);
  void remove(DiscIndex::Id id) { discs_.remove(id); }

  /// What a robot at `pose` would overlap, except for the robot `own`.
  Obstruction at(const Footprint& robot, const Pose2& pose, std::optional<DiscIndex::Id> own) const;
  /// Whether a robot at `pose` would overlap the robot or the obstacle `id`, or `obstacle`.
  bool overlaps(const Footprint& robot, const Pose2& pose, DiscIndex::Id id) const {
    return overlaps(PlacedOutline(robot.outline, pose), id);
  }
  bool overlaps(const Footprint& robot, const Pose2& pose, const Disc& obstacle) const {
    return PlacedOutline(robot.outline, pose).overlapsDisc(obstacle);
  }
  /// Whether a robot at `pose` is within 1 mm of something.
  bool touches(const Footprint& robot, const Pose2& pose, DiscIndex::Id own) const;
  /// Moves a robot from `from` along `arc` [m], [rad] until it touches something. It then makes the rest of the turn in
  /// place, as far as that is free: a disc always turns, the corners of a polygon may be blocked.
  Motion drive(const Footprint& robot, const Pose2& from, const Twist2& arc, DiscIndex::Id own) const;
  /// The centre of the nearest cell at which a robot with the yaw of `pose` overlaps no wall.
  std::optional<Vec2> nearestFree(const Footprint& robot, const Pose2& pose) const {
    return walls_.nearestFree(robot.outline, pose);
  }

 private:
  double freeShare(const Footprint& robot, const Pose2& from, const Twist2& arc, DiscIndex::Id own) const;
  bool isBlocked(const Footprint& robot, const Pose2& pose, DiscIndex::Id own) const;
  bool isSurelyFree(const Footprint& robot, const Vec2& centre, double reach, DiscIndex::Id own) const;
  bool overlapsAnything(const PlacedOutline& placed, DiscIndex::Id own) const;
  bool overlaps(const PlacedOutline& placed, DiscIndex::Id id) const;

  CollisionMap walls_;
  DiscIndex discs_;
  std::vector<std::optional<PlacedOutline>> robots_;  ///< by the disc's id; none of an obstacle
};

}  // namespace frontier_pilot::sim
