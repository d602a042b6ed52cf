#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::exploration {

/// How the scanner is expected to see from a goal.
struct ViewParameters {
  double sensor_range = 8.0;
  double unknown_depth = 1.5;
  int rays = 120;

  template <class V>
  void describe(V& v) {
    v.field("sensor_range", sensor_range, "m", "range that is counted on when a view is judged", positive());
    v.fixed({"unknown_depth", "rays"});
  }
};

/// What may be seen from a place.
struct ViewGain {
  double area = 0.0;     ///< unknown area in sight [m^2]
  double density = 0.0;  ///< unknown share of all the area in sight, 0 to 1
};

/// Expected newly seen area from `from` [m]: every beam goes up to the first occupied cell, the sensor's range, or
/// `unknown_depth` beyond the first unknown cell, and counts the sector of ground that it crosses from there on. Each
/// beam owns its sector, so nothing counts twice. [EXP-4]
ViewGain viewGain(const OccupancyGrid& map, const Vec2& from, const ViewParameters& parameters);

/// The plain definition: the unknown share of the cells within `radius` [m] of `from`; `area` is that of those cells.
/// [EXP-4]
ViewGain unknownShare(const OccupancyGrid& map, const Vec2& from, double radius);

/// The occupied share of the known cells within `radius` cells of `centre`; 0 where none is known. [EXP-3]
double obstacleDensity(const OccupancyGrid& map, Cell centre, int radius);

/// Whether every cell between the centres of the two, ends included, is free.
bool inSight(const OccupancyGrid& map, Cell from, Cell to);

}  // namespace frontier_pilot::exploration
