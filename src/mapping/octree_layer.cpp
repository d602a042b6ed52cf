#include "frontier_pilot/mapping/octree_layer.h"

#include <octomap/OcTree.h>

#include <cmath>
#include <istream>
#include <ostream>

namespace frontier_pilot {

namespace {

void configure(octomap::OcTree& tree, const OccupancyModel& model) {
  tree.setProbHit(model.hit);
  tree.setProbMiss(model.miss);
  tree.setClampingThresMin(model.clamp_min);
  tree.setClampingThresMax(model.clamp_max);
  tree.setOccupancyThres(0.5);
}

}  // namespace

struct OctreeLayer::Impl {
  OccupancyModel model;
  octomap::OcTree tree;
  octomap::key_type z;  ///< the layer

  Impl(double resolution, double height, const OccupancyModel& occupancy)
      : model(occupancy), tree(resolution), z(tree.coordToKey(height)) {
    configure(tree, model);
  }

  octomap::OcTreeKey key(Cell cell) const {
    return {static_cast<octomap::key_type>(cell.x + kHalfSide), static_cast<octomap::key_type>(cell.y + kHalfSide), z};
  }
};

OctreeLayer::OctreeLayer(double resolution, double height, const OccupancyModel& model)
    : impl_(std::make_unique<Impl>(resolution, height, model)) {}
OctreeLayer::~OctreeLayer() = default;
OctreeLayer::OctreeLayer(OctreeLayer&&) noexcept = default;
OctreeLayer& OctreeLayer::operator=(OctreeLayer&&) noexcept = default;

void OctreeLayer::set(Cell cell, float log_odds) {
  // Lazy: inner nodes are brought up to date once, before the tree is written. A single layer never prunes, because
  // four of a node's eight children are missing.
  impl_->tree.setNodeValue(impl_->key(cell), log_odds, true);
}

void OctreeLayer::forEach(const std::function<void(Cell, float)>& visit) const {
  const unsigned depth = impl_->tree.getTreeDepth();
  for (auto leaf = impl_->tree.begin_leafs(); leaf != impl_->tree.end_leafs(); ++leaf) {
    // A leaf above the lowest level stands for a cube of cells: one layer of it lies in ours, or none.
    const int side = 1 << (depth - leaf.getDepth());
    const octomap::OcTreeKey low = leaf.getIndexKey();
    if (impl_->z < low[2] || impl_->z >= low[2] + side) continue;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) visit({low[0] + x - kHalfSide, low[1] + y - kHalfSide}, leaf->getLogOdds());
    }
  }
}

void OctreeLayer::clear() { impl_->tree.clear(); }

std::size_t OctreeLayer::leafCount() const { return impl_->tree.getNumLeafNodes(); }

std::size_t OctreeLayer::memory() const { return impl_->tree.memoryUsage(); }

bool OctreeLayer::write(std::ostream& out) {
  impl_->tree.updateInnerOccupancy();
  // The const version: the other one would first round our log-odds to free and occupied.
  return impl_->tree.writeBinaryConst(out) && out.good();
}

bool OctreeLayer::read(std::istream& in) {
  octomap::OcTree tree(impl_->tree.getResolution());
  configure(tree, impl_->model);
  if (!tree.readBinary(in)) return false;
  if (std::abs(tree.getResolution() - impl_->tree.getResolution()) > 1e-6) return false;
  impl_->tree.swapContent(tree);
  return true;
}

}  // namespace frontier_pilot
