#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/surfaces/parameters.h"

namespace frontier_pilot::surfaces {

/// A point of a surface, and which way the surface looks there.
struct SurfacePoint {
  Vec2 position = Vec2::Zero();  ///< [m]
  Vec2 normal = Vec2::Zero();    ///< unit, out of the matter; zero where the neighbours do not lie on a line

  bool connected = false;  ///< to the point before it: near enough, and hardly a beam in between without a return
  double noise = 1e-4;     ///< variance of the position across the surface by the scanner's noise [m^2]
  double roughness = 0.0;  ///< variance of the surface itself about the line fitted to it [m^2]

  double variance() const { return noise + roughness; }
  bool hasNormal() const { return normal.x() != 0.0 || normal.y() != 0.0; }
};
using SurfacePoints = std::vector<SurfacePoint>;

/// What a scan says, read once for all that uses it: the surfaces that its beams met, and the beams that met nothing.
struct SurfaceScan {
  Time stamp;                ///< when the beams were measured
  Pose2 T_base_sensor;       ///< where the scanner sits on the base
  SurfacePoints points;      ///< the returns in the base frame, in the order of the beams
  std::vector<double> free;  ///< the directions, in the sensor's frame, in which nothing is up to `range_max` [rad]
  double range_max = 0.0;    ///< [m]

  /// How many beams say where there is something, or nothing.
  std::size_t usableBeams() const { return points.size() + free.size(); }
};

/// Reads `scan`, which must be well-formed and finite: its returns, with the normals of the lines that neighbours form,
/// and its beams without a return. Invalid and too near beams are left out.
/// A rough surface that is seen at a flat angle shows its tips and hides what lies between them: it seems to lie nearer
/// than when it is seen from the front. So there the roughness counts for more. Without that a robot between rough
/// walls seemed to drive 0.15 % farther than it did.
SurfaceScan readScan(const LaserScan2& scan, const SurfaceParameters& parameters = {});

/// `points`, which lie in one frame, in another.
SurfacePoints placed(const Pose2& T_other_points, SurfacePoints points);

/// The means of successive points that look the same way and lie within `thinning`, or farther apart if there would be
/// more than `max_points`: what a match costs does not depend on the scanner. Means, because any choice among noisy
/// points is a biased one: to keep the first in each square of a raster turned the robot by 0.8 degrees in 100 m.
SurfacePoints thinned(const SurfacePoints& points, const SurfaceParameters& parameters = {});

/// With points in between where connected ones lie on one surface: a map of the wall, not of the beams. Where there
/// are gaps a scan would match best where its beams meet those of an earlier one, which is where the robot then was.
SurfacePoints filled(const SurfacePoints& points, const SurfaceParameters& parameters = {});

/// The borders of the occupied cells towards free ones, in the map's frame.
SurfacePoints surfaceOf(const OccupancyGrid& map);

}  // namespace frontier_pilot::surfaces
