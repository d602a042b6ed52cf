#include "frontier_pilot/sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "sim/collision/collision_scene.h"
#include "sim/placement.h"
#include "sim/scanners.h"
#include "sim/simulated_robot.h"
#include "sim/solid_cells.h"

namespace frontier_pilot::sim {
namespace {

enum NoiseStream : std::uint64_t { kOdometryNoise, kLidarNoise, kNoiseStreams };

std::string quoted(const std::string& robot) { return robot.empty() ? "the robot" : "robot '" + robot + "'"; }

double greatestRadius(const SimulatorParameters& parameters) {
  double radius = parameters.robot.drivenOutline().circumscribedRadius();
  for (const RobotKind& kind : parameters.kinds)
    radius = std::max(radius, kind.robot.drivenOutline().circumscribedRadius());
  return radius;
}

// The index of a robot's kind: 0 for that of `parameters.robot`, and after it those of `parameters.kinds`.
std::size_t kindOf(const RobotSpec& spec, const SimulatorParameters& parameters) {
  if (spec.robot.empty()) return 0;
  for (std::size_t i = 0; i < parameters.kinds.size(); ++i) {
    if (parameters.kinds[i].name == spec.robot) return i + 1;
  }
  throw std::runtime_error(quoted(spec.name) + " is to be a " + spec.robot + ", which is none of the kinds");
}

}  // namespace

struct Simulator::Impl {
  /// What robots of one kind have in common.
  struct Kind {
    Kind(std::size_t index, const RobotModel& robot, const LidarNoise& noise)
        : model(robot), footprint(robot.drivenOutline()), scanners(index, kStep, robot.scanner, noise) {}

    RobotModel model;
    Footprint footprint;
    Scanners scanners;
  };

  Impl(World given, const SimulatorParameters& parameters);

  void addRobot(const RobotSpec& spec, const SimulatorParameters& parameters);
  const Footprint& footprint(const SimulatedRobot& robot) const { return kinds[robot.kind].footprint; }
  Placement placeable(const Footprint& footprint, const Pose2& pose, std::optional<DiscIndex::Id> own) const;
  void drive(SimulatedRobot& robot);
  void put(SimulatedRobot& robot, const Pose2& pose);
  std::vector<bool> whoMustStay() const;
  bool startIsTaken(const SimulatedRobot& robot, const std::vector<bool>& stays) const;

