#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::navigation {

/// The hits of a scan as points in the map frame [m]. The coordinates are in separate arrays so that loops vectorise.
struct ScanPoints {
  std::vector<float> x;
  std::vector<float> y;

  std::size_t size() const { return x.size(); }
  void add(const Vec2& point);
  /// Those within `radius` [m] of `centre`, padded with far away points to a multiple of `kLanes`.
  ScanPoints near(const Vec2& centre, double radius) const;
  /// Distance from `point` to the nearest one [m]; large if there is none.
  double distance(const Vec2& point) const;
  /// Distance to the nearest one from the outline of a robot at `T_map_base` [m], negative inside of it; large if there
  /// is none.
  double distance(const Outline& outline, const Pose2& T_map_base) const;

  static constexpr std::size_t kLanes = 8;
};

/// The hits of `scan`, taken from a base at `T_map_base`. A reading below the sensor's least range counts as a hit at
/// the edge of the robot's outline, if that is nearer than the reading.
ScanPoints scanPoints(const LaserScan2& scan, const Pose2& T_map_base, const Outline& outline);

/// Whether the scan is good enough to drive by: more than a tenth of all beams are valid, and it looks ahead. An empty
/// scan is not good enough.
bool isUsable(const LaserScan2& scan);

/// Poses of the last second, so that a scan can be placed where it was taken, not where the robot is by now.
class PoseHistory {
 public:
  /// A pose of the last instant once more replaces it, because it has been corrected; older ones are ignored.
  void add(Time stamp, const Pose2& T_map_base);
  void clear() { track_.clear(); }
  /// The pose at `stamp`, interpolated; beyond the ends the nearest one if it is at most 0.2 s away.
  std::optional<Pose2> at(Time stamp) const;

 private:
  PoseTrack track_{std::chrono::seconds(1)};
};

}  // namespace frontier_pilot::navigation
