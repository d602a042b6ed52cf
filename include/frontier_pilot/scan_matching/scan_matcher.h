#pragma once

#include <Eigen/Core>
#include <optional>

#include "frontier_pilot/scan_matching/parameters.h"
#include "frontier_pilot/scan_matching/surface_map.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::scan_matching {

/// A pose and its uncertainty: the covariance of errors added to its (x, y, yaw), with x and y along the axes of the
/// frame that the pose is in.
struct PoseWithCovariance {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< [m^2, m rad, rad^2]
};

/// The errors (x, y, yaw) of `a` if `b` is the truth, as a PoseWithCovariance counts them.
Eigen::Vector3d difference(const Pose2& a, const Pose2& b);

struct Refinement {
  Pose2 pose;
  Eigen::Matrix3d information =
      Eigen::Matrix3d::Zero();  ///< of the points alone, without the prior, for errors as in PoseWithCovariance
  double inliers = 0.0;         ///< share of the points that lie on a surface, 0 ... 1
};

/// Moves `start` to where `points` lie on the surfels of `map`: Gauss-Newton on the distances along the surfels'
/// normals (Chen & Medioni, "Object Modelling by Registration of Multiple Range Images", 1992), with the weights of
/// Geman & McClure. A point does not constrain the pose along its wall, so in a corridor the information along the
/// walls is nearly zero, and `prior` decides there: its squared error is minimised together with the distances.
Refinement refine(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& start,
                  const std::optional<PoseWithCovariance>& prior, const RefinementParameters& parameters);

/// Share of the points whose beams, traced from the base's origin at `T_map_base`, are inconsistent with the map: they
/// pass through a known surface, or end in front of one where no surface is known. A scan of a new place matches few
/// known surfaces and yet is consistent with them; a scan of another place is not.
double inconsistentShare(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& T_map_base);
/// Whether that share is small enough for a scan of this place, or of a new one beside it.
bool isConsistent(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& T_map_base);
/// Whether `refined` is the true pose of a scan that may have been taken far from where it was expected: nearly all of
/// its points lie on surfaces, or it is consistent with the map. Half of the points lie on surfaces by chance, such as
/// those of another part of the same corridor.
bool explains(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Refinement& refined);

}  // namespace frontier_pilot::scan_matching
