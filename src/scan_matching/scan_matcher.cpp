#include "frontier_pilot/scan_matching/scan_matcher.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/grid_traversal.h"
#include "scan_matching/surfel_map.h"

namespace frontier_pilot::scan_matching {
namespace {

constexpr double kStill = 1e-4;  ///< a step shorter than this ends the iterations [m, rad]

/// The distances linearised at one pose: the normal equations.
class Linearization {
 public:
  Linearization(const SurfelMap& surfels, const surfaces::SurfacePoints& points, const Pose2& pose,
                const RefinementParameters& parameters)
      : parameters_(parameters) {
    const Rotation2 rotation(pose.yaw);
    for (const surfaces::SurfacePoint& point : points) {
      const Vec2 arm = rotation * point.position;
      const surfaces::SurfacePoint placed{pose.position() + arm, rotation * point.normal, false, point.noise,
                                          point.roughness};
      if (const Surfel* surfel = surfels.nearest(placed)) add(*surfel, placed, arm);
    }
    information *= parameters.independence;
    gradient *= parameters.independence;
  }

  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  int inliers = 0;

 private:
  void add(const Surfel& surfel, const surfaces::SurfacePoint& point, const Vec2& arm) {
    const Vec2 error = point.position - surfel.position();
    const Vec2 normal = surfel.normal();
    const double share = 1.0 / (point.variance() + 1.0 / surfel.weight);
    if (normal.isZero()) {
      // A point without a normal constrains both directions, but neither accurately.
      add(error.x(), {1.0, 0.0, -arm.y()}, 0.1 * share);
      add(error.y(), {0.0, 1.0, arm.x()}, 0.1 * share);
    } else {
      add(normal.dot(error), {normal.x(), normal.y(), normal.dot(Vec2(-arm.y(), arm.x()))}, share);
    }
    if (std::abs(normal.isZero() ? error.norm() : normal.dot(error)) <= parameters_.outlier) ++inliers;
  }

  void add(double distance, const Eigen::Vector3d& jacobian, double share) {
    const double scale = square(parameters_.outlier);
    const double weight = share * square(scale / (scale + square(distance)));
    information += weight * jacobian * jacobian.transpose();
    gradient += weight * distance * jacobian;
  }

  const RefinementParameters& parameters_;
};

/// The Gauss-Newton step (x, y, yaw); nearly zero in directions that nothing determines.
Eigen::Vector3d stepOf(const Linearization& equations, const Pose2& pose, const Pose2& start,
                       const std::optional<PoseWithCovariance>& prior) {
  // Without a prior a weak one at `start` takes its place, so that directions left open stay where they were.
  const Eigen::Matrix3d known = prior ? Eigen::Matrix3d(prior->covariance.inverse()) : Eigen::Matrix3d::Identity();
  const Eigen::Vector3d off = difference(pose, prior ? prior->pose : start);
  return -(equations.information + known).ldlt().solve(equations.gradient + known * off);
}

/// Whether a beam from `origin` to `point` passes through a known surface, or ends in front of one on none.
bool contradicts(const Grid<std::uint8_t>& field, const Vec2& origin, const Vec2& point) {
  constexpr std::uint8_t kSurface = 200;
  constexpr std::uint8_t kNothing = 60;
  constexpr double kNear = 0.5;    // [m]: a surface nearer to the point than this may be the one it lies on
  constexpr double kBehind = 3.0;  // [m]: how far behind the point a surface counts
  const GridGeometry& geometry = field.geometry();
  const bool on_surface = field.get(geometry.cellAt(point), 0) >= kNothing;
  const Vec2 end = on_surface ? point : Vec2(point + kBehind * (point - origin).normalized());
  return !visitCells(geometry, origin, end, [&](Cell cell) {
    return field.get(cell, 0) < kSurface || (geometry.centre(cell) - point).norm() < kNear;
  });
}

}  // namespace

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, angleDifference(a.yaw, b.yaw)};
}

Refinement refine(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& start,
                  const std::optional<PoseWithCovariance>& prior, const RefinementParameters& parameters) {
  Pose2 pose = start;
  for (int i = 0; i < parameters.iterations; ++i) {
    const Eigen::Vector3d step = stepOf(Linearization(map.surfels(), points, pose, parameters), pose, start, prior);
    pose = Pose2(pose.x + step.x(), pose.y + step.y(), normalizeAngle(pose.yaw + step.z()));
    if (step.cwiseAbs().maxCoeff() < kStill) break;
  }
  const Linearization last(map.surfels(), points, pose, parameters);
  return {pose, last.information, last.inliers / static_cast<double>(points.size())};
}

double inconsistentShare(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& T_map_base) {
  const auto count = std::count_if(points.begin(), points.end(), [&](const surfaces::SurfacePoint& point) {
    return contradicts(map.field(), T_map_base.position(), T_map_base * point.position);
  });
  return static_cast<double>(count) / static_cast<double>(points.size());
}

bool isConsistent(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Pose2& T_map_base) {
  constexpr double kMostContradictions = 0.1;
  return inconsistentShare(map, points, T_map_base) <= kMostContradictions;
}

bool explains(const SurfaceMap& map, const surfaces::SurfacePoints& points, const Refinement& refined) {
  constexpr double kSure = 0.8;  // then what has been moved since the map was made does not matter
  return refined.inliers >= kSure || isConsistent(map, points, refined.pose);
}

}  // namespace frontier_pilot::scan_matching
