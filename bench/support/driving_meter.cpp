#include "support/driving_meter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace frontier_pilot::bench {
namespace {

constexpr std::array<const char*, kDrivingPhases> kNames = {"full speed",     "accelerating",    "curve",
                                                            "near obstacles", "end of the path", "turning on the spot",
                                                            "standing",       "recovery",        "no goal"};
constexpr double kSpacing = 0.05;   ///< way between two samples of the clearance [m]
constexpr double kFarAway = 1.0;    ///< clearances count as at most this [m]
constexpr double kAlmost = 0.99;    ///< share of a limit at which a command is due to it
constexpr double kEndReach = 0.06;  ///< beyond the braking distance, where a path counts as ending [m]

/// Distance between an outline and a square with sides of 2 * `half`, given that they do not overlap [m].
double distanceToSquare(const Outline& outline, const Pose2& T_world_base, const Vec2& middle, double half) {
  const auto nearestIn = [&](const Vec2& point) {
    return Vec2(middle + (point - middle).cwiseMax(Vec2::Constant(-half)).cwiseMin(Vec2::Constant(half)));
  };
  const Pose2 T_base_world = T_world_base.inverse();
  double least = outline.distance(T_base_world * nearestIn(T_world_base.position()));
  if (outline.isDisc()) return least;
  for (const double dx : {-half, half}) {
    for (const double dy : {-half, half}) {
      least = std::min(least, outline.distance(T_base_world * Vec2(middle + Vec2(dx, dy))));
    }
  }
  for (const Vec2& corner : outline.corners()) {
    const Vec2 point = T_world_base * corner;
    least = std::min(least, (nearestIn(point) - point).norm());
  }
  return least;
}

/// The value below which `share` of the sorted `values` lie.
double quantile(const std::vector<double>& values, double share) {
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

void DrivingReport::add(DrivingPhase phase, double share, double seconds) {
  seconds_[static_cast<std::size_t>(phase)] += seconds;
  lost_[static_cast<std::size_t>(phase)] += (1.0 - share) * seconds;
}

void DrivingReport::add(const DrivingReport& other) {
  for (std::size_t i = 0; i < kDrivingPhases; ++i) {
    seconds_[i] += other.seconds_[i];
    lost_[i] += other.lost_[i];
  }
  progress_ += other.progress_;
  clearances_.insert(clearances_.end(), other.clearances_.begin(), other.clearances_.end());
}

std::string DrivingReport::text() const {
  const double total = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
  const double lost = std::accumulate(lost_.begin(), lost_.end(), 0.0);
  if (total <= 0.0) return {};
  char line[200];
  std::snprintf(line, sizeof(line),
                "    %.1f s; mean speed %.4f of the full one, along the paths %.4f m/s; share of the time, and lost:\n",
                total, 1.0 - lost / total, progress_ / total);
  std::string out = line;
  for (std::size_t i = 0; i < kDrivingPhases; ++i) {
    std::snprintf(line, sizeof(line), "      %-20s %5.1f %%  %5.2f %%\n", kNames[i], 100.0 * seconds_[i] / total,
                  100.0 * lost_[i] / total);
    out += line;
  }
  if (clearances_.empty()) return out;
  std::vector<double> sorted = clearances_;
  std::sort(sorted.begin(), sorted.end());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
  std::snprintf(line, sizeof(line), "    clearance [m]: least %.4f, 1 %% %.4f, 5 %% %.4f, 25 %% %.4f, mean %.4f\n",
                sorted.front(), quantile(sorted, 0.01), quantile(sorted, 0.05), quantile(sorted, 0.25), mean);
  return out + line;
}

DrivingMeter::DrivingMeter(const RobotModel& robot, const OccupancyGrid& truth)
    : limits_(robot.limits), outline_(robot.drivenOutline()), truth_(truth) {}

void DrivingMeter::observe(const Pose2& T_world_base, const Twist2& velocity, const navigation::Navigator& navigator,
                           const navigation::NavigatorOutput& output, double seconds) {
  report_.add(phase(velocity, navigator, output), std::abs(velocity.linear) / limits_.max_linear, seconds);
  const planning::Path& path = navigator.path();
  if (!path.empty() && output.command) {
    const bool same = path.goal() == goal_ && path.length() == length_;
    report_.addProgress(navigator.progress() - (same ? progress_ : 0.0));
    goal_ = path.goal();
    length_ = path.length();
    progress_ = navigator.progress();
  }
  if (last_) driven_ += (T_world_base.position() - *last_).norm();
  last_ = T_world_base.position();
  if (driven_ < kSpacing) return;
  driven_ -= kSpacing;
  report_.addClearance(clearance(T_world_base));
}

DrivingPhase DrivingMeter::phase(const Twist2& velocity, const navigation::Navigator& navigator,
                                 const navigation::NavigatorOutput& output) const {
  using navigation::NavState;
  if (!output.command || output.state == NavState::kIdle) return DrivingPhase::kNoGoal;
  if (output.state == NavState::kRecovering) return DrivingPhase::kRecovery;
  const Twist2& command = *output.command;
  if (command.isZero()) return DrivingPhase::kStanding;
  if (command.linear == 0.0) return DrivingPhase::kTurning;
  if (command.linear >= kAlmost * limits_.max_linear) {
    const bool fast = velocity.linear >= kAlmost * limits_.max_linear;
    return fast ? DrivingPhase::kFullSpeed : DrivingPhase::kAccelerating;
  }
  if (std::abs(command.angular) >= kAlmost * limits_.max_angular) return DrivingPhase::kCurve;
  const double left = navigator.path().length() - navigator.progress();
  const bool ends = left < square(limits_.max_linear) / limits_.max_linear_acc + kEndReach;
  return ends ? DrivingPhase::kPathEnd : DrivingPhase::kNearObstacle;
}

double DrivingMeter::clearance(const Pose2& T_world_base) const {
  const GridGeometry& grid = truth_.geometry();
  const Cell centre = grid.cellAt(T_world_base.position());
  const int reach = static_cast<int>(std::ceil((outline_.circumscribedRadius() + kFarAway) / grid.resolution)) + 1;
  const CellRect cells = CellRect{centre.x, centre.y, 1, 1}.grown(reach).intersection(grid.rect());
  double least = kFarAway;
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) {
      const Cell cell{x, y};
      if (isFree(truth_[cell])) continue;
      const Vec2 middle = grid.centre(cell);
      const double between = (middle - T_world_base.position()).norm();
      if (between > least + outline_.circumscribedRadius() + grid.resolution) continue;
      least = std::min(least, distanceToSquare(outline_, T_world_base, middle, 0.5 * grid.resolution));
    }
  }
  return least;
}

}  // namespace frontier_pilot::bench
