#include "frontier_pilot/sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "sim/collision_scene.h"
#include "sim/diff_drive.h"
#include "sim/disc_index.h"
#include "sim/lidar.h"
#include "sim/odometry.h"
#include "sim/placement.h"
#include "sim/random.h"
#include "sim/solid_cells.h"

namespace frontier_pilot::sim {
namespace {

enum NoiseStream : std::uint64_t { kOdometryNoise, kLidarNoise, kNoiseStreams };

std::string quoted(const std::string& robot) { return robot.empty() ? "the robot" : "robot '" + robot + "'"; }

}  // namespace

struct Simulator::Impl {
  struct Robot {
    std::string name;
    Pose2 start;
    Pose2 pose;
    Pose2 before;  ///< the pose at the beginning of the last step
    DiffDrive drive;
    Odometry odometry;
    Random lidar_noise;
    DiscIndex::Id disc;
    LaserScan2 scan;
    LaserScan2 unfinished;  ///< the beams of a rolling scan measured so far
    bool stalled = false;
    int contacts = 0;
  };

  Impl(World given, const SimulatorParameters& parameters);

  void addRobot(const RobotSpec& spec, const SimulatorParameters& parameters);
  Placement placeable(const Pose2& pose, std::optional<DiscIndex::Id> own) const;
  void drive(Robot& robot);
  void put(Robot& robot, const Pose2& pose);
  void scanAll();
  bool sweepAll();
  void sweepAll(std::size_t beams);
  std::vector<bool> whoMustStay() const;
  bool startIsTaken(const Robot& robot, const std::vector<bool>& stays) const;

