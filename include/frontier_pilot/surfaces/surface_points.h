#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/surfaces/parameters.h"

namespace frontier_pilot::surfaces {

/// A point on a surface, with the normal and the variances of the surface there.
struct SurfacePoint {
  Vec2 position = Vec2::Zero();  ///< [m]
  Vec2 normal = Vec2::Zero();    ///< of unit length, out of the obstacle; zero if the neighbours are not on a line

  bool connected = false;  ///< may be on one surface with the point before it, see `readScan`
  double noise = 1e-4;     ///< variance of the position across the surface due to the scanner's noise [m^2]
  double roughness = 0.0;  ///< variance of the surface itself about the line fitted to it [m^2]

  double variance() const { return noise + roughness; }
  bool hasNormal() const { return normal.x() != 0.0 || normal.y() != 0.0; }
};
using SurfacePoints = std::vector<SurfacePoint>;

/// A scan as all modules use it: the points where beams met surfaces, and the beams that met nothing.
struct SurfaceScan {
  Time stamp;                ///< when the beams were measured
  Pose2 T_base_sensor;       ///< pose of the scanner on the base
  SurfacePoints points;      ///< the returns in the base frame, in the order of the beams
  std::vector<double> free;  ///< the directions, in the sensor's frame, in which nothing is up to `range_max` [rad]
  double range_max = 0.0;    ///< [m]
  // Of a scan that was measured while the robot moved, where the scanner was, in the base frame; otherwise empty.
  std::vector<Vec2> point_origins;  ///< when it measured each of `points` [m]
  std::vector<Pose2> free_mounts;   ///< when it measured each of `free`

  /// Indices into `points` of those far behind both of their neighbours, as single beams give them that pass a pane of
  /// glass; in ascending order.
  std::vector<std::size_t> lone;

  std::size_t too_near = 0;  ///< the number of beams that met something nearer than the scanner's least range

  /// The number of beams that show an obstacle or free space.
  std::size_t usableBeams() const { return points.size() + free.size(); }
};

/// Reads `scan`, which must be well-formed and finite: its returns, with the normals of the lines that neighbours form,
/// and its beams without a return. Invalid and too near beams are left out. A return is connected to the one before it
/// unless they lie too far apart, a beam between them has no return, or more than three between them are invalid. Which
/// returns are lone is said in `lone_returns.h`.
/// A rough surface that is seen at a flat angle shows its tips and hides what lies between them, so it appears nearer
/// than from the front. The roughness is therefore weighted more there. Otherwise a robot between rough walls seemed to
/// drive 0.15 % farther than it did.
SurfaceScan readScan(const LaserScan2& scan, const SurfaceParameters& parameters = {});

/// `points` transformed by `T_other_points` into another frame.
SurfacePoints placed(const Pose2& T_other_points, SurfacePoints points);

/// The means of successive points that face the same way and lie within `thinning`, or farther apart if there would be
/// more than `max_points`, so that the cost of a match does not depend on the scanner. Means, because any selection of
/// noisy points is biased: keeping the first one in each cell of a grid turned the robot by 0.8 degrees in 100 m.
SurfacePoints thinned(const SurfacePoints& points, const SurfaceParameters& parameters = {});

/// `points`, with more added between connected ones on one surface, so that the map shows the wall and not the beams.
/// With gaps a scan would match best where its beams coincide with those of an earlier one, at that one's pose.
SurfacePoints filled(const SurfacePoints& points, const SurfaceParameters& parameters = {});

/// Points on the borders between occupied and free cells, in the map frame, with normals along the axes.
SurfacePoints surfaceOf(const OccupancyGrid& map);
/// How many points that would be.
std::size_t surfaceSize(const OccupancyGrid& map);

}  // namespace frontier_pilot::surfaces
