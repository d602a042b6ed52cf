#pragma once

#include <optional>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::mapping {

/// Whether the robot's pose on the map can be relied on, as far as scans can tell. [MAP-5]
class LocalizationWatch {
 public:
  /// `keeps_map`: the robot is only localised in its map, which grows old. People and moved things then hide the walls
  /// for a while, so that a scan which fits nowhere says little as long as odometry is good: for 2 m.
  explicit LocalizationWatch(bool keeps_map) : keeps_map_(keeps_map) {}

  /// The robot is looked for from now on. On a map without walls it cannot be found, and is where it is said to be.
  void lookFor(bool has_walls);
  /// `located` is false if the robot is not where its pose is, as far as a scan taken at `T_odom_base` can tell.
  void take(bool located, const Pose2& T_odom_base);
  /// A new map begins where the robot is.
  void reset();
  bool isLocalized() const { return localized_; }

 private:
  bool keeps_map_;
  bool can_be_found_ = true;  ///< whether the map has walls
  bool localized_ = true;
  std::optional<Pose2> at_;  ///< T_odom_base up to which the way was counted; none since the robot is looked for
  double driven_ = 0.0;      ///< since the last scan that located the robot [m]
};

}  // namespace frontier_pilot::mapping
