#include "frontier_pilot/sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::sim {
namespace {

enum NoiseStream : std::uint64_t { kOdometryNoise, kLidarNoise, kNoiseStreams };

std::string quoted(const std::string& robot) { return robot.empty() ? "the robot" : "robot '" + robot + "'"; }

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

std::vector<RobotSpec> robotsOf(const SimulatorParameters& parameters, const World& world) {
  if (!parameters.robots.empty()) return parameters.robots;
  const bool placed = !std::isnan(parameters.x) || !std::isnan(parameters.y);
  const Pose2 fallback = placed ? Pose2{} : world.start.value_or(Pose2{});
  const auto given = [](double value, double otherwise) { return std::isnan(value) ? otherwise : value; };
  return {{"", given(parameters.x, fallback.x), given(parameters.y, fallback.y), given(parameters.yaw, fallback.yaw)}};
}

Simulator::Simulator(World world, const SimulatorParameters& parameters)
    : world_(std::move(world)),
      surroundings_(world_.map.geometry(), solidCells(world_.map, parameters.unknown_is_free),
                    parameters.robot.drivenOutline()),
      rays_(solidCells(world_.map, parameters.unknown_is_free)),
      lidar_(parameters.robot.scanner, parameters.lidar),
      scan_period_(fromSeconds(1.0 / parameters.robot.scanner.rate)),
      next_scan_(Time{} + scan_period_) {
  for (const RobotSpec& spec : robotsOf(parameters, world_)) addRobot(spec, parameters);
}

void Simulator::addRobot(const RobotSpec& spec, const SimulatorParameters& parameters) {
  const Pose2 start(spec.x, spec.y, normalizeAngle(spec.yaw));
  const Placement placement = placeable(start, std::nullopt);
  if (placement != Placement::kDone) {
    std::ostringstream text;
    text << quoted(spec.name) << " cannot start at (" << spec.x << ", " << spec.y << "): " << toString(placement);
    const std::optional<Vec2> free = start.isFinite() ? surroundings_.nearestFree(start) : std::nullopt;
    if (free) text << "; the nearest free place is (" << free->x() << ", " << free->y() << ")";
    throw std::runtime_error(text.str());
  }
  const auto seed = static_cast<std::uint64_t>(parameters.seed);
  const std::uint64_t stream = robots_.size() * kNoiseStreams;
  const DiscIndex::Id disc = surroundings_.addRobot(start.position());
  robots_.push_back({spec.name, start, start,
                     DiffDrive(parameters.robot.limits, fromSeconds(parameters.robot.watchdog)),
                     Odometry(parameters.odometry, parameters.odom_noise, Random(seed, stream + kOdometryNoise)),
                     Random(seed, stream + kLidarNoise), disc, LaserScan2{}});
}

std::optional<std::size_t> Simulator::find(const std::string& name) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].name == name) return i;
  }
  return std::nullopt;
}

void Simulator::step() {
  for (Robot& robot : robots_) drive(robot);
  now_ += kStep;
  scanned_ = now_ >= next_scan_;
  if (scanned_) scanAll();
}

void Simulator::scanAll() {
  next_scan_ = std::max(next_scan_ + scan_period_, now_);
  for (Robot& robot : robots_) {
    robot.scan.stamp = now_;
    lidar_.scan(robot.pose, rays_, surroundings_.discs(), robot.disc, robot.lidar_noise, robot.scan);
  }
}

void Simulator::drive(Robot& robot) {
  const double seconds = toSeconds(kStep);
  const Twist2& velocity = robot.drive.update(now_, seconds);
  const Twist2 arc{velocity.linear * seconds, velocity.angular * seconds};
  const Motion motion = surroundings_.drive(robot.pose, arc, robot.disc);
  if (motion.blocked) robot.drive.block();
  if (motion.turn_blocked) robot.drive.blockTurn();
  if (!arc.isZero()) put(robot, motion.pose);
  robot.odometry.move(motion.driven.linear, motion.driven.angular, seconds);
  robot.contacts += motion.blocked && !robot.stalled ? 1 : 0;
  robot.stalled = motion.blocked || (robot.stalled && surroundings_.touches(robot.pose, robot.disc));
}

