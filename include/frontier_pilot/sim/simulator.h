#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/map_files/map_image.h"
#include "frontier_pilot/sim/parameters.h"

namespace frontier_pilot::sim {

/// The true map of a world, in the world's frame, and the default start pose if its file has one.
using World = map_files::MapImage;

/// Loads a world with map_files::readMapImage, and puts "world" before the text of what that throws. [SIM-1]
World loadWorld(const std::string& yaml_path);

/// The result of a request to place or remove a robot or an obstacle.
enum class Placement {
  kDone,
  kUnknownRobot,
  kUnknownObstacle,
  kNameTaken,
  kBadRadius,
  kTooLarge,
  kTooFar,
  kTooMany,
  kNameTooLong,
  kNotFinite,
  kOutside,
  kInWall,
  kOnRobot,
  kOnObstacle,
};
const char* toString(Placement placement);

/// A kinematic simulation of robots with scanners, in fixed steps of simulated time. Poses are in the
/// world's frame. The same world, parameters and sequence of calls give the same output, byte by byte. [SIM-2]
class Simulator {
 public:
  static constexpr Duration kStep = std::chrono::milliseconds(10);

  /// Throws std::runtime_error where a robot starts outside of the world, in a wall or on another robot; the text says
  /// where, and where the nearest free place is, or that there is none. Also where a robot is of no known kind. [SIM-1]
  Simulator(World world, const SimulatorParameters& parameters);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Advances everything by one step of 10 ms.
  void step();
  /// Time since the start, beginning at zero.
  Time now() const;

  const OccupancyGrid& map() const;
  std::size_t robotCount() const;
  const std::string& name(std::size_t robot) const;
  /// The description of its kind.
  const RobotModel& model(std::size_t robot) const;
  std::optional<std::size_t> find(const std::string& name) const;

  /// `twist` must be finite. It holds until the next command, but no longer than the robot's `watchdog` time.
  void setCommand(std::size_t robot, const Twist2& twist);

  const Pose2& startPose(std::size_t robot) const;
  /// Whether neither the parameters nor the world say where the robot starts, so that the simulator has chosen.
  bool startWasChosen() const;
  /// The true pose T_world_base, and the velocity that was actually driven in the last step.
  const Pose2& pose(std::size_t robot) const;
  const Twist2& velocity(std::size_t robot) const;
  /// T_odom_base by wheel odometry: zero at the start.
  const Pose2& odometry(std::size_t robot) const;
  /// The scan measured at the end of the last step; nullptr if none was due. The beams of a rolling scan were measured
  /// one after the other during the scan's period, each from where the robot was at that time. What else moves is
  /// resolved to a step. [SCN-1]
  const LaserScan2* newScan(std::size_t robot) const;
  /// Whether the robot is in contact with something that it drove or turned into. [SIM-3]
  bool stalled(std::size_t robot) const;
  /// How often it came into contact with something.
  int contactCount(std::size_t robot) const;

  /// Puts a robot somewhere else, at rest; its odometry does not change.
  Placement setPose(const std::string& robot, const Pose2& pose);
  /// A round obstacle; it may reach into walls but not onto a robot.
  Placement spawnObstacle(const std::string& name, const Pose2& pose, double radius);
  Placement removeObstacle(const std::string& name);
  /// Stops all robots and puts them back to their starts, with zero odometry. A robot whose start is taken by an
  /// obstacle, or by a robot that stays, stays where it is; the names of those are returned.
  std::vector<std::string> resetPositions();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The robots that `parameters` ask for: those of the list, or one at x, y, yaw or at the world's start pose; if
/// neither is given, its x and y are NaN, and it starts at the free place nearest to the middle of the world.
std::vector<RobotSpec> robotsOf(const SimulatorParameters& parameters, const World& world);

}  // namespace frontier_pilot::sim
