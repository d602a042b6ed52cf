#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::surfaces {

/// A range of successive points, by the indices of the first and the last.
struct Span {
  std::size_t first, last;
  std::size_t size() const { return last - first + 1; }
};

/// Finds the neighbours of points. Blocks of points whose bounding box lies within the radius are added at once, so
/// that a beam in a dense scan, with thousands of neighbours, costs little more than one in a sparse scan.
class SpanFinder {
 public:
  /// `points` must outlive it and must not be moved in memory.
  explicit SpanFinder(const SurfacePoints& points);

  /// The connected points around `i` up to the first one beyond `radius` [m] on either side, but at least two per side.
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
  std::vector<Span> connected_;          ///< by point: all the points that it is connected with
  std::vector<std::vector<Box>> boxes_;  ///< of each full block, of each full block of blocks and so on
};

/// The greatest value in a range of indices, found block by block.
class RangeMaximum {
 public:
  explicit RangeMaximum(std::vector<double> values);
  double operator()(const Span& span) const;
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  static constexpr std::size_t kBlock = 64;
  std::vector<double> values_;
  std::vector<double> blocks_;  ///< maxima of the full blocks
};

}  // namespace frontier_pilot::surfaces
