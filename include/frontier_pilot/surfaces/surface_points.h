#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/parameters.h"

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

struct SurfaceParameters {
  double fit_radius = 0.2;       ///< neighbours within this take part in fitting a line [m]
  double fit_error = 0.025;      ///< greatest standard deviation of the neighbours from that line [m]
  double range_noise = 0.01;     ///< standard deviation of a range [m]
  double bearing_noise = 0.002;  ///< of a beam's direction [rad]
  double roughness = 0.003;      ///< least standard deviation of a surface about the line fitted to it [m]
  double thinning = 0.1;         ///< points this near to each other are matched as one [m]
  int max_points = 250;          ///< no more points than this are matched
  double fill_spacing = 0.05;    ///< gaps between beams on one surface are filled this densely [m]
  double max_gap = 1.5;          ///< wider gaps are not filled [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"fit_radius", "fit_error", "range_noise", "bearing_noise", "roughness", "thinning", "max_points",
             "fill_spacing", "max_gap"});
  }
};

/// The returns of `scan` in the base frame, in the order of the beams, with the normals of the lines that neighbours
/// form. Beams without a return and too near ones are left out.
/// A rough surface that is seen at a flat angle shows its tips and hides what lies between them: it seems to lie nearer
/// than when it is seen from the front. So there the roughness counts for more. Without that a robot between rough
/// walls seemed to drive 0.15 % farther than it did.
SurfacePoints readSurface(const LaserScan2& scan, const SurfaceParameters& parameters = {});

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
