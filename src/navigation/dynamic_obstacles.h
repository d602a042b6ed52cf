#pragma once

#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "navigation/neighbours.h"

namespace frontier_pilot::navigation {

/// What stands or moves where the map knows the floor to be free: it was not there before, and may move. Groups of
/// neighbouring hits are tracked from scan to scan, and straight lines through their last places give their velocity,
/// as in the detection and tracking of moving objects (Wang, Thorpe, Thrun, Hebert & Durrant-Whyte, IJRR 26(9), 2007).
/// What is at a wall, or where nothing is known yet, does not count, but the part of a thing that is beside a wall
/// does. [MUL-3]
class DynamicObstacles {
 public:
  /// A scan whose beams have been placed, from a base at `T_map_base` at its stamp. Of a scan with more than 720 beams
  /// every n-th is looked at; of what it shows, the 50 nearest things.
  void update(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map);
  /// Where they are at `now`, those that stand with a velocity of zero; nothing that was last seen more than a second
  /// before.
  std::vector<SeenThing> at(Time now) const;
  void clear() { tracks_.clear(); }

 private:
  /// A group of hits at one time, in the map frame [m].
  struct Sight {
    Time at;
    Vec2 first = Vec2::Zero(), last = Vec2::Zero();  ///< its ends
    Vec2 nearest = Vec2::Zero();                     ///< its hit that is nearest to the robot
  };
  using Track = std::vector<Sight>;  ///< the same thing at several times, the last one at the end
  struct Group;
  struct Hits;

  static Hits hitsIn(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map);
  static std::vector<Sight> thingsAmong(Hits hits, const Vec2& robot);
  static Vec2 velocityOf(const Track& track);
  static Vec2 slope(const Track& track, Vec2 Sight::*place);
  void follow(const std::vector<Sight>& sights, Time now);

  std::vector<Track> tracks_;
};

}  // namespace frontier_pilot::navigation
