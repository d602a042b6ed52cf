#include "frontier_pilot/core/robot_model.h"

#include <stdexcept>

namespace frontier_pilot {
namespace {

std::vector<Vec2> cornersOf(const std::vector<double>& numbers) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) corners.emplace_back(numbers[i], numbers[i + 1]);
  return corners;
}

}  // namespace

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

void RobotModel::check(Problems& problems) const {
  if (outline.empty()) {
    if (disc_radius <= 0.0) problems.emplace_back("outline: must be given where disc_radius is 0");
    return;
  }
  if (outline.size() % 2 != 0) return problems.push_back("outline: must be pairs x, y");
  const std::string wrong = Outline::problem(cornersOf(outline));
  if (!wrong.empty()) problems.push_back("outline: " + wrong);
}

}  // namespace frontier_pilot
