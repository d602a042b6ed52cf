#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "sim/collision_map.h"
#include "sim/disc_index.h"
#include "sim/outline_collision.h"

namespace frontier_pilot::sim {

/// What an outline overlaps.
enum class Obstruction { kNone, kWall, kRobot, kObstacle };

/// What a motion came to.
struct Motion {
  Pose2 pose;                 ///< where it ended, T_world_base
  Twist2 driven;              ///< [m], [rad]
  bool blocked = false;       ///< something was in the way of it
  bool turn_blocked = false;  ///< and of turning on where it was stopped as well
};

/// All that robots of one outline can bump into: walls, obstacles, and each other. To each other, and to each other's
/// scanners, robots are the disc around their outline, so that two of them agree on whether they touch. [SIM-3]
class CollisionScene {
 public:
  /// `solid` as from solidCells, `world` the area that most discs lie in.
  CollisionScene(const GridGeometry& world, const Grid<std::uint8_t>& solid, const Outline& outline);

  const DiscIndex& discs() const { return discs_; }
  DiscIndex::Id addRobot(const Vec2& centre);
  DiscIndex::Id addObstacle(const Disc& disc);
  void move(DiscIndex::Id id, const Vec2& centre) { discs_.move(id, centre); }
  void remove(DiscIndex::Id id) { discs_.remove(id); }

  /// What a robot at `pose` would overlap, `own` being its own disc.
  Obstruction at(const Pose2& pose, std::optional<DiscIndex::Id> own) const;
  /// Whether a robot at `pose` would overlap the disc `id`, or an obstacle.
  bool overlaps(const Pose2& pose, DiscIndex::Id id) const { return overlaps(PlacedOutline(outline_, pose), id); }
  bool overlaps(const Pose2& pose, const Disc& obstacle) const {
    return PlacedOutline(outline_, pose).overlapsDisc(obstacle);
  }
  /// Whether a robot at `pose` is in contact, by a hair's breadth.
  bool touches(const Pose2& pose, DiscIndex::Id own) const;
  /// Where a robot comes from `from` along `arc` [m], [rad], until it touches something. What is left of the turn then
  /// is made where it stands, as far as that goes: a disc is never in its own way, a corner may be.
  Motion drive(const Pose2& from, const Twist2& arc, DiscIndex::Id own) const;
  /// The nearest place of a cell where a robot does not reach into a wall, with the yaw of `pose`.
  std::optional<Vec2> nearestFree(const Pose2& pose) const { return walls_.nearestFree(outline_, pose); }

 private:
  double travel(const Twist2& arc) const;
  double freeShare(const Pose2& from, const Twist2& arc, DiscIndex::Id own) const;
  bool isBlocked(const Pose2& pose, DiscIndex::Id own) const;
  bool isSurelyFree(const Vec2& centre, double reach, DiscIndex::Id own) const;
  bool overlapsAnything(const PlacedOutline& placed, DiscIndex::Id own) const;
  bool overlaps(const PlacedOutline& placed, DiscIndex::Id id) const;

  Outline outline_;
  Outline touching_;  ///< a hair's breadth larger
  CollisionMap walls_;
  DiscIndex discs_;
  std::vector<bool> is_robot_;  ///< by disc
};

}  // namespace frontier_pilot::sim
