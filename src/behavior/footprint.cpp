#include "frontier_pilot/behavior/footprint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "frontier_pilot/core/ray_casting.h"

namespace frontier_pilot {
namespace {

std::vector<Vec2> cornersOf(const std::vector<double>& numbers) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) corners.emplace_back(numbers[i], numbers[i + 1]);
  return corners;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double signedArea(const std::vector<Vec2>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += 0.5 * cross(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

/// Whether the horizontal ray from `point` to the right crosses the polygon's outline an odd number of times.
bool inside(const std::vector<Vec2>& corners, const Vec2& point) {
  bool in = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % corners.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) in = !in;
  }
  return in;
}

/// Moves every side outward by `padding`; the corners of a counter-clockwise polygon go along their mitre.
std::vector<Vec2> padded(const std::vector<Vec2>& corners, double padding) {
  std::vector<Vec2> out;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = (corners[i] - corners[(i + n - 1) % n]).normalized();
    const Vec2 after = (corners[(i + 1) % n] - corners[i]).normalized();
    const Vec2 normals(before.y() + after.y(), -before.x() - after.x());
    // Sharp corners would reach out far: the mitre is cut at twice the padding.
    const double scale = padding / std::max(0.5, 0.5 * normals.squaredNorm());
    out.emplace_back(corners[i] + scale * normals);
  }
  return out;
}

}  // namespace

void FootprintParameters::check(Problems& problems) const {
  const std::vector<Vec2> corners = cornersOf(polygon);
  if (polygon.size() % 2 != 0 || corners.size() < 3) {
    problems.emplace_back("polygon: must be at least three pairs x, y");
  } else if (std::abs(signedArea(corners)) < 1e-6) {
    problems.emplace_back("polygon: has no area");
  } else if (!inside(corners, Vec2::Zero())) {
    problems.emplace_back("polygon: the base's origin must lie inside");
  }
}

Footprint::Footprint(const FootprintParameters& parameters) : corners_(cornersOf(parameters.polygon)) {
  Problems problems;
  parameters.check(problems);
  if (!problems.empty()) throw std::invalid_argument("footprint: " + problems.front());
  if (signedArea(corners_) < 0.0) std::reverse(corners_.begin(), corners_.end());
  corners_ = padded(corners_, parameters.padding);
  for (const Vec2& corner : corners_) radius_ = std::max(radius_, corner.norm());
}

void Footprint::cellsAt(const Pose2& pose, const GridGeometry& geometry, std::vector<Cell>& cells) const {
  cells.clear();
  std::vector<Vec2> placed;
  placed.reserve(corners_.size());
  CellRect box;
  for (const Vec2& corner : corners_) {
    placed.push_back(pose * corner);
    box.include(geometry.cellAt(placed.back()));
  }
  // A cell that no side passes through lies inside or outside as a whole: its centre tells which.
  for (std::size_t i = 0; i < placed.size(); ++i) {
    visitCells(geometry, placed[i], placed[(i + 1) % placed.size()], [&cells](Cell c) {
      cells.push_back(c);
      return true;
    });
  }
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      if (inside(placed, geometry.centre({x, y}))) cells.push_back({x, y});
    }
  }
}

}  // namespace frontier_pilot
