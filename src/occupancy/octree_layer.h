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

/// One horizontal layer of cells in an octomap::OcTree, for those who want the map as OctoMap holds it. Cells are
/// numbered from the frame's origin: the lower left corner of cell (0, 0) is at (0, 0) [m]. They must lie within
/// kOctreeHalfSide of it.
class OctreeLayer {
 public:
  /// `resolution`: side of a cell [m]; `height`: of the layer above the frame's origin [m].
  OctreeLayer(double resolution, double height, const OccupancyModel& model);
  ~OctreeLayer();
  OctreeLayer(OctreeLayer&&) noexcept;
  OctreeLayer& operator=(OctreeLayer&&) noexcept;

  void set(Cell cell, float log_odds);
  /// Calls `visit` with every known cell of the layer and its log-odds.
  void forEach(const std::function<void(Cell, float)>& visit) const;

  /// The number of leaves of the octree. Traverses the tree, as `memory` does.
  std::size_t leafCount() const;
  /// The memory that the nodes take [bytes].
  std::size_t memory() const;

  /// Writes OctoMap's binary format (.bt): each cell free or occupied. Returns false when the stream fails.
  bool write(std::ostream& out);
  /// Replaces the content by an octree in OctoMap's binary format. Returns false when OctoMap cannot read it; it does
  /// not check it.
  bool read(const std::string& bytes);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::occupancy
