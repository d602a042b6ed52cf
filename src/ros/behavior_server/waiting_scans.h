#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Scans that wait until the robot's pose at the time of their last beams is known: poses may come more rarely than
/// scans, and later. The oldest is given up if too many wait. [SPN-3]
class WaitingScans {
 public:
  static constexpr std::size_t kMost = 20;  ///< half a second of a scanner with 40 Hz

  void add(LaserScan2 scan) {
    scans_.push_back(std::move(scan));
    if (scans_.size() > kMost) scans_.pop_front();
  }
  void clear() { scans_.clear(); }

  /// Calls `use(scan, T_odom_base)` for those at whose ends `pose_at(time)` gives the pose, in the order in which they
  /// came. They wait no longer, nor do those before them, whose poses will not be known any more.
  template <class PoseAt, class Use>
  void take(PoseAt pose_at, Use use) {
    std::deque<LaserScan2> later;
    for (LaserScan2& scan : std::exchange(scans_, {})) {
      if (const std::optional<Pose2> T_odom_base = pose_at(scan.end())) {
        later.clear();
        use(scan, *T_odom_base);
      } else {
        later.push_back(std::move(scan));
      }
    }
    scans_ = std::move(later);
  }

 private:
  std::deque<LaserScan2> scans_;
};

}  // namespace frontier_pilot
