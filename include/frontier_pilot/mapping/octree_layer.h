#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/mapping/log_odds.h"

namespace frontier_pilot {

/// One horizontal layer of cells in an octomap::OcTree. Cells are counted from the frame's origin: cell (0, 0) has its
/// lower left corner at (0, 0) [m].
class OctreeLayer {
 public:
  /// Cells must lie within [-kHalfSide, kHalfSide): OctoMap's keys have 16 bits.
  static constexpr int kHalfSide = 32768;

  /// `resolution` [m] of a cell, `height` [m] of the layer over the frame's origin.
  OctreeLayer(double resolution, double height, const OccupancyModel& model);
  ~OctreeLayer();
  OctreeLayer(OctreeLayer&&) noexcept;
  OctreeLayer& operator=(OctreeLayer&&) noexcept;

  void set(Cell cell, float log_odds);
  /// The log-odds of every known cell of the layer.
  void forEach(const std::function<void(Cell, float)>& visit) const;
  void clear();

  /// The number of known cells. Walks the tree, as `memory` does.
  std::size_t leafCount() const;
  /// What the nodes take [bytes].
  std::size_t memory() const;

  /// OctoMap's binary format (.bt): each cell free or occupied. False when the stream fails.
  bool write(std::ostream& out);
  /// Replaces the content. False, and nothing is changed, when the stream is no binary octree of this resolution.
  bool read(std::istream& in);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot
