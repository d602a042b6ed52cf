#include "occupancy/octree_file.h"

#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace frontier_pilot::occupancy {
namespace {

constexpr unsigned kChildren = 8;
/// What two bits say of a child.
constexpr unsigned kNothing = 0, kFreeLeaf = 1, kOccupiedLeaf = 2, kInner = 3;

using Tiles = grids::TiledGrid<float>;

/// A node of the tree: a cube of 2^level cells along a side, and its lowest keys.
struct Cube {
  int level = kOctreeLevels;
  int x = 0, y = 0, z = 0;

  int side() const { return 1 << level; }
  Cube child(unsigned i) const {
    const int half = 1 << (level - 1);
    return {level - 1, x + ((i & 1U) != 0 ? half : 0), y + ((i & 2U) != 0 ? half : 0), z + ((i & 4U) != 0 ? half : 0)};
  }
  bool holds(int layer) const { return layer >= z && layer < z + side(); }
  /// Its cells, counted from the frame's origin.
  CellRect cells() const { return {x - kOctreeHalfSide, y - kOctreeHalfSide, side(), side()}; }
};

/// How many tiles are allocated in blocks of tiles, by a table of sums (Crow, SIGGRAPH 1984).
class TileCounts {
 public:
  explicit TileCounts(const Tiles& tiles)
      : extent_(tiles.extent()),
        width_(extent_.width / Tiles::kSide + 1),
        sums_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(extent_.height / Tiles::kSide + 1)) {
    for (int y = 1; y <= extent_.height / Tiles::kSide; ++y) {
      for (int x = 1; x < width_; ++x) {
        const Cell low{extent_.x + (x - 1) * Tiles::kSide, extent_.y + (y - 1) * Tiles::kSide};
        const int here = tiles.tile(low) != nullptr ? 1 : 0;
        sum(x, y) = here + sum(x - 1, y) + sum(x, y - 1) - sum(x - 1, y - 1);
      }
    }
  }

  /// Whether a tile is allocated in `cells`, whose borders are those of tiles.
  bool any(const CellRect& cells) const {
    const CellRect inside = cells.intersection(extent_);
    if (inside.empty()) return false;
    const int x = (inside.x - extent_.x) / Tiles::kSide;
    const int y = (inside.y - extent_.y) / Tiles::kSide;
    const int right = x + inside.width / Tiles::kSide;
    const int top = y + inside.height / Tiles::kSide;
    return sum(right, top) - sum(x, top) - sum(right, y) + sum(x, y) > 0;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int& sum(int x, int y) { return sums_[index(x, y)]; }
  int sum(int x, int y) const { return sums_[index(x, y)]; }

  CellRect extent_;
  int width_;
  std::vector<int> sums_;
};

/// Writes the nodes: for each inner node two bits for each of its children, then those that are inner nodes themselves.
class TreeWriter {
 public:
  TreeWriter(const Tiles& tiles, float unknown, int z) : tiles_(tiles), unknown_(unknown), z_(z), counts_(tiles) {}

  void write(const Cube& node) {
    const std::size_t at = bytes_.size();
    bytes_.append(2, '\0');
    ++nodes_;
    unsigned bits = 0;
    for (unsigned i = 0; i < kChildren; ++i) {
      const Cube child = node.child(i);
      const unsigned kind = child.holds(z_) ? kindOf(child) : kNothing;
      bits |= kind << (2U * i);
      if (kind == kInner) write(child);
      if (kind == kFreeLeaf || kind == kOccupiedLeaf) ++nodes_;
    }
    bytes_[at] = static_cast<char>(bits & 0xFFU);
    bytes_[at + 1] = static_cast<char>(bits >> 8U);
  }

  bool isEmpty() const { return !counts_.any(tiles_.extent()); }
  std::uint64_t nodes() const { return nodes_; }
  const std::string& bytes() const { return bytes_; }

 private:
  unsigned kindOf(const Cube& cube) const {
    const CellRect cells = cube.cells();
    if (cube.level > 0) return isKnown(cells) ? kInner : kNothing;
    const float log_odds = tiles_.get({cells.x, cells.y});
    if (log_odds == unknown_) return kNothing;
    return log_odds >= 0.0F ? kOccupiedLeaf : kFreeLeaf;
  }

  bool isKnown(const CellRect& cells) const {
    if (cells.width >= Tiles::kSide) return counts_.any(cells);
    const Tiles::Tile* tile = tiles_.tile({cells.x, cells.y});
    if (tile == nullptr) return false;
    const CellRect whole = grids::snap(cells, Tiles::kSide);
    for (int y = cells.y - whole.y; y < cells.y - whole.y + cells.height; ++y) {
      for (int x = cells.x - whole.x; x < cells.x - whole.x + cells.width; ++x) {
        if ((*tile)[static_cast<std::size_t>(y) * Tiles::kSide + static_cast<std::size_t>(x)] != unknown_) return true;
      }
    }
    return false;
  }

  const Tiles& tiles_;
  float unknown_;
  int z_;
  TileCounts counts_;
  std::uint64_t nodes_ = 0;
  std::string bytes_;
};

/// Reads the nodes in the order in which they are written.
class TreeReader {
 public:
  TreeReader(std::string_view tree, int z, const std::function<void(const CellRect&, bool)>& visit)
      : rest_(tree), z_(z), visit_(visit) {}

  void read(const Cube& node) {
    const unsigned bits =
        static_cast<unsigned char>(rest_[0]) | static_cast<unsigned>(static_cast<unsigned char>(rest_[1])) << 8U;
    rest_.remove_prefix(2);
    for (unsigned i = 0; i < kChildren; ++i) {
      const unsigned kind = (bits >> (2U * i)) & 3U;
      const Cube child = node.child(i);
      if ((kind == kFreeLeaf || kind == kOccupiedLeaf) && child.holds(z_)) visit_(child.cells(), kind == kOccupiedLeaf);
    }
    for (unsigned i = 0; i < kChildren; ++i) {
      if (((bits >> (2U * i)) & 3U) == kInner) read(node.child(i));
    }
  }

 private:
  std::string_view rest_;
  int z_;
  const std::function<void(const CellRect&, bool)>& visit_;
};

}  // namespace

int layerOf(const OccupancyMapParameters& parameters) {
  // Multiplied by the reciprocal, as OctoMap does, so that a height on the border of two layers lies in the same one.
  return static_cast<int>(std::floor(1.0 / parameters.resolution * parameters.scanner_height)) + kOctreeHalfSide;
}

bool writeOctree(const grids::TiledGrid<float>& cells, float unknown, int z, double resolution, std::ostream& out) {
  TreeWriter writer(cells, unknown, z);
  if (!writer.isEmpty()) writer.write(Cube{});
  out << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
      << "id OcTree\nsize " << writer.nodes() << "\nres " << resolution << "\ndata\n";
  out.write(writer.bytes().data(), static_cast<std::streamsize>(writer.bytes().size()));
  return out.good();
}

void OctreeLeaves::forEach(const std::function<void(const CellRect&, bool)>& visit) const {
  TreeReader(tree_, z_, visit).read(Cube{});
}

CellRect OctreeLeaves::extent() const {
  CellRect extent;
  forEach([&](const CellRect& leaf, bool) { extent.include(leaf); });
  return extent;
}

}  // namespace frontier_pilot::occupancy
