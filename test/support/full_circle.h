#pragma once

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot::test {

/// A scan of 360 beams all around in a round room of 2 m radius; beam 180 looks along the scanner's x axis.
inline LaserScan2 fullCircle(double mounted_at) {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 360.0;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.T_base_sensor = {0.0, 0.0, mounted_at};
  scan.ranges.assign(360, 2.0F);
  return scan;
}

}  // namespace frontier_pilot::test
