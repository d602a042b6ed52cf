#include "frontier_pilot/core/robot_model.h"

#include <algorithm>
#include <stdexcept>

namespace frontier_pilot {
namespace {

double approach(double target, double from, double step) { return std::clamp(target, from - step, from + step); }

}  // namespace

Twist2 clamp(const Twist2& twist, const RobotLimits& limits) {
  return {std::clamp(twist.linear, -limits.max_linear, limits.max_linear),
          std::clamp(twist.angular, -limits.max_angular, limits.max_angular)};
}

Twist2 limitAcceleration(const Twist2& target, const Twist2& from, const RobotLimits& limits, double seconds) {
  return {approach(target.linear, from.linear, limits.max_linear_acc * seconds),
          approach(target.angular, from.angular, limits.max_angular_acc * seconds)};
}

void ScannerModel::check(Problems& problems) const {
  if (range_min >= range_max) problems.emplace_back("range_min: must be below range_max");
}

Outline RobotModel::exactOutline() const {
  return outline.empty() ? Outline::disc(disc_radius) : Outline::polygon(cornersOf(outline));
}

RobotModel loadRobot(const std::string& path) {
  RobotModel robot;
  const Problems problems = loadParameters(loadYamlFile(path), robot);
  std::string all;
  for (const std::string& problem : problems) all += (all.empty() ? "" : "; ") + problem;
  if (!all.empty()) throw std::invalid_argument(path + ": " + all);
  return robot;
}

void RobotModel::checkIsNotBase(Problems& problems, const std::string& name, const std::string& frame,
                                const std::string& own_base) const {
  if (frame == baseFrameOr(own_base)) problems.push_back(name + ": is the robot's frame as well, '" + frame + "'");
}

void RobotModel::check(Problems& problems) const {
  if (odometry != "topic" && odometry != "tf")
    problems.push_back("odometry: must be topic or tf, not '" + odometry + "'");
  if (base_frame == odom_frame) problems.push_back("base_frame: is odom_frame as well, '" + odom_frame + "'");
  if (outline.empty()) {
    if (disc_radius <= 0.0) problems.emplace_back("outline: must be given where disc_radius is 0");
    return;
  }
  if (outline.size() % 2 != 0) return problems.push_back("outline: must be pairs x, y");
  const std::string wrong = Outline::problem(cornersOf(outline));
  if (!wrong.empty()) return problems.push_back("outline: " + wrong);
  constexpr double kRound = 0.75;  // of the farthest corner, which a Burger has cut
  if (disc_radius > 0.0 && disc_radius < exactOutline().halfWidth()) {
    problems.emplace_back("disc_radius: must be 0 or at least half the width of the outline");
  } else if (disc_radius > 0.0 && disc_radius < kRound * exactOutline().circumscribedRadius()) {
    problems.emplace_back("disc_radius: must be 0 for an outline whose corners are so far out, or larger");
  }
}

}  // namespace frontier_pilot
