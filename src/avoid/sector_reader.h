#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/avoid/avoider.h"
#include "frontier_pilot/avoid/parameters.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::avoid {

/// Evaluates scans by sectors of the base frame, for any mount of the scanner. [AVO-1] [AVO-2] [AVO-5]
class SectorReader {
 public:
  explicit SectorReader(const AvoiderParameters& parameters);

  SectorDistances read(const LaserScan2& scan);

 private:
  /// A sector as its two border directions, so that no angle ever wraps.
  struct Borders {
    Vec2 from, to;
    bool contains(const Vec2& point) const;
  };
  static Borders bordersOf(const Sector& sector);
  const std::vector<Vec2>& directionsOf(const LaserScan2& scan);
  bool seesLaneBehind(const LaserScan2& scan);
  void add(const Vec2& point, SectorDistances& around) const;
  std::string judge(const LaserScan2& scan);

  Outline outline_;
  double half_lane_;
  double most_too_near_;  ///< greatest distance at which a reading below range_min is taken to be [m]
  double max_invalid_share_;
  Borders front_left_, front_right_, rear_;
  LaserScan2 layout_;             ///< angles and mount that `directions_` were computed for, without ranges
  std::vector<Vec2> directions_;  ///< of the beams, in the base frame
};

}  // namespace frontier_pilot::avoid