void Simulator::put(Robot& robot, const Pose2& pose) {
  robot.pose = pose;
  surroundings_.move(robot.disc, pose.position());
}

Placement Simulator::placeable(const Pose2& pose, std::optional<DiscIndex::Id> own) const {
  if (!pose.isFinite()) return Placement::kNotFinite;
  const GridGeometry& geometry = world_.map.geometry();
  const Vec2 size = Vec2(geometry.width, geometry.height) * geometry.resolution;
  const Vec2 inside = pose.position() - geometry.origin;
  if (!(inside.minCoeff() >= 0.0 && inside.x() < size.x() && inside.y() < size.y())) return Placement::kOutside;
  switch (surroundings_.at(pose, own)) {
    case Obstruction::kWall:
      return Placement::kInWall;
    case Obstruction::kRobot:
      return Placement::kOnRobot;
    case Obstruction::kObstacle:
      return Placement::kOnObstacle;
    case Obstruction::kNone:
      break;
  }
  return Placement::kDone;
}

Placement Simulator::setPose(const std::string& name, const Pose2& pose) {
  const std::optional<std::size_t> index = find(name);
  if (!index) return Placement::kUnknownRobot;
  Robot& robot = robots_[*index];
  const Pose2 to(pose.position(), normalizeAngle(pose.yaw));
  const Placement placement = placeable(to, robot.disc);
  if (placement != Placement::kDone) return placement;
  put(robot, to);
  robot.drive.stop();
  robot.stalled = false;
  return placement;
}

Placement Simulator::spawnObstacle(const std::string& name, const Pose2& pose, double radius) {
  if (name.size() > bounds::kMostName) return Placement::kNameTooLong;
  if (obstacles_.count(name) > 0) return Placement::kNameTaken;
  if (obstacles_.size() >= bounds::kMostObstacles) return Placement::kTooMany;
  if (!pose.isFinite() || !std::isfinite(radius)) return Placement::kNotFinite;
  if (!bounds::isWithin(pose.position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate)) return Placement::kTooFar;
  if (radius <= 0.0) return Placement::kBadRadius;
  if (radius > bounds::kMostObstacleRadius) return Placement::kTooLarge;
  for (const Robot& robot : robots_) {
    if (surroundings_.overlaps(robot.pose, Disc{pose.position(), radius})) return Placement::kOnRobot;
  }
  obstacles_[name] = surroundings_.addObstacle({pose.position(), radius});
  return Placement::kDone;
}

Placement Simulator::removeObstacle(const std::string& name) {
  const auto found = obstacles_.find(name);
  if (found == obstacles_.end()) return Placement::kUnknownObstacle;
  surroundings_.remove(found->second);
  obstacles_.erase(found);
  return Placement::kDone;
}

// The starts themselves do not overlap; but whoever has to stay may stand on the start of another one.
std::vector<bool> Simulator::whoMustStay() const {
  std::vector<bool> stays(robots_.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (stays[i] || !startIsTaken(robots_[i], stays)) continue;
      stays[i] = changed = true;
    }
  }
  return stays;
}

bool Simulator::startIsTaken(const Robot& robot, const std::vector<bool>& stays) const {
  for (const auto& [name, disc] : obstacles_) {
    if (surroundings_.overlaps(robot.start, disc)) return true;
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (stays[i] && surroundings_.overlaps(robot.start, robots_[i].disc)) return true;
  }
  return false;
}

std::vector<std::string> Simulator::resetPositions() {
  const std::vector<bool> stays = whoMustStay();
  std::vector<std::string> stayed;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.drive.stop();
    if (stays[i]) {
      stayed.push_back(robot.name);
      continue;
    }
    put(robot, robot.start);
    robot.odometry.reset();
    robot.stalled = false;
  }
  return stayed;
}

}  // namespace frontier_pilot::sim
