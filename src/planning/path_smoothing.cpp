#include "planning/path_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace frontier_pilot::planning {
namespace {

/// After this many blocked lines in a row no points farther on are tried.
constexpr int kMaxBlocked = 12;
constexpr double kSmoothingRounding = 1e-9;

/// Cheapest polylines from the first sample to each of the others, by lines to at most `ahead` samples on.
class Chain {
 public:
  Chain(const ClearanceMap& map, const std::vector<Vec2>& samples, std::size_t ahead)
      : map_(map), samples_(samples), ahead_(ahead), along_(samples.size(), 0.0), parent_(samples.size(), 0) {
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      along_[i + 1] = along_[i] + neighbourCost(i);
      parent_[i + 1] = i;
    }
    cost_ = along_;
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
    improve(i, i + 1, cost_[i] + along_[i + 1] - along_[i]);
    const std::size_t end = i + 1 + std::min(samples_.size() - i - 1, ahead_);
    int blocked = 0;
    for (std::size_t k = i + 2; k < end && blocked < kMaxBlocked; ++k) {
      // A line is worth its price only if it is cheaper than the samples' own way, and no line is cheaper than its
      // length; the margin keeps rounding from choosing between equals.
      const double limit = std::min(cost_[k] - cost_[i], along_[k] - along_[i]) - kSmoothingRounding;
      if ((samples_[k] - samples_[i]).norm() >= limit) continue;
      const double line = map_.segmentCost(samples_[i], samples_[k], limit);
      blocked = line < 0.0 ? blocked + 1 : 0;
      if (line >= 0.0 && line < limit) improve(i, k, cost_[i] + line);
    }
  }

  void improve(std::size_t i, std::size_t k, double cost) {
    if (cost >= cost_[k] - kSmoothingRounding) return;
    cost_[k] = cost;
    parent_[k] = i;
  }

  /// The path's own piece is valid by contract; a rounding error must not make it invalid and break the chain.
  double neighbourCost(std::size_t i) const {
    const double cost = map_.segmentCost(samples_[i], samples_[i + 1]);
    return cost >= 0.0 ? cost : (samples_[i + 1] - samples_[i]).norm() * map_.weight(1);
  }

  const ClearanceMap& map_;
  const std::vector<Vec2>& samples_;
  std::size_t ahead_;
  std::vector<double> along_;  ///< cost of the way through all samples up to each
  std::vector<double> cost_;   ///< of the cheapest polyline to each
  std::vector<std::size_t> parent_;
};

/// Drops the points at which the path does not turn.
std::vector<Vec2> withoutStraightPoints(const ClearanceMap& map, const std::vector<Vec2>& points) {
  std::vector<Vec2> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 before = points[i] - kept.back();
    const Vec2 after = points[i + 1] - points[i];
    const bool turns = before.dot(after) < (1.0 - kSmoothingRounding) * before.norm() * after.norm();
    if (turns || !map.isValid(kept.back(), points[i + 1])) kept.push_back(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

/// Drops points of a dense path that a line of at most `spacing` [m] can replace without costing more.
std::vector<Vec2> thinned(const ClearanceMap& map, const Path& path, double spacing) {
  const std::vector<Vec2>& points = path.points();
  std::vector<Vec2> kept{points.front()};
  double cost = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = std::max(0.0, map.segmentCost(points[i - 1], points[i]));
    const Vec2& from = kept.back();
    const double line = (points[i] - from).norm() <= spacing ? map.segmentCost(from, points[i]) : -1.0;
    if (i > 1 && (line < 0.0 || line > cost + step + kSmoothingRounding)) {
      kept.push_back(points[i - 1]);
      cost = 0.0;
    }
    cost += step;
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

Path pullString(const ClearanceMap& map, const std::vector<Vec2>& samples, std::size_t ahead) {
  if (samples.size() < 3) return Path(samples);
  return Path(withoutStraightPoints(map, Chain(map, samples, ahead).points()));
}

Path smoothPath(const ClearanceMap& map, const Path& path) {
  if (path.points().size() < 3) return path;
  const double cell = map.geometry().resolution;
  // The lines tried are at most 10 m long at first, over the whole path, and then reach from corner to corner.
  Path pulled = pullString(map, thinned(map, path, 5.0 * cell), 40);
  pulled = pullString(map, sampledAtCorners(pulled, 3.0 * cell, 20.0 * cell), 16);
  return pullString(map, sampledAtCorners(pulled, 2.0 * cell, 10.0 * cell), 12);
}

}  // namespace frontier_pilot::planning
