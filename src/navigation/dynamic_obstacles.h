#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/navigation/navigator_types.h"
#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::navigation {

/// What stands or moves where the map knows the floor to be free, and so has come there by itself: a robot, or
/// somebody's legs. Groups of neighbouring hits are followed from scan to scan, and a straight line through their last
/// places gives their velocity, as in the detection and tracking of moving objects (Wang, Thorpe, Thrun, Hebert &
/// Durrant-Whyte, IJRR 26(9), 2007). What is at a wall, or where nothing is known yet, is none. [MUL-3]
class DynamicObstacles {
 public:
  /// A scan whose beams have been placed, from a base at `T_map_base` at its stamp.
  void update(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map);
  /// Where they are at `now`, those that stand with a velocity of zero.
  std::vector<MovingDisc> at(Time now) const;
  void clear() { tracks_.clear(); }

 private:
  /// A group of hits at one time.
  struct Sight {
    Time at;
    Vec2 centre = Vec2::Zero();  ///< in the map frame [m]
    double radius = 0.0;         ///< half of its extent [m]
  };
  using Track = std::vector<Sight>;  ///< the same thing at several times, the last one at the end

  static std::vector<Sight> sightsIn(const LaserScan2& scan, const Pose2& T_map_base,
                                     const planning::ClearanceMap& map);
  static Vec2 velocityOf(const Track& track);
  void follow(const std::vector<Sight>& sights, Time now);

  std::vector<Track> tracks_;
};

}  // namespace frontier_pilot::navigation
