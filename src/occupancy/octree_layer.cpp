#include "occupancy/octree_layer.h"

#include <octomap/OcTree.h>

#include <ostream>
#include <sstream>

#include "occupancy/octree_file.h"

namespace frontier_pilot::occupancy {

namespace {

void configure(octomap::OcTree& tree, const OccupancyModel& model) {
  tree.setProbHit(model.hit);
  tree.setProbMiss(model.miss);
  tree.setClampingThresMin(model.clamp_min);
  tree.setClampingThresMax(model.clamp_max);
  tree.setOccupancyThres(0.5);
}

/// A leaf: above the lowest level it stands for a cube of cells.
struct LeafCube {
  octomap::OcTreeKey low;
  int side;

  LeafCube(const octomap::OcTree& tree, const octomap::OcTree::leaf_iterator& leaf)
      : low(leaf.getIndexKey()), side(1 << (tree.getTreeDepth() - leaf.getDepth())) {}

  /// Whether one of the cube's layers is the layer `z`.
  bool holds(octomap::key_type z) const { return z >= low[2] && z < low[2] + side; }
  CellRect cells() const { return {low[0] - kOctreeHalfSide, low[1] - kOctreeHalfSide, side, side}; }
};

}  // namespace

struct OctreeLayer::Impl {
  OccupancyModel model;
  octomap::OcTree tree;
  octomap::key_type z;  ///< key of the layer

  Impl(double resolution, double height, const OccupancyModel& occupancy)
      : model(occupancy), tree(resolution), z(tree.coordToKey(height)) {
    configure(tree, model);
  }

  octomap::OcTreeKey key(Cell cell) const {
    return {static_cast<octomap::key_type>(cell.x + kOctreeHalfSide),
            static_cast<octomap::key_type>(cell.y + kOctreeHalfSide), z};
  }
};

OctreeLayer::OctreeLayer(double resolution, double height, const OccupancyModel& model)
    : impl_(std::make_unique<Impl>(resolution, height, model)) {}
OctreeLayer::~OctreeLayer() = default;
OctreeLayer::OctreeLayer(OctreeLayer&&) noexcept = default;
OctreeLayer& OctreeLayer::operator=(OctreeLayer&&) noexcept = default;

void OctreeLayer::set(Cell cell, float log_odds) {
  // Lazy: inner nodes are updated once, before the tree is written. A single layer is never pruned, because four of
  // each node's eight children are missing.
  impl_->tree.setNodeValue(impl_->key(cell), log_odds, true);
}

void OctreeLayer::forEach(const std::function<void(Cell, float)>& visit) const {
  for (auto leaf = impl_->tree.begin_leafs(); leaf != impl_->tree.end_leafs(); ++leaf) {
    const LeafCube cube(impl_->tree, leaf);
    if (!cube.holds(impl_->z)) continue;
    const CellRect cells = cube.cells();
    for (int y = 0; y < cells.height; ++y) {
      for (int x = 0; x < cells.width; ++x) visit({cells.x + x, cells.y + y}, leaf->getLogOdds());
    }
  }
}

std::size_t OctreeLayer::leafCount() const { return impl_->tree.getNumLeafNodes(); }

std::size_t OctreeLayer::memory() const { return impl_->tree.memoryUsage(); }

bool OctreeLayer::write(std::ostream& out) {
  impl_->tree.updateInnerOccupancy();
  // The const version: the other one would first set the tree's log-odds to the clamping bounds.
  return impl_->tree.writeBinaryConst(out) && out.good();
}

bool OctreeLayer::read(const std::string& bytes) {
  std::istringstream in(bytes);
  return impl_->tree.readBinary(in);
}

}  // namespace frontier_pilot::occupancy
