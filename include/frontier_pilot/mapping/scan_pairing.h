#pragma once

#include <deque>
#include <optional>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/odometry_buffer.h"
#include "frontier_pilot/mapping/scan_verdict.h"

namespace frontier_pilot::mapping {

struct ScanPairingParameters {
  double patience = 0.3;  ///< how long a scan waits for its odometry [s]
  int max_waiting = 20;   ///< more scans than this do not wait
  OdometryBufferParameters odometry;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"patience", "max_waiting"});
    v.group("odometry", odometry, "odometry buffer");
  }
};

/// A scan that has met its odometry, or will not.
struct PairedScan {
  LaserScan2 scan;
  std::optional<Pose2> T_odom_base;  ///< none: there is no odometry for the stamp
};

/// Pairs scans with odometry by stamp [MAP-1]: they come by different ways, in any order.
class ScanPairing {
 public:
  explicit ScanPairing(const ScanPairingParameters& parameters = {});

  void addOdometry(Time stamp, const Pose2& T_odom_base) { odometry_.add(stamp, T_odom_base); }
  void addScan(LaserScan2 scan) { waiting_.push_back(std::move(scan)); }
  /// The oldest scan that is decided, if any; call until there is none.
  std::optional<PairedScan> next(Time now);
  bool hasOdometry() const { return !odometry_.empty(); }
  void clear();

 private:
  bool mayWait(const LaserScan2& scan, Time now) const;

  ScanPairingParameters parameters_;
  OdometryBuffer odometry_;
  std::deque<LaserScan2> waiting_;
};

}  // namespace frontier_pilot::mapping
