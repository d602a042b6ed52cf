#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace frontier_pilot::occupancy {

/// What a .bt file announces, and where its tree lies.
struct OctreeFile {
  std::string problem;  ///< what is wrong with it; empty if it is sound
  std::uint64_t nodes = 0;
  std::string_view tree;  ///< of the bytes that were checked

  bool ok() const { return problem.empty(); }
};

/// Whether `bytes` are OctoMap's binary format: an octree of `resolution` [m], of at most `most_nodes` nodes and 16
/// levels, all of it and nothing else. OctoMap's reader itself trusts what it reads: it follows a tree as deep as it
/// goes, and takes the end of a file for nodes without children. [FLT-1] [MAP-5]
OctreeFile checkOctree(std::string_view bytes, double resolution, std::uint64_t most_nodes);

}  // namespace frontier_pilot::occupancy
