#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string_view>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/growing_grid.h"
#include "frontier_pilot/occupancy/parameters.h"
#include "occupancy/octree_check.h"

namespace frontier_pilot::occupancy {

/// Half the cells along a side of an octree, whose keys have 16 bits: cells counted from the frame's origin must lie
/// within [-kOctreeHalfSide, kOctreeHalfSide).
constexpr int kOctreeHalfSide = 32768;

/// The vertical key of the layer at the scanner's height.
int layerOf(const OccupancyMapParameters& parameters);

/// Writes `cells`, log-odds, as the layer `z` of an octree in OctoMap's binary format, to the byte as OctoMap's own
/// writer does. An OcTree would take some 60 bytes for each known cell. Cells are counted from the frame's origin;
/// `resolution` [m]. Returns false when the stream fails.
bool writeOctree(const grids::TiledGrid<float>& cells, float unknown, int z, double resolution, std::ostream& out);

/// The leaves of one layer of a tree that `checkOctree` has accepted.
class OctreeLeaves {
 public:
  /// `tree` must outlive this.
  OctreeLeaves(std::string_view tree, int z) : tree_(tree), z_(z) {}

  /// Calls `visit` with the cells of each leaf, counted from the frame's origin, and whether they are occupied.
  void forEach(const std::function<void(const CellRect&, bool)>& visit) const;
  /// The smallest block that holds all of them.
  CellRect extent() const;

 private:
  std::string_view tree_;
  int z_;
};

}  // namespace frontier_pilot::occupancy
