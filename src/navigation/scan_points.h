#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>
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

/// What a scan, taken from a base at `T_map_base`, says of places in the map frame; without a scan, nothing.
class ScanView {
 public:
  ScanView() = default;
  ScanView(LaserScan2 scan, const Pose2& T_map_base) : scan_(std::move(scan)), T_map_base_(T_map_base) {}

  /// Where the scanner was.
  Vec2 scanner() const { return (T_map_base_ * scan_.T_base_sensor).position(); }
  /// Whether a beam pointed at `place` that says something, or one beside it: what stands there will be seen again.
  bool looksAt(const Vec2& place) const;
  /// Whether the beam that pointed at `place` ended more than `behind` [m] behind it. The beams beside it must agree:
  /// one drop-out does not make an obstacle vanish.
  bool seesThrough(const Vec2& place, double behind) const;

 private:
  /// The beam that pointed at a place, and those beside it.
  struct Look {
    double range = 0.0;  ///< of the place from the scanner [m]
    std::size_t first = 0, last = 0;
  };
  std::optional<Look> lookAt(const Vec2& place) const;

  LaserScan2 scan_;
  Pose2 T_map_base_;
};

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
