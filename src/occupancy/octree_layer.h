#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/parameters.h"

namespace frontier_pilot::occupancy {

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
  /// The smallest rectangle that holds every known cell of the layer.
  CellRect extent() const;
  /// The log-odds of every known cell of the layer.
  void forEach(const std::function<void(Cell, float)>& visit) const;
  void clear();

  /// The number of known cells. Walks the tree, as `memory` does.
  std::size_t leafCount() const;
  /// What the nodes take [bytes].
  std::size_t memory() const;

  /// OctoMap's binary format (.bt): each cell free or occupied. False when the stream fails.
  bool write(std::ostream& out);
  /// Replaces the content by an octree in OctoMap's binary format. Gives an empty text; or what is wrong with the
  /// bytes, and nothing is changed, when they are not such an octree of this resolution and of at most `most_nodes`,
  /// whole.
  std::string read(const std::string& bytes, std::uint64_t most_nodes);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::occupancy
