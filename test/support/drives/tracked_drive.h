#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "slam/front_end/local_slam.h"
#include "support/drives/drive.h"

namespace frontier_pilot::test {

/// Four rooms of 5 m x 4 m around a cross of doors, with a pillar or a desk in each; cells of 5 cm.
inline Grid<std::uint8_t> rooms() {
  GridGeometry geometry;
  geometry.width = 224;
  geometry.height = 184;
  Grid<std::uint8_t> solid(geometry, 1);
  for (const Cell corner : {Cell{10, 10}, Cell{113, 10}, Cell{10, 93}, Cell{113, 93}}) {
    fill(solid, {corner.x, corner.y, 100, 80}, 0);
  }
  fill(solid, {110, 40, 3, 20}, 0);
  fill(solid, {110, 120, 3, 20}, 0);
  fill(solid, {50, 90, 20, 3}, 0);
  fill(solid, {160, 90, 20, 3}, 0);
  fill(solid, {20, 75, 16, 8}, 1);
  fill(solid, {200, 20, 6, 6}, 1);
  fill(solid, {130, 150, 30, 10}, 1);
  fill(solid, {25, 140, 5, 5}, 1);
  return solid;
}

/// A corridor of 30 m x 2 m with closed ends; cells of 5 cm.
inline Grid<std::uint8_t> longCorridor() {
  GridGeometry geometry;
  geometry.width = 620;
  geometry.height = 60;
  Grid<std::uint8_t> solid(geometry, 1);
  fill(solid, {10, 10, 600, 40}, 0);
  return solid;
}

/// Poses, at a rate [Hz], of a robot that drives from point to point at a speed [m/s] and turns in place.
inline std::vector<Pose2> driveAlong(const std::vector<Vec2>& points, double speed = 0.3, double rate = 10.0) {
  const double turn = 0.8 / rate;
  std::vector<Pose2> poses = {Pose2(points[0], bearing(points[1] - points[0]))};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double wanted = bearing(points[i] - points[i - 1]);
    while (std::abs(angleDifference(wanted, poses.back().yaw)) > 1e-9) {
      const double step = std::clamp(angleDifference(wanted, poses.back().yaw), -turn, turn);
      poses.emplace_back(poses.back().position(), poses.back().yaw + step);
    }
    const double length = (points[i] - points[i - 1]).norm();
    const int steps = static_cast<int>(std::ceil(length * rate / speed));
    for (int k = 1; k <= steps; ++k) {
      poses.emplace_back(points[i - 1] + (points[i] - points[i - 1]) * k / steps, poses.back().yaw);
    }
  }
  return poses;
}

/// Once around the rooms and on into the second one.
inline std::vector<Pose2> aroundTheRooms(double speed = 0.5, double rate = 10.0) {
  return driveAlong({{2.0, 2.0}, {3.0, 2.5}, {8.5, 2.5}, {8.5, 6.5}, {3.0, 6.5}, {3.0, 2.5}, {6.0, 2.5}}, speed, rate);
}

/// Odometry with 5 % noise in distance and rotation, and drift.
class Wheels {
 public:
  explicit Wheels(unsigned seed = 1) : random_(seed) {}

  bool frozen = false;  ///< the encoders report no motion

  const Pose2& move(const Pose2& from, const Pose2& to) {
    const Pose2 step = from.inverse() * to;
    const double length = step.position().norm();
    const Pose2 measured(step.position() * (1.02 + 0.05 * noise_(random_)),
                         step.yaw * (1.0 + 0.05 * noise_(random_)) + 0.01 * length);
    if (!frozen) pose_ = pose_ * measured;
    return pose_;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> noise_{0.0, 1.0};
  Pose2 pose_;
};

/// Runs LocalSlam on a drive, and records how well it tracks the robot.
struct TrackedDrive {
  double rate = 10.0;  ///< [Hz]
  slam::LocalSlam slam;
  Wheels wheels;
  std::map<slam::MatchVerdict, int> verdicts;
  Pose2 error;             ///< the last estimated pose in the frame of the true one
  double worst = 0.0;      ///< greatest distance from the truth [m]
  double worst_yaw = 0.0;  ///< [rad]
  std::vector<slam::Keyframe> keyframes;
  std::vector<std::shared_ptr<const slam::Submap>> submaps;

  /// Changes the scan or the wheels at a time [s]. False: there is no scan.
  using Fault = std::function<bool(double, LaserScan2&, Wheels&)>;

  void run(const std::vector<Pose2>& poses, Scanner& scanner, const Fault& fault = nullptr) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double now = static_cast<double>(i) / rate;
      LaserScan2 scan = scanner.scan(poses[i], timeFromSeconds(100.0 + now));
      const bool seen = !fault || fault(now, scan, wheels);
      const Pose2 T_odom_base = wheels.move(poses[i == 0 ? 0 : i - 1], poses[i]);
      if (seen) compare(poses[0].inverse() * poses[i], slam.update(surfaces::readScan(scan), T_odom_base));
    }
  }
  int count(slam::MatchVerdict verdict) { return verdicts[verdict]; }

 private:
  void compare(const Pose2& truth, slam::LocalSlamOutput output) {
    ++verdicts[output.track.verdict];
    error = truth.inverse() * output.track.T_local_base.pose;
    worst = std::max(worst, error.position().norm());
    worst_yaw = std::max(worst_yaw, std::abs(error.yaw));
    if (output.keyframe) keyframes.push_back(std::move(*output.keyframe));
    for (auto& submap : output.finished) submaps.push_back(std::move(submap));
  }
};

}  // namespace frontier_pilot::test
