#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::surfaces {

/// First and last of some successive points.
struct Span {
  std::size_t first, last;
  std::size_t size() const { return last - first + 1; }
};

/// Finds the neighbours of points. Blocks of points whose bounding box lies within the radius are taken at once, so
/// that a scan of many beams, each of which has thousands of neighbours, costs little more for each beam than one of
/// few.
class SpanFinder {
 public:
  /// `points` must outlive it, and stay where they are.
  explicit SpanFinder(const SurfacePoints& points);

  /// The connected points around `i` up to the first one beyond `radius` [m] to either side, but at least two there.
  Span around(std::size_t i, double radius) const;

 private:
  static constexpr std::size_t kFanOut = 16;  ///< points in a block, and blocks in a larger one
  struct Box {
    Vec2 low, high;
  };
  struct Disc {
    Vec2 centre;
    double squared_radius;
  };

  void connect();
  void enclose();
  bool holds(const Disc& disc, std::size_t i) const;
  static bool holdsAll(const Disc& disc, const Box& box);
  std::size_t countUp(const Disc& disc, std::size_t from, std::size_t last) const;
  std::size_t countDown(const Disc& disc, std::size_t from, std::size_t first) const;

  const SurfacePoints& points_;
  std::vector<Span> connected_;          ///< what each point is connected with
  std::vector<std::vector<Box>> boxes_;  ///< of each block, of each block of blocks and so on; whole ones only
};

/// The greatest of any successive values, block by block.
class RangeMaximum {
 public:
  explicit RangeMaximum(std::vector<double> values);
  double operator()(const Span& span) const;
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  static constexpr std::size_t kBlock = 64;
  std::vector<double> values_;
  std::vector<double> blocks_;  ///< whole ones only
};

}  // namespace frontier_pilot::surfaces
