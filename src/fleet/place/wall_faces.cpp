#include "fleet/place/wall_faces.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "frontier_pilot/scan_matching/surface_map.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kCell = 0.05;     // side of a cell of the likelihoods [m]
constexpr double kCapture = 0.08;  // their standard deviation [m]
constexpr int kSteps = 15;         // of the refinement

const std::array<Vec2, 4> kAxes = {Vec2(1.0, 0.0), Vec2(-1.0, 0.0), Vec2(0.0, 1.0), Vec2(0.0, -1.0)};

/// A likelihood between its cells' centres, 0 ... 1, and its gradient [1/m]: bilinear.
struct Sample {
  double value = 0.0;
  Vec2 gradient = Vec2::Zero();
};

Sample sample(const Grid<std::uint8_t>& field, const Vec2& point) {
  const GridGeometry& geometry = field.geometry();
  const Vec2 at = (point - geometry.origin) / geometry.resolution - Vec2(0.5, 0.5);
  const Cell low{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  const Vec2 part = at - Vec2(low.x, low.y);
  const auto value = [&](int dx, int dy) {
    return static_cast<double>(field.get({low.x + dx, low.y + dy}, 0)) / 255.0;
  };
  const std::array<double, 4> corner{value(0, 0), value(1, 0), value(0, 1), value(1, 1)};
  const double below = corner[0] + part.x() * (corner[1] - corner[0]);
  const double above = corner[2] + part.x() * (corner[3] - corner[2]);
  const double slope = (1.0 - part.y()) * (corner[1] - corner[0]) + part.y() * (corner[3] - corner[2]);
  return {below + part.y() * (above - below), Vec2(slope, above - below) / geometry.resolution};
}

void add(const Grid<std::uint8_t>& field, const Vec2& there, const Vec2& arm, double facing, Eigen::Matrix3d& hessian,
         Eigen::Vector3d& slope) {
  const Sample here = sample(field, there);
  if (here.value <= 0.0) return;
  const Eigen::Vector3d jacobian(here.gradient.x(), here.gradient.y(),
                                 arm.x() * here.gradient.y() - arm.y() * here.gradient.x());
  const double weight = facing * here.value;
  hessian += weight * jacobian * jacobian.transpose();
  slope += weight * (1.0 - here.value) * jacobian;
}

}  // namespace

WallFaces::WallFaces(const surfaces::SurfacePoints& surface) {
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    surfaces::SurfacePoints facing;
    for (const surfaces::SurfacePoint& point : surface) {
      if (point.normal.dot(kAxes[i]) > 0.5) facing.push_back(point);
    }
    likelihoods_[i] = scan_matching::likelihoodField(facing, {kCell, kCapture});
  }
}

Pose2 WallFaces::climb(const surfaces::SurfacePoints& points, Pose2 T_a_b) const {
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix3d hessian = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    const Rotation2 rotation(T_a_b.yaw);
    for (const surfaces::SurfacePoint& point : points) {
      const Vec2 there = rotation.applied(point.position, T_a_b.position());
      const Vec2 normal = rotation.applied(point.normal, Vec2::Zero());
      for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const double facing = normal.dot(kAxes[i]);
        if (facing > 0.2) add(likelihoods_[i], there, there - T_a_b.position(), square(facing), hessian, slope);
      }
    }
    const Eigen::Vector3d change = hessian.ldlt().solve(slope);
    if (!change.allFinite() || change.norm() > 1.0) break;
    T_a_b = Pose2(T_a_b.x + change.x(), T_a_b.y + change.y(), T_a_b.yaw + change.z());
    if (change.head<2>().norm() < 1e-4 && std::abs(change.z()) < 1e-5) break;
  }
  return T_a_b;
}

}  // namespace frontier_pilot::fleet
