#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/navigation/navigator.h"

namespace frontier_pilot::bench {

/// What a robot under the navigator's control is doing, by what keeps it from its full speed.
enum class DrivingPhase {
  kFullSpeed,
  kAccelerating,  ///< commanded at full speed, and not there yet
  kCurve,         ///< slower because it turns as fast as it can
  kNearObstacle,  ///< slower because of what is around it, or to stay on its path
  kPathEnd,       ///< slower because the path ends soon
  kTurning,       ///< on the spot
  kStanding,      ///< has a goal, but waits for data or has no safe motion
  kRecovery,
  kNoGoal,
};
constexpr std::size_t kDrivingPhases = 9;

/// Where the time of one run, or of several, goes, and how near the robot comes to what is solid.
class DrivingReport {
 public:
  /// Adds `seconds` [s] at `share` of the full speed.
  void add(DrivingPhase phase, double share, double seconds);
  /// Adds a distance between the robot and the nearest obstacle [m].
  void addClearance(double clearance) { clearances_.push_back(clearance); }
  /// Adds progress along a path [m].
  void addProgress(double progress) { progress_ += progress; }
  void add(const DrivingReport& other);
  /// The shares of the time and of what is missing to full speed in each phase, and the distribution of clearances.
  std::string text() const;

 private:
  std::array<double, kDrivingPhases> seconds_{};
  std::array<double, kDrivingPhases> lost_{};  ///< how much sooner full speed had been as far [s]
  double progress_ = 0.0;                      ///< along the paths [m]
  std::vector<double> clearances_;
};

/// Observes a run by the ground truth of the simulator.
class DrivingMeter {
 public:
  /// `truth` is in the world's frame and must outlive the meter; all of it that is not free counts as solid.
  DrivingMeter(const RobotModel& robot, const OccupancyGrid& truth);

  /// To be called after each step of `seconds` [s]: the robot's true pose and velocity, and the navigator with its
  /// latest output.
  void observe(const Pose2& T_world_base, const Twist2& velocity, const navigation::Navigator& navigator,
               const navigation::NavigatorOutput& output, double seconds);
  const DrivingReport& report() const { return report_; }

 private:
  DrivingPhase phase(const Twist2& velocity, const navigation::Navigator& navigator,
                     const navigation::NavigatorOutput& output) const;
  double clearance(const Pose2& T_world_base) const;

  RobotLimits limits_;
  Outline outline_;
  const OccupancyGrid& truth_;
  DrivingReport report_;
  std::optional<Vec2> last_;
  Vec2 goal_ = Vec2::Zero();  ///< the end of the path that `progress_` is along
  double length_ = 0.0;       ///< and its length [m]
  double progress_ = 0.0;     ///< [m]
  double driven_ = 0.0;       ///< since the last sample of the clearance [m]
};

}  // namespace frontier_pilot::bench