  World world;
  CollisionScene scene;
  grids::RayCaster rays;
  std::vector<Kind> kinds;  ///< that of `parameters.robot`, and those of `parameters.kinds`
  Time now;
  bool start_was_chosen = false;
  std::vector<SimulatedRobot> robots;
  std::map<std::string, DiscIndex::Id> obstacles;
};

Simulator::Impl::Impl(World given, const SimulatorParameters& parameters)
    : world(std::move(given)),
      scene(world.map.geometry(), solidCells(world.map, parameters.unknown_is_free), greatestRadius(parameters)),
      rays(solidCells(world.map, parameters.unknown_is_free)) {
  kinds.emplace_back(0, parameters.robot, parameters.lidar);
  for (const RobotKind& kind : parameters.kinds) kinds.emplace_back(kinds.size(), kind.robot, parameters.lidar);
  for (const RobotSpec& spec : robotsOf(parameters, world)) addRobot(spec, parameters);
}

void Simulator::Impl::addRobot(const RobotSpec& spec, const SimulatorParameters& parameters) {
  const std::size_t index = kindOf(spec, parameters);
  Kind& kind = kinds[index];
  start_was_chosen = std::isnan(spec.x) && std::isnan(spec.y);
  const double yaw = normalizeAngle(spec.yaw);
  const Pose2 start =
      start_was_chosen ? startInTheMiddle(scene, kind.footprint, world.map, yaw) : Pose2(spec.x, spec.y, yaw);
  const Placement placement = placeable(kind.footprint, start, std::nullopt);
  if (placement != Placement::kDone)
    throw std::runtime_error(cannotStart(quoted(spec.name), kind.footprint, start, placement, scene, world.map));
  const auto seed = static_cast<std::uint64_t>(parameters.seed);
  const std::uint64_t stream = robots.size() * kNoiseStreams;
  const DiscIndex::Id disc = scene.addRobot(kind.footprint, start);
  robots.push_back({spec.name, index, start, start, start,
                    DiffDrive(kind.model.limits, fromSeconds(kind.model.watchdog)),
                    Odometry(parameters.odometry, parameters.odom_noise, Random(seed, stream + kOdometryNoise)),
                    Random(seed, stream + kLidarNoise), disc, LaserScan2{}, LaserScan2{}});
  kind.scanners.mountOn(robots.back());
}

void Simulator::Impl::drive(SimulatedRobot& robot) {
  robot.before = robot.pose;
  const double seconds = toSeconds(kStep);
  const Twist2& velocity = robot.drive.update(now, seconds);
  const Twist2 arc{velocity.linear * seconds, velocity.angular * seconds};
  const Motion motion = scene.drive(footprint(robot), robot.pose, arc, robot.disc);
  if (motion.blocked) robot.drive.block();
  if (motion.turn_blocked) robot.drive.blockTurn();
  if (!arc.isZero()) put(robot, motion.pose);
  robot.odometry.move(motion.driven.linear, motion.driven.angular, seconds);
  robot.contacts += motion.blocked && !robot.stalled ? 1 : 0;
  robot.stalled = motion.blocked || (robot.stalled && scene.touches(footprint(robot), robot.pose, robot.disc));
}

void Simulator::Impl::put(SimulatedRobot& robot, const Pose2& pose) {
  robot.pose = pose;
  scene.moveRobot(robot.disc, pose);
}

Placement Simulator::Impl::placeable(const Footprint& footprint, const Pose2& pose,
                                     std::optional<DiscIndex::Id> own) const {
  if (!pose.isFinite()) return Placement::kNotFinite;
  const GridGeometry& geometry = world.map.geometry();
  const Vec2 size = Vec2(geometry.width, geometry.height) * geometry.resolution;
  const Vec2 inside = pose.position() - geometry.origin;
  if (!(inside.minCoeff() >= 0.0 && inside.x() < size.x() && inside.y() < size.y())) return Placement::kOutside;
  switch (scene.at(footprint, pose, own)) {
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

// The start poses do not overlap, but a robot that has to stay may stand on the start of another one.
std::vector<bool> Simulator::Impl::whoMustStay() const {
  std::vector<bool> stays(robots.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (stays[i] || !startIsTaken(robots[i], stays)) continue;
      stays[i] = changed = true;
    }
  }
  return stays;
}

bool Simulator::Impl::startIsTaken(const SimulatedRobot& robot, const std::vector<bool>& stays) const {
  for (const auto& [name, disc] : obstacles) {
    if (scene.overlaps(footprint(robot), robot.start, disc)) return true;
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (stays[i] && scene.overlaps(footprint(robot), robot.start, robots[i].disc)) return true;
  }
  return false;
}

Simulator::Simulator(World world, const SimulatorParameters& parameters)
    : impl_(std::make_unique<Impl>(std::move(world), parameters)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

Time Simulator::now() const { return impl_->now; }
const OccupancyGrid& Simulator::map() const { return impl_->world.map; }
std::size_t Simulator::robotCount() const { return impl_->robots.size(); }
const std::string& Simulator::name(std::size_t robot) const { return impl_->robots[robot].name; }
const RobotModel& Simulator::model(std::size_t robot) const { return impl_->kinds[impl_->robots[robot].kind].model; }
void Simulator::setCommand(std::size_t robot, const Twist2& twist) {
  impl_->robots[robot].drive.command(twist, impl_->now);
}
bool Simulator::startWasChosen() const { return impl_->start_was_chosen; }
const Pose2& Simulator::startPose(std::size_t robot) const { return impl_->robots[robot].start; }
const Pose2& Simulator::pose(std::size_t robot) const { return impl_->robots[robot].pose; }
const Twist2& Simulator::velocity(std::size_t robot) const { return impl_->robots[robot].odometry.twist(); }
const Pose2& Simulator::odometry(std::size_t robot) const { return impl_->robots[robot].odometry.pose(); }
const LaserScan2* Simulator::newScan(std::size_t robot) const {
  const SimulatedRobot& asked = impl_->robots[robot];
  return impl_->kinds[asked.kind].scanners.haveScanned() ? &asked.scan : nullptr;
}
bool Simulator::stalled(std::size_t robot) const { return impl_->robots[robot].stalled; }
int Simulator::contactCount(std::size_t robot) const { return impl_->robots[robot].contacts; }

std::optional<std::size_t> Simulator::find(const std::string& name) const {
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    if (impl_->robots[i].name == name) return i;
  }
  return std::nullopt;
}

void Simulator::step() {
  for (SimulatedRobot& robot : impl_->robots) impl_->drive(robot);
  impl_->now += kStep;
  for (Impl::Kind& kind : impl_->kinds)
    kind.scanners.measure(impl_->now, impl_->robots, impl_->rays, impl_->scene.discs());
}

Placement Simulator::setPose(const std::string& name, const Pose2& pose) {
  const std::optional<std::size_t> index = find(name);
  if (!index) return Placement::kUnknownRobot;
  SimulatedRobot& robot = impl_->robots[*index];
  const Pose2 to(pose.position(), normalizeAngle(pose.yaw));
  const Placement placement = impl_->placeable(impl_->footprint(robot), to, robot.disc);
  if (placement != Placement::kDone) return placement;
  impl_->put(robot, to);
  robot.drive.stop();
  robot.stalled = false;
  return placement;
}

Placement Simulator::spawnObstacle(const std::string& name, const Pose2& pose, double radius) {
  if (name.size() > bounds::kMostName) return Placement::kNameTooLong;
  if (impl_->obstacles.count(name) > 0) return Placement::kNameTaken;
  if (impl_->obstacles.size() >= bounds::kMostObstacles) return Placement::kTooMany;
  if (!pose.isFinite() || !std::isfinite(radius)) return Placement::kNotFinite;
  if (!bounds::isWithin(pose.position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate)) return Placement::kTooFar;
  if (radius <= 0.0) return Placement::kBadRadius;
  if (radius > bounds::kMostObstacleRadius) return Placement::kTooLarge;
  for (const SimulatedRobot& robot : impl_->robots) {
    if (impl_->scene.overlaps(impl_->footprint(robot), robot.pose, Disc{pose.position(), radius}))
      return Placement::kOnRobot;
  }
  impl_->obstacles[name] = impl_->scene.addObstacle({pose.position(), radius});
  return Placement::kDone;
}

Placement Simulator::removeObstacle(const std::string& name) {
  const auto found = impl_->obstacles.find(name);
  if (found == impl_->obstacles.end()) return Placement::kUnknownObstacle;
  impl_->scene.remove(found->second);
  impl_->obstacles.erase(found);
  return Placement::kDone;
}

std::vector<std::string> Simulator::resetPositions() {
  const std::vector<bool> stays = impl_->whoMustStay();
  std::vector<std::string> stayed;
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    SimulatedRobot& robot = impl_->robots[i];
    robot.drive.stop();
    if (stays[i]) {
      stayed.push_back(robot.name);
      continue;
    }
    impl_->put(robot, robot.start);
    robot.odometry.reset();
    robot.stalled = false;
  }
  return stayed;
}

}  // namespace frontier_pilot::sim
