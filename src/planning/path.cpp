#include "frontier_pilot/planning/path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::planning {

Path::Path(const std::vector<Vec2>& points) {
  points_.reserve(points.size());
  along_.reserve(points.size());
  for (const Vec2& point : points) {
    const double step = points_.empty() ? 0.0 : (point - points_.back()).norm();
    if (!points_.empty() && step < 1e-9) continue;
    along_.push_back(points_.empty() ? 0.0 : along_.back() + step);
    points_.push_back(point);
  }
}

std::size_t Path::segmentAt(double s) const {
  const auto after = std::upper_bound(along_.begin(), along_.end(), s);
  const auto index = static_cast<std::size_t>(after - along_.begin());
  return std::clamp<std::size_t>(index, 1, points_.size() - 1) - 1;
}

Vec2 Path::at(double s) const {
  if (points_.size() == 1 || s <= 0.0) return points_.front();
  if (s >= length()) return points_.back();
  const std::size_t i = segmentAt(s);
  const double part = (s - along_[i]) / (along_[i + 1] - along_[i]);
  return points_[i] + part * (points_[i + 1] - points_[i]);
}

double Path::project(const Vec2& point, double from, double to) const {
  if (points_.size() < 2) return 0.0;
  from = std::clamp(from, 0.0, length());
  to = std::clamp(to, from, length());
  double best = from;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = segmentAt(from); i + 1 < points_.size() && along_[i] <= to; ++i) {
    const double span = along_[i + 1] - along_[i];
    const Vec2 unit = (points_[i + 1] - points_[i]) / span;
    const double low = std::max(from - along_[i], 0.0);
    const double high = std::max(low, std::min(to - along_[i], span));
    const double part = std::clamp(unit.dot(point - points_[i]), low, high);
    const double distance = (points_[i] + part * unit - point).squaredNorm();
    if (distance < best_distance) {
      best_distance = distance;
      best = along_[i] + part;
    }
  }
  return best;
}

Path Path::from(double s) const {
  if (points_.size() < 2 || s <= 0.0) return *this;
  std::vector<Vec2> rest{at(s)};
  for (std::size_t i = segmentAt(s) + 1; i < points_.size(); ++i) rest.push_back(points_[i]);
  return Path(rest);
}

std::vector<Vec2> Path::sampled(double spacing) const {
  std::vector<Vec2> samples;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((along_[i + 1] - along_[i]) / spacing)));
    for (int k = 0; k < pieces; ++k) {
      samples.emplace_back(points_[i] + (static_cast<double>(k) / pieces) * (points_[i + 1] - points_[i]));
    }
  }
  if (!points_.empty()) samples.push_back(points_.back());
  return samples;
}

}  // namespace frontier_pilot::planning
