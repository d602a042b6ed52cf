#include "sim/collision/collision_scene.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::sim {
namespace {

// No point of an outline moves farther between two collision checks, so that it cannot pass through anything but what
// is far thinner than a cell.
constexpr double kBite = 0.005;      // [m]
constexpr double kTouching = 0.001;  // [m]: nearer than this is contact
constexpr double kExact = 1e-6;      // [m]: how exactly the place of a collision is determined

// How far a point of the outline moves at most [m].
double travel(const Outline& outline, const Twist2& arc) {
  const double turning = outline.isDisc() ? 0.0 : std::abs(arc.angular) * outline.circumscribedRadius();
  return std::abs(arc.linear) + turning;
}

}  // namespace

Footprint::Footprint(const Outline& given) : outline(given), touching(given.padded(kTouching)) {}

CollisionScene::CollisionScene(const GridGeometry& world, const Grid<std::uint8_t>& solid, double greatest_radius)
    : walls_(solid, greatest_radius), discs_(world) {}

DiscIndex::Id CollisionScene::addRobot(const Footprint& robot, const Pose2& pose) {
  const DiscIndex::Id id = addObstacle({pose.position(), robot.radius(), robot.outline.inscribedRadius()});
  robots_[id].emplace(robot.outline, pose);
  return id;
}

void CollisionScene::moveRobot(DiscIndex::Id id, const Pose2& pose) {
  robots_[id].emplace(robots_[id]->outline(), pose);
  discs_.move(id, pose.position());
}

DiscIndex::Id CollisionScene::addObstacle(const Disc& disc) {
  const DiscIndex::Id id = discs_.add(disc);
  if (robots_.size() <= id) robots_.resize(id + 1U);
  robots_[id].reset();
  return id;
}

Obstruction CollisionScene::at(const Footprint& robot, const Pose2& pose, std::optional<DiscIndex::Id> own) const {
  const PlacedOutline placed(robot.outline, pose);
  if (walls_.overlaps(placed)) return Obstruction::kWall;
  Obstruction obstruction = Obstruction::kNone;
  discs_.visitNear(pose.position(), robot.radius(), [&](DiscIndex::Id id, const Disc&) {
    if (id == own || !overlaps(placed, id)) return;
    obstruction = robots_[id] ? Obstruction::kRobot : Obstruction::kObstacle;
  });
  return obstruction;
}

bool CollisionScene::touches(const Footprint& robot, const Pose2& pose, DiscIndex::Id own) const {
  // The corners of the padded outline lie at most twice the margin farther out.
  if (isSurelyFree(robot, pose.position(), 2.0 * kTouching, own)) return false;
  return overlapsAnything(PlacedOutline(robot.touching, pose), own);
}

Motion CollisionScene::drive(const Footprint& robot, const Pose2& from, const Twist2& arc, DiscIndex::Id own) const {
  const double share = freeShare(robot, from, arc, own);
  const Pose2 stop = integrate(from, arc, share);
  if (share == 1.0) return {stop, arc};
  const double linear = arc.linear * share;
  if (robot.outline.isDisc())
    return {{stop.position(), normalizeAngle(from.yaw + arc.angular)}, {linear, arc.angular}, true};
  const Twist2 rest{0.0, arc.angular * (1.0 - share)};
  const double turned = freeShare(robot, stop, rest, own);
  return {integrate(stop, rest, turned), {linear, arc.angular * share + rest.angular * turned}, true, turned < 1.0};
}

// The share of an arc, from 0 to 1, that is free.
double CollisionScene::freeShare(const Footprint& robot, const Pose2& from, const Twist2& arc,
                                 DiscIndex::Id own) const {
  const double way = travel(robot.outline, arc);
  if (way == 0.0 || isSurelyFree(robot, from.position(), std::abs(arc.linear), own)) return 1.0;
  const auto blocked = [&](double share) { return isBlocked(robot, integrate(from, arc, share), own); };
  const double bites = std::ceil(way / kBite);
  for (double bite = 1.0; bite <= bites; bite += 1.0) {
    if (!blocked(bite / bites)) continue;
    double free = (bite - 1.0) / bites;
    double taken = bite / bites;
    while ((taken - free) * way > kExact) {
      const double middle = 0.5 * (free + taken);
      (blocked(middle) ? taken : free) = middle;
    }
    return free;
  }
  return 1.0;
}

bool CollisionScene::isBlocked(const Footprint& robot, const Pose2& pose, DiscIndex::Id own) const {
  return !isSurelyFree(robot, pose.position(), 0.0, own) && overlapsAnything(PlacedOutline(robot.outline, pose), own);
}

// True only if the disc around the outline overlaps nothing, even when it moves by up to `reach`. Cheap.
bool CollisionScene::isSurelyFree(const Footprint& robot, const Vec2& centre, double reach, DiscIndex::Id own) const {
  if (!walls_.surelyFree(centre, robot.radius(), reach)) return false;
  const double radius = robot.radius() + reach;
  bool free = true;
  discs_.visitNear(centre, radius, [&](DiscIndex::Id id, const Disc& disc) {
    free = free && (id == own || !overlap(centre, radius, disc));
  });
  return free;
}

bool CollisionScene::overlapsAnything(const PlacedOutline& placed, DiscIndex::Id own) const {
  bool found = false;
  discs_.visitNear(placed.centre(), placed.radius(),
                   [&](DiscIndex::Id id, const Disc&) { found = found || (id != own && overlaps(placed, id)); });
  return found || walls_.overlaps(placed);
}

bool CollisionScene::overlaps(const PlacedOutline& placed, DiscIndex::Id id) const {
  return robots_[id] ? placed.overlaps(*robots_[id]) : placed.overlapsDisc(discs_[id]);
}

}  // namespace frontier_pilot::sim
