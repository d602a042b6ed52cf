#pragma once

#include <cmath>
#include <cstddef>
#include <deque>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::navigation {

/// The way that the robot has come: poses in the map frame, the oldest first, at least 3 cm or 0.1 rad apart, the last
/// 256 of them. It begins anew when the pose jumps, because what was free in the old pose's map need not be in
/// the new one's.
class DrivenTrack {
 public:
  void add(const Pose2& T_map_base) {
    if (!poses_.empty()) {
      const double moved = (T_map_base.position() - poses_.back().position()).norm();
      const double turned = std::abs(angleDifference(T_map_base.yaw, poses_.back().yaw));
      if (moved > kJump) clear();
      if (moved < kSpacing && turned < kTurn) return;
    }
    poses_.push_back(T_map_base);
    if (poses_.size() > kMost) poses_.pop_front();
  }
  void clear() { poses_.clear(); }
  const std::deque<Pose2>& poses() const { return poses_; }

 private:
  static constexpr double kSpacing = 0.03;   ///< [m]
  static constexpr double kTurn = 0.1;       ///< [rad]
  static constexpr double kJump = 0.3;       ///< between two poses [m]
  static constexpr std::size_t kMost = 256;  ///< poses

  std::deque<Pose2> poses_;
};

}  // namespace frontier_pilot::navigation
