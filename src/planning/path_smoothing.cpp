#include "planning/path_smoothing.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace frontier_pilot::planning {
namespace {

/// After this many blocked lines in a row no points farther on are tried.
constexpr int kMaxBlocked = 12;
constexpr double kMargin = 1e-9;

/// Cheapest polylines from the first sample to each of the others.
class Chain {
 public:
  Chain(const ClearanceMap& map, const std::vector<Vec2>& samples)
      : map_(map),
        samples_(samples),
        cost_(samples.size(), std::numeric_limits<double>::infinity()),
        parent_(samples.size(), 0) {
    cost_[0] = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) extend(i);
  }

  std::vector<Vec2> points() const {
    std::vector<Vec2> reversed{samples_.back()};
    for (std::size_t i = samples_.size() - 1; i != 0; i = parent_[i]) reversed.push_back(samples_[parent_[i]]);
    return {reversed.rbegin(), reversed.rend()};
  }

 private:
  /// Tries the straight lines from sample `i` to those after it.
  void extend(std::size_t i) {
    int blocked = 0;
    for (std::size_t k = i + 1; k < samples_.size() && blocked < kMaxBlocked; ++k) {
      // No line is cheaper than its length; the margin keeps rounding from choosing between equals.
      if (cost_[i] + (samples_[k] - samples_[i]).norm() >= cost_[k] - kMargin) continue;
      const double line = k == i + 1 ? neighbourCost(i) : map_.segmentCost(samples_[i], samples_[k]);
      blocked = line < 0.0 ? blocked + 1 : 0;
      if (line < 0.0 || cost_[i] + line >= cost_[k] - kMargin) continue;
      cost_[k] = cost_[i] + line;
      parent_[k] = i;
    }
  }

  /// The path's own piece is valid by contract; a rounding error must not make it invalid and break the chain.
  double neighbourCost(std::size_t i) const {
    const double cost = map_.segmentCost(samples_[i], samples_[i + 1]);
    return cost >= 0.0 ? cost : (samples_[i + 1] - samples_[i]).norm() * map_.weight(1);
  }

  const ClearanceMap& map_;
  const std::vector<Vec2>& samples_;
  std::vector<double> cost_;
  std::vector<std::size_t> parent_;
};

/// Drops points of a dense path that a valid line of at most `spacing` [m] can replace.
std::vector<Vec2> thinned(const ClearanceMap& map, const Path& path, double spacing) {
  const std::vector<Vec2>& points = path.points();
  std::vector<Vec2> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const bool near = (points[i + 1] - kept.back()).norm() <= spacing;
    if (!near || !map.isValid(kept.back(), points[i + 1])) kept.push_back(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

/// The path's points, and more of them `spacing` apart within `reach` [m] of its corners, where it can be shortened.
std::vector<Vec2> sampledAtCorners(const Path& path, double spacing, double reach) {
  std::vector<Vec2> samples{path.points().front()};
  for (std::size_t i = 0; i + 1 < path.points().size(); ++i) {
    const double first = path.arcLength(i);
    const double last = path.arcLength(i + 1);
    for (double s = first + spacing; s < last - 0.5 * spacing; s += spacing) {
      if (s - first <= reach || last - s <= reach) samples.push_back(path.at(s));
    }
    samples.push_back(path.points()[i + 1]);
  }
  return samples;
}

}  // namespace

Path pullString(const ClearanceMap& map, const std::vector<Vec2>& samples) {
  if (samples.size() < 3) return Path(samples);
  return Path(Chain(map, samples).points());
}

Path smoothPath(const ClearanceMap& map, const Path& path) {
  if (path.points().size() < 3) return path;
  const double cell = map.geometry().resolution;
  Path pulled = pullString(map, thinned(map, path, 5.0 * cell));
  pulled = pullString(map, sampledAtCorners(pulled, 3.0 * cell, 20.0 * cell));
  return pullString(map, sampledAtCorners(pulled, 2.0 * cell, 10.0 * cell));
}

}  // namespace frontier_pilot::planning
