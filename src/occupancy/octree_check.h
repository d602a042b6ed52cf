#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace frontier_pilot::occupancy {

/// Levels of a tree below its root.
constexpr int kOctreeLevels = 16;

/// The contents of a .bt file: the number of nodes by its header, and the bytes of its tree.
struct OctreeFile {
  std::string problem;  ///< what is wrong with the file; empty if nothing is
  std::uint64_t nodes = 0;
  std::string_view tree;  ///< the part of the checked bytes that holds the tree

  bool ok() const { return problem.empty(); }
};

/// Checks that `bytes` are a complete octree in OctoMap's binary format and nothing else, of `resolution` [m], with at
/// most `most_nodes` nodes and 16 levels. OctoMap's own reader does not check its input: it follows a tree to any
/// depth, and takes the end of a file for nodes without children. [FLT-1] [MAP-5]
OctreeFile checkOctree(std::string_view bytes, double resolution, std::uint64_t most_nodes);

}  // namespace frontier_pilot::occupancy
