#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "slam/graph/submap_graph.h"
#include "support/drives/drive.h"

namespace frontier_pilot::test {

/// A corridor of 3 m around a square block, in a square of `side` [m]. With `cluttered`, boxes of various sizes stand
/// along the walls; otherwise all four sides look the same.
inline Grid<std::uint8_t> ringWorld(double side, bool cluttered) {
  GridGeometry geometry;
  geometry.width = geometry.height = static_cast<int>(side / geometry.resolution);
  Grid<std::uint8_t> solid(geometry, 0);
  const double corridor = 3.0;
  const auto fill = [&](const Vec2& low, const Vec2& high) {
    for (std::size_t i = 0; i < solid.size(); ++i) {
      const Vec2 p = geometry.centre(geometry.cell(i));
      if (p.x() > low.x() && p.y() > low.y() && p.x() < high.x() && p.y() < high.y()) solid[i] = 1;
    }
  };
  fill({0.0, 0.0}, {side, 0.5});
  fill({0.0, side - 0.5}, {side, side});
  fill({0.0, 0.0}, {0.5, side});
  fill({side - 0.5, 0.0}, {side, side});
  fill(Vec2::Constant(0.5 + corridor), Vec2::Constant(side - 0.5 - corridor));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0.5, side - 1.0), size(0.2, 0.7);
  for (int i = 0; cluttered && i < 40; ++i) {
    const double at = anywhere(random);
    const Vec2 low = i % 4 == 0   ? Vec2(at, 0.4)
                     : i % 4 == 1 ? Vec2(at, side - 0.5 - 0.6)
                     : i % 4 == 2 ? Vec2(0.4, at)
                                  : Vec2(side - 0.5 - 0.6, at);
    fill(low, low + Vec2(size(random), size(random)));
  }
  return solid;
}

/// Poses every `step` [m] around the block, `laps` times, with round corners.
inline std::vector<Pose2> ringPoses(double side, double step, double laps) {
  const double middle = 2.0;  // [m] from the outer edge
  const double straight = side - 2.0 * middle - 2.0;
  const double arc = kPi / 2.0;
  std::vector<Pose2> poses = {Pose2(middle + 1.0, middle, 0.0)};
  const auto steps = static_cast<int>(laps * 4.0 * (straight + arc) / step);
  double on_leg = 0.0;
  for (int i = 0; i < steps; ++i) {
    on_leg = std::fmod(on_leg + step, straight + arc);
    poses.push_back(integrate(poses.back(), {1.0, on_leg > straight ? 1.0 : 0.0}, step));
  }
  return poses;
}

/// Steps that no match confirms: each `every`-th one, 0 for none, with an error of its own.
struct WeakSteps {
  std::size_t every = 0;
  Pose2 error;
};

/// The output of a LocalSlam on a drive: keyframes in submaps that overlap by half, in a frame that drifts.
class DriftingDrive {
 public:
  /// `error` is added to the estimate of each step that is not weak.
  DriftingDrive(std::vector<Pose2> truth, const Grid<std::uint8_t>& world, const Pose2& error,
                const WeakSteps& weak = {})
      : truth_(std::move(truth)), scanner_(world, 0.01), weak_(weak) {
    T_local_base_ = {Pose2()};
    for (std::size_t i = 1; i < truth_.size(); ++i) {
      const Pose2& added = isWeak(i) ? weak.error : error;
      T_local_base_.push_back(T_local_base_.back() * truth_[i - 1].inverse() * truth_[i] * added);
    }
  }

  std::size_t size() const { return truth_.size(); }
  /// The true pose of keyframe `i`, in the frame of the first one.
  Pose2 truth(std::size_t i) const { return truth_.front().inverse() * truth_[i]; }
  const Pose2& local(std::size_t i) const { return T_local_base_[i]; }

  slam::PlacedKeyframe keyframe(std::size_t i) {
    slam::PlacedKeyframe placed;
    placed.keyframe.id = i;
    const LaserScan2 scan = scanner_.scan(truth_[i], timeFromSeconds(static_cast<double>(i + 1)));
    placed.keyframe.scan = surfaces::readScan(scan);
    placed.keyframe.points = surfaces::thinned(placed.keyframe.scan.points);
    placed.keyframe.T_local_base = T_local_base_[i];
    placed.T_map_base = T_local_base_[i];
    if (i > 0) placed.step.motion = T_local_base_[i - 1].inverse() * T_local_base_[i];
    const Eigen::Vector3d sigma = isWeak(i) ? Eigen::Vector3d(0.03, 0.03, 0.03) : Eigen::Vector3d(0.01, 0.01, 0.004);
    placed.step.drift = sigma.cwiseProduct(sigma).asDiagonal();
    placed.step.weak = isWeak(i);
    constexpr std::size_t kHalf = 10;
    const std::size_t younger = i / kHalf;
    if (younger > 0) placed.places.push_back({younger - 1, T_local_base_[(younger - 1) * kHalf]});
    placed.places.push_back({younger, T_local_base_[younger * kHalf]});
    return placed;
  }

 private:
  bool isWeak(std::size_t i) const { return weak_.every > 0 && i > 0 && i % weak_.every == 0; }

  std::vector<Pose2> truth_;
  std::vector<Pose2> T_local_base_;
  Scanner scanner_;
  WeakSteps weak_;
};

}  // namespace frontier_pilot::test