  World world;
  CollisionScene scene;
  grids::RayCaster rays;
  Lidar lidar;
  bool rolling;
  Duration scan_period;
  Duration beam_period;  ///< from one beam to the next of a rolling scan
  Time scan_start{};     ///< of the rolling scan that is being measured
  std::size_t next_beam = 0;
  Time now;
  Time next_scan;
  bool scanned = false;
  bool start_was_chosen = false;
  std::vector<Robot> robots;
  std::map<std::string, DiscIndex::Id> obstacles;
};

Simulator::Impl::Impl(World given, const SimulatorParameters& parameters)
    : world(std::move(given)),
      scene(world.map.geometry(), solidCells(world.map, parameters.unknown_is_free), parameters.robot.drivenOutline()),
      rays(solidCells(world.map, parameters.unknown_is_free)),
      lidar(parameters.robot.scanner, parameters.lidar),
      rolling(parameters.robot.scanner.rolling),
      scan_period(fromSeconds(1.0 / parameters.robot.scanner.rate)),
      beam_period(std::max(Duration(1), scan_period / parameters.robot.scanner.beams)),
      next_scan(Time{} + scan_period) {
  for (const RobotSpec& spec : robotsOf(parameters, world)) addRobot(spec, parameters);
}

void Simulator::Impl::addRobot(const RobotSpec& spec, const SimulatorParameters& parameters) {
  start_was_chosen = std::isnan(spec.x) && std::isnan(spec.y);
  const double yaw = normalizeAngle(spec.yaw);
  const Pose2 start = start_was_chosen ? startInTheMiddle(scene, world.map, yaw) : Pose2(spec.x, spec.y, yaw);
  const Placement placement = placeable(start, std::nullopt);
  if (placement != Placement::kDone)
    throw std::runtime_error(cannotStart(quoted(spec.name), start, placement, scene, world.map));
  const auto seed = static_cast<std::uint64_t>(parameters.seed);
  const std::uint64_t stream = robots.size() * kNoiseStreams;
  const DiscIndex::Id disc = scene.addRobot(start.position());
  robots.push_back({spec.name, start, start, start,
                    DiffDrive(parameters.robot.limits, fromSeconds(parameters.robot.watchdog)),
                    Odometry(parameters.odometry, parameters.odom_noise, Random(seed, stream + kOdometryNoise)),
                    Random(seed, stream + kLidarNoise), disc, LaserScan2{}, LaserScan2{}});
  lidar.describe(robots.back().unfinished);
}

void Simulator::Impl::scanAll() {
  next_scan = std::max(next_scan + scan_period, now);
  for (Robot& robot : robots) {
    robot.scan.stamp = now;
    lidar.scan(robot.pose, rays, scene.discs(), robot.disc, robot.lidar_noise, robot.scan);
  }
}

// Measures the beams of rolling scans whose time has come. Returns whether scans have been completed.
bool Simulator::Impl::sweepAll() {
  bool completed = false;
  while (scan_start + static_cast<std::int64_t>(next_beam) * beam_period <= now) {
    const auto due = static_cast<std::size_t>((now - scan_start) / beam_period) + 1;
    sweepAll(std::min(due, lidar.beamCount()));
    if (next_beam < lidar.beamCount()) break;
    for (Robot& robot : robots) {
      robot.unfinished.stamp = scan_start;
      robot.scan = robot.unfinished;
    }
    scan_start += scan_period;
    next_beam = 0;
    completed = true;
  }
  return completed;
}

// The beams up to, but not including, `end`. During a step of the simulation a robot moves evenly from where it was to
// where it is; everything else is where it is at the end of the step.
void Simulator::Impl::sweepAll(std::size_t end) {
  const double per_beam = toSeconds(beam_period) / toSeconds(kStep);
  const Time first = scan_start + static_cast<std::int64_t>(next_beam) * beam_period;
  const double begin = 1.0 - toSeconds(now - first) / toSeconds(kStep);
  for (Robot& robot : robots) {
    const Vec2 moved = robot.pose.position() - robot.before.position();
    const double turned = angleDifference(robot.pose.yaw, robot.before.yaw);
    const Lidar::Sweep sweep{next_beam, end, interpolate(robot.before, robot.pose, begin), per_beam * moved,
                             per_beam * turned};
    lidar.measure(sweep, rays, scene.discs(), robot.disc, robot.lidar_noise, robot.unfinished);
  }
  next_beam = end;
}

void Simulator::Impl::drive(Robot& robot) {
  robot.before = robot.pose;
  const double seconds = toSeconds(kStep);
  const Twist2& velocity = robot.drive.update(now, seconds);
  const Twist2 arc{velocity.linear * seconds, velocity.angular * seconds};
  const Motion motion = scene.drive(robot.pose, arc, robot.disc);
  if (motion.blocked) robot.drive.block();
  if (motion.turn_blocked) robot.drive.blockTurn();
  if (!arc.isZero()) put(robot, motion.pose);
  robot.odometry.move(motion.driven.linear, motion.driven.angular, seconds);
  robot.contacts += motion.blocked && !robot.stalled ? 1 : 0;
  robot.stalled = motion.blocked || (robot.stalled && scene.touches(robot.pose, robot.disc));
}

void Simulator::Impl::put(Robot& robot, const Pose2& pose) {
  robot.pose = pose;
  scene.move(robot.disc, pose.position());
}

Placement Simulator::Impl::placeable(const Pose2& pose, std::optional<DiscIndex::Id> own) const {
  if (!pose.isFinite()) return Placement::kNotFinite;
  const GridGeometry& geometry = world.map.geometry();
  const Vec2 size = Vec2(geometry.width, geometry.height) * geometry.resolution;
  const Vec2 inside = pose.position() - geometry.origin;
  if (!(inside.minCoeff() >= 0.0 && inside.x() < size.x() && inside.y() < size.y())) return Placement::kOutside;
  switch (scene.at(pose, own)) {
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

bool Simulator::Impl::startIsTaken(const Robot& robot, const std::vector<bool>& stays) const {
  for (const auto& [name, disc] : obstacles) {
    if (scene.overlaps(robot.start, disc)) return true;
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (stays[i] && scene.overlaps(robot.start, robots[i].disc)) return true;
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
void Simulator::setCommand(std::size_t robot, const Twist2& twist) {
  impl_->robots[robot].drive.command(twist, impl_->now);
}
bool Simulator::startWasChosen() const { return impl_->start_was_chosen; }
const Pose2& Simulator::startPose(std::size_t robot) const { return impl_->robots[robot].start; }
const Pose2& Simulator::pose(std::size_t robot) const { return impl_->robots[robot].pose; }
const Twist2& Simulator::velocity(std::size_t robot) const { return impl_->robots[robot].odometry.twist(); }
const Pose2& Simulator::odometry(std::size_t robot) const { return impl_->robots[robot].odometry.pose(); }
const LaserScan2* Simulator::newScan(std::size_t robot) const {
  return impl_->scanned ? &impl_->robots[robot].scan : nullptr;
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
  for (Impl::Robot& robot : impl_->robots) impl_->drive(robot);
  impl_->now += kStep;
  impl_->scanned = impl_->rolling ? impl_->sweepAll() : impl_->now >= impl_->next_scan;
  if (impl_->scanned && !impl_->rolling) impl_->scanAll();
}

Placement Simulator::setPose(const std::string& name, const Pose2& pose) {
  const std::optional<std::size_t> index = find(name);
  if (!index) return Placement::kUnknownRobot;
  Impl::Robot& robot = impl_->robots[*index];
  const Pose2 to(pose.position(), normalizeAngle(pose.yaw));
  const Placement placement = impl_->placeable(to, robot.disc);
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
  for (const Impl::Robot& robot : impl_->robots) {
    if (impl_->scene.overlaps(robot.pose, Disc{pose.position(), radius})) return Placement::kOnRobot;
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
    Impl::Robot& robot = impl_->robots[i];
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
