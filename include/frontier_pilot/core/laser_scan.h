#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// A planar scan. Beam i points at `angle_min + i * angle_increment` in the sensor's frame, whose pose is
/// `T_base_sensor`. Angles are counter-clockwise as in the base frame: for a scanner mounted upside down the conversion
/// has negated `angle_min` and `angle_increment`.
struct LaserScan2 {
  Time stamp;                    ///< when the beams were measured (all at once)
  double angle_min = 0.0;        ///< [rad], in the sensor's frame
  double angle_increment = 0.0;  ///< [rad], never zero; negative when the scanner turns clockwise
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]
  Pose2 T_base_sensor;           ///< where the scanner sits on the base
  std::vector<float> ranges;     ///< [m], raw: may hold NaN, 0 and infinities, see `readRange`

  double angle(std::size_t beam) const { return angle_min + static_cast<double>(beam) * angle_increment; }
};

// A scoped enumerator shadows nothing, but GCC 12 warns about `kFree`, which grid.h also declares.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
/// What a raw range means.
enum class RangeKind {
  kInvalid,  ///< NaN, 0, or negative and finite: no information
  kHit,      ///< a surface at `distance`
  kTooNear,  ///< -inf or below `range_min`: an obstacle, taken to be at `range_min`
  kFree,     ///< +inf or beyond `range_max`: nothing up to `range_max`
};
#pragma GCC diagnostic pop

/// An interpreted range: `distance` [m] is where the surface is (kHit, kTooNear) or how far the beam is free (kFree); 0
/// if invalid.
struct RangeReading {
  RangeKind kind = RangeKind::kInvalid;
  double distance = 0.0;
};

/// Interprets a raw range by the conventions of sensor_msgs/LaserScan and REP 117. [AVO-2]
RangeReading readRange(float range, double range_min, double range_max);

/// `scan` with only every n-th beam, n being the smallest number that leaves at most `most` > 0 of them; unchanged if
/// it has no more than that.
LaserScan2 withAtMost(std::size_t most, LaserScan2 scan);

/// The reading of beam `beam`.
inline RangeReading readBeam(const LaserScan2& scan, std::size_t beam) {
  return readRange(scan.ranges[beam], scan.range_min, scan.range_max);
}

}  // namespace frontier_pilot
