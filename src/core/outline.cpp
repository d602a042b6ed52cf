#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/grid_traversal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace frontier_pilot {
namespace {

constexpr int kDiscCorners = 32;
constexpr double kLeastArea = 1e-6;  // [m^2]
constexpr std::size_t kMostCorners = 1000;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

const Vec2& next(const std::vector<Vec2>& corners, std::size_t i) { return corners[(i + 1) % corners.size()]; }

double signedArea(const std::vector<Vec2>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += 0.5 * cross(corners[i], next(corners, i));
  return area;
}

/// Whether the segments a-b and c-d cross or touch.
bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& from, const Vec2& to, const Vec2& point) { return cross(to - from, point - from); };
  const double c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
  if (c_side == 0.0 && d_side == 0.0) {  // on one line
    const auto low = a.cwiseMin(b).cwiseMax(c.cwiseMin(d)).eval(), high = a.cwiseMax(b).cwiseMin(c.cwiseMax(d)).eval();
    return low.x() <= high.x() && low.y() <= high.y();
  }
  return c_side * d_side <= 0.0 && a_side * b_side <= 0.0;
}

/// Whether two sides meet that are not neighbours.
bool crossesItself(const std::vector<Vec2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i + 2 < n; ++i) {
    for (std::size_t k = i + 2; k < n; ++k) {
      const bool neighbours = i == 0 && k == n - 1;
      if (!neighbours && meet(corners[i], corners[i + 1], corners[k], next(corners, k))) return true;
    }
  }
  return false;
}

Vec2 nearestOnSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 side = b - a;
  return a + std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0) * side;
}

Vec2 nearestOnSides(const Vec2& point, const std::vector<Vec2>& corners) {
  Vec2 nearest = corners.front();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 on_side = nearestOnSegment(point, corners[i], next(corners, i));
    if ((on_side - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = on_side;
  }
  return nearest;
}

/// The corners of a counter-clockwise polygon whose sides are moved outward by `margin`, joined by mitres.
std::vector<Vec2> mitred(const std::vector<Vec2>& corners, double margin) {
  std::vector<Vec2> out;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = (corners[i] - corners[(i + n - 1) % n]).normalized();
    const Vec2 after = (next(corners, i) - corners[i]).normalized();
    const Vec2 normals(before.y() + after.y(), -before.x() - after.x());
    // The mitre of a sharp corner would reach far out: it is limited to twice the margin.
    const double scale = margin / std::max(0.5, 0.5 * normals.squaredNorm());
    out.emplace_back(corners[i] + scale * normals);
  }
  return out;
}

}  // namespace

std::vector<Vec2> cornersOf(const std::vector<double>& numbers) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) corners.emplace_back(numbers[i], numbers[i + 1]);
  return corners;
}

const char* polygonProblem(const std::vector<Vec2>& corners) {
  if (corners.size() < 3) return "must have at least three corners";
  if (corners.size() > kMostCorners) return "must have at most 1000 corners";
  if (crossesItself(corners)) return "crosses or touches itself";
  if (std::abs(signedArea(corners)) < kLeastArea) return "has no area";
  return "";
}

double polygonArea(const std::vector<Vec2>& corners) { return std::abs(signedArea(corners)); }

/// Whether the horizontal ray from `point` to the right crosses the polygon's sides an odd number of times.
bool polygonContains(const std::vector<Vec2>& corners, const Vec2& point) {
  bool in = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = next(corners, i);
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) in = !in;
  }
  return in;
}

Outline::Outline(std::vector<Vec2> corners, bool is_disc, double radius)
    : corners_(std::move(corners)), is_disc_(is_disc), inscribed_(radius), circumscribed_(radius) {
  if (is_disc_) {
    half_width_ = front_ = rear_ = radius;
    return;
  }
  inscribed_ = nearestOnSides(Vec2::Zero(), corners_).norm();
  for (const Vec2& corner : corners_) {
    circumscribed_ = std::max(circumscribed_, corner.norm());
    half_width_ = std::max(half_width_, std::abs(corner.y()));
    front_ = std::max(front_, corner.x());
    rear_ = std::max(rear_, -corner.x());
  }
}

Outline Outline::disc(double radius) {
  std::vector<Vec2> corners;
  const double reach = radius / std::cos(kPi / kDiscCorners);
  for (int i = 0; i < kDiscCorners; ++i) corners.emplace_back(reach * direction((2 * i + 1) * kPi / kDiscCorners));
  return {std::move(corners), true, radius};
}

const char* Outline::problem(const std::vector<Vec2>& corners) {
  const char* wrong = polygonProblem(corners);
  if (*wrong != '\0') return wrong;
  return polygonContains(corners, Vec2::Zero()) ? "" : "the base's origin must lie inside";
}

Outline Outline::polygon(std::vector<Vec2> corners) {
  const std::string wrong = problem(corners);
  if (!wrong.empty()) throw std::invalid_argument("outline: " + wrong);
  if (signedArea(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  return {std::move(corners), false, 0.0};
}

Outline Outline::padded(double margin) const {
  if (is_disc_) return disc(inscribed_ + margin);
  return {mitred(corners_, margin), false, 0.0};
}

double Outline::distance(const Vec2& point) const {
  if (is_disc_) return point.norm() - inscribed_;
  const double to_sides = (nearestOnSides(point, corners_) - point).norm();
  return polygonContains(corners_, point) ? -to_sides : to_sides;
}

double Outline::distanceToEdge(const Vec2& from, const Vec2& unit) const {
  if (is_disc_) {
    const double along = from.dot(unit);
    const double room = inscribed_ * inscribed_ - from.squaredNorm();
    return room > 0.0 ? std::sqrt(along * along + room) - along : 0.0;
  }
  if (!polygonContains(corners_, from)) return 0.0;
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 to = corners_[i] - from;
    const Vec2 side = next(corners_, i) - corners_[i];
    const double turned = cross(unit, side);
    if (turned == 0.0) continue;
    const double along_side = cross(to, unit) / turned;
    const double along_ray = cross(to, side) / turned;
    if (along_side >= 0.0 && along_side <= 1.0 && along_ray >= 0.0) first = std::min(first, along_ray);
  }
  return std::isfinite(first) ? first : 0.0;
}

Vec2 Outline::nearestTo(const Vec2& point) const {
  return is_disc_ ? Vec2(inscribed_ * point.normalized()) : nearestOnSides(point, corners_);
}

double Outline::reach(const Vec2& unit) const {
  if (is_disc_) return inscribed_;
  double farthest = 0.0;
  for (const Vec2& corner : corners_) farthest = std::max(farthest, unit.dot(corner));
  return farthest;
}

void Outline::cellsAt(const Pose2& T_grid_base, const GridGeometry& geometry, std::vector<Cell>& cells) const {
  cells.clear();
  std::vector<Vec2> placed;
  placed.reserve(corners_.size());
  CellRect box;
  for (const Vec2& corner : corners_) {
    placed.push_back(T_grid_base * corner);
    box.include(geometry.cellAt(placed.back()));
  }
  // A cell that no side passes through lies entirely inside or entirely outside: its centre decides.
  for (std::size_t i = 0; i < placed.size(); ++i) {
    visitCells(geometry, placed[i], next(placed, i), [&cells](Cell c) {
      cells.push_back(c);
      return true;
    });
  }
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      if (polygonContains(placed, geometry.centre({x, y}))) cells.push_back({x, y});
    }
  }
}

}  // namespace frontier_pilot
