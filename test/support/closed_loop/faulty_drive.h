#pragma once

#include <optional>
#include <string>

#include "sim/lidar.h"
#include "sim/random.h"
#include "support/closed_loop/guided_drive.h"

namespace frontier_pilot::test {

/// A fault of a robot's sensors.
enum class SensorFault {
  kNone,
  kKidnap,       ///< the scanner sees another place for 3 s
  kDropout,      ///< 30 % of the beams give no reading, always
  kPerson,       ///< a person crosses the view at 1 m/s
  kOdomFrozen,   ///< odometry stands still for 1 s, and the motion meanwhile is lost
  kOdomMissing,  ///< there is no odometry for 1 s
};
/// Throws std::invalid_argument when there is no such fault.
SensorFault sensorFaultNamed(const std::string& name);

/// The scans and the odometry of a drive on which a sensor fault recurs every 30 s.
class FaultyDrive {
 public:
  FaultyDrive(sim::World world, sim::SimulatorParameters parameters, double distance, SensorFault fault);

  /// Drives on until there is a new scan; nullptr at the end.
  const LaserScan2* nextScan();
  /// Odometry as it is reported; nothing while it is missing.
  std::optional<Pose2> T_odom_base() const { return T_odom_base(drive_.now()); }
  /// The same at the stamp of a scan of the last second.
  std::optional<Pose2> T_odom_base(Time stamp) const;
  Pose2 T_map_base() const { return drive_.T_map_base(); }
  const GuidedDrive& drive() const { return drive_; }

 private:
  double sinceFault() const;
  bool isFaulty(double seconds) const;
  void movePerson();
  void freezeOdometry();
  const LaserScan2* seenElsewhere(const LaserScan2& scan);

  SensorFault fault_;
  GuidedDrive drive_;
  sim::Lidar lidar_;
  sim::Random random_{17};
  grids::RayCaster rays_;
  sim::DiscIndex nobody_;
  LaserScan2 elsewhere_;
  Pose2 last_odometry_;
  Pose2 T_reported_odom_;  ///< pose of the odometry frame in the reported one: the motion that was lost
};

}  // namespace frontier_pilot::test
