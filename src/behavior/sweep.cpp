#include "behavior/sweep.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frontier_pilot::behavior {
namespace {

/// Checks the cells under the footprint, pose by pose.
class Sweeper {
 public:
  Sweeper(const OccupancyGrid& grid, const Outline& footprint, const Pose2& start, const AxisMotion& motion)
      : grid_(grid), footprint_(footprint), start_(start), motion_(motion) {
    if (motion.axis == AxisMotion::Axis::kLine) markLeftBehind();
  }

  SweepResult at(double share) {
    footprint_.cellsAt(start_ * motion_.at(share), grid_.geometry(), cells_);
    SweepResult met = SweepResult::kClear;
    for (const Cell c : cells_) {
      const SweepResult result = verdict(c);
      if (result == SweepResult::kObstacle) return result;
      if (met == SweepResult::kClear) met = result;
    }
    return met;
  }

 private:
  SweepResult verdict(Cell c) const {
    if (!grid_.contains(c)) return SweepResult::kOffGrid;
    if (isFree(grid_[c]) || std::find(left_behind_.begin(), left_behind_.end(), c) != left_behind_.end()) {
      return SweepResult::kClear;
    }
    return isUnknown(grid_[c]) ? SweepResult::kUnseen : SweepResult::kObstacle;
  }

  void markLeftBehind() {
    const Vec2 ahead = direction(start_.yaw) * (motion_.amount < 0.0 ? -1.0 : 1.0);
    footprint_.cellsAt(start_, grid_.geometry(), cells_);
    for (const Cell c : cells_) {
      const bool trailing = (grid_.geometry().centre(c) - start_.position()).dot(ahead) < 0.0;
      if (trailing && grid_.contains(c) && isOccupied(grid_[c])) left_behind_.push_back(c);
    }
  }

  const OccupancyGrid& grid_;
  const Outline& footprint_;
  Pose2 start_;
  AxisMotion motion_;
  std::vector<Cell> cells_;
  std::vector<Cell> left_behind_;
};

int stepsFor(const AxisMotion& motion, const Outline& footprint, double resolution) {
  const double arm = motion.axis == AxisMotion::Axis::kTurn ? footprint.circumscribedRadius() : 1.0;
  return std::max(1, static_cast<int>(std::ceil(std::abs(motion.amount) * arm / (0.5 * resolution))));
}

}  // namespace

const char* toString(SweepResult result) {
  constexpr const char* kNames[] = {"free", "an obstacle", "unknown ground", "the costmap's edge", "no fresh scan"};
  return kNames[static_cast<int>(result)];
}

SweepResult sweep(const OccupancyGrid& grid, const Outline& footprint, const Pose2& pose, AxisMotion motion) {
  if (grid.empty()) return SweepResult::kNoCostmap;
  // After a full turn, or beyond the grid, nothing new is met.
  const double farthest = motion.axis == AxisMotion::Axis::kTurn
                              ? 2.0 * kPi
                              : grid.resolution() * std::hypot(grid.geometry().width, grid.geometry().height);
  motion.amount = std::clamp(motion.amount, -farthest, farthest);
  Sweeper sweeper(grid, footprint, pose, motion);
  const int steps = stepsFor(motion, footprint, grid.resolution());
  SweepResult met = SweepResult::kClear;
  for (int i = 0; i <= steps; ++i) {
    const SweepResult result = sweeper.at(static_cast<double>(i) / steps);
    if (result == SweepResult::kObstacle) return result;
    if (met == SweepResult::kClear) met = result;
  }
  return met;
}

}  // namespace frontier_pilot::behavior
