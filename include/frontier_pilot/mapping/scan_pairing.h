#pragma once

#include <memory>
#include <optional>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/odometry_anchor.h"
#include "frontier_pilot/mapping/parameters.h"

namespace frontier_pilot::mapping {

/// A scan with its odometry, or one for which there is none and will be none.
struct PairedScan {
  LaserScan2 scan;                   ///< with its beams where the robot was at their times, see `placeBeams`
  std::optional<Pose2> T_odom_base;  ///< none: there is no odometry for the stamp
  bool covered = true;               ///< whether odometry covers all beams of a rolling scan
};

/// Pairs scans with odometry by stamp [MAP-1], because they arrive on different topics in any order. A rolling scan
/// waits for odometry up to its last beam, and is paired at the time of its middle.
class ScanPairing {
 public:
  explicit ScanPairing(const ScanPairingParameters& parameters = {});
  ~ScanPairing();
  ScanPairing(const ScanPairing&) = delete;
  ScanPairing& operator=(const ScanPairing&) = delete;

  /// A stamp that is older than the last one means that the clock was set back: earlier odometry is forgotten.
  void addOdometry(Time stamp, const Pose2& T_odom_base);
  /// The same without the jumps that `anchor` recognises; returns false if it withholds this message. If the robot
  /// itself has jumped, it was nowhere between the poses before and after that: earlier odometry is forgotten, and
  /// scans from before get none. [MAP-4]
  bool addOdometry(Time stamp, const Pose2& T_odom_base, OdometryAnchor& anchor);
  void addScan(LaserScan2 scan);
  /// The oldest scan, once its odometry is there or is not waited for any longer (it has waited too long, too many
  /// wait, or its stamp is too far ahead); call until there is none.
  std::optional<PairedScan> next(Time now);
  bool hasOdometry() const;
  void clear();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::mapping
