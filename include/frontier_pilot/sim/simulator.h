#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/sim/parameters.h"
#include "frontier_pilot/sim/world_image.h"

namespace frontier_pilot::sim {

/// What became of a request to put something somewhere.
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

/// A kinematic world of robots of one outline with scanners, in fixed steps of simulated time. Poses are in the world's
/// frame. The same world, parameters and sequence of calls give the same bytes. [SIM-2]
class Simulator {
 public:
  static constexpr Duration kStep = std::chrono::milliseconds(10);

  /// Throws std::runtime_error where a robot starts outside of the world, in a wall or on another robot; the text says
  /// where, and where the nearest free place is. [SIM-1]
  Simulator(World world, const SimulatorParameters& parameters);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// One step of 10 ms for everything.
  void step();
  /// Time since the start, beginning at zero.
  Time now() const;

  const OccupancyGrid& map() const;
  std::size_t robotCount() const;
  const std::string& name(std::size_t robot) const;
  std::optional<std::size_t> find(const std::string& name) const;

  /// `twist` must be finite. It holds for the `watchdog` of the robot at most.
  void setCommand(std::size_t robot, const Twist2& twist);

  const Pose2& startPose(std::size_t robot) const;
  /// The truth, T_world_base, and the velocity really driven in the last step.
  const Pose2& pose(std::size_t robot) const;
  const Twist2& velocity(std::size_t robot) const;
  /// T_odom_base by the wheels: zero at the start.
  const Pose2& odometry(std::size_t robot) const;
  /// The scan measured at the end of the last step; nullptr if none was due.
  const LaserScan2* newScan(std::size_t robot) const;
  /// Whether the outline touches what it drove or turned into. [SIM-3]
  bool stalled(std::size_t robot) const;
  /// How often it came into contact.
  int contactCount(std::size_t robot) const;

  /// Carries a robot somewhere else; its odometry does not notice.
  Placement setPose(const std::string& robot, const Pose2& pose);
  /// A round obstacle; it may reach into walls but not onto a robot.
  Placement spawnObstacle(const std::string& name, const Pose2& pose, double radius);
  Placement removeObstacle(const std::string& name);
  /// Everyone back to the start, standing, odometry zero. Who finds that place taken by an obstacle stays where it is;
  /// the names of those are returned.
  std::vector<std::string> resetPositions();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The robots that `parameters` ask for: the list, or the one at x, y, yaw, or where the world says.
std::vector<RobotSpec> robotsOf(const SimulatorParameters& parameters, const World& world);

}  // namespace frontier_pilot::sim
