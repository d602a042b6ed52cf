#include "ros/common/maps/block_changes.h"

#include <algorithm>
#include <cstring>

namespace frontier_pilot {
namespace {

int blocksAlong(int cells) { return (cells + BlockChanges::kSide - 1) / BlockChanges::kSide; }

/// The mixing function of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014): each bit of the result depends on all bits of the input.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31);
}

/// Of the cells `block` of `grid`; never zero.
std::uint64_t hashOf(const OccupancyGrid& grid, const CellRect& block) {
  std::uint64_t hash = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    const std::int8_t* const row = grid.row(y) + block.x;
    for (int x = 0; x < block.width; x += 8) {
      std::uint64_t cells = 0;
      std::memcpy(&cells, row + x, static_cast<std::size_t>(std::min(8, block.width - x)));
      hash = mixed(hash + 0x9E3779B97F4A7C15U) ^ cells;
    }
  }
  return std::max<std::uint64_t>(mixed(hash), 1);
}

}  // namespace

void BlockChanges::reset(const GridGeometry& geometry) {
  geometry_ = geometry;
  const auto rows = static_cast<std::size_t>(blocksAlong(geometry.height));
  sent_.assign(rows * static_cast<std::size_t>(columns()), 0);
}

CellRect BlockChanges::blocksAround(const CellRect& cells) const {
  const CellRect inside = cells.intersection(geometry_.rect());
  if (inside.empty()) return {};
  const int x = inside.x / kSide * kSide;
  const int y = inside.y / kSide * kSide;
  const int right = blocksAlong(inside.x + inside.width) * kSide;
  const int top = blocksAlong(inside.y + inside.height) * kSide;
  return CellRect{x, y, right - x, top - y}.intersection(geometry_.rect());
}

std::vector<CellRect> BlockChanges::take(const OccupancyGrid& part, const CellRect& place) {
  std::vector<CellRect> changed;
  for (int y = 0; y < place.height; y += kSide) {
    const CellRect* before = nullptr;  // the block before this one, or the run that it ends, if it has changed
    for (int x = 0; x < place.width; x += kSide) {
      const CellRect block = CellRect{x, y, kSide, kSide}.intersection(part.geometry().rect());
      const std::uint64_t hash = hashOf(part, block);
      const auto row = static_cast<std::size_t>((place.y + y) / kSide);
      std::uint64_t& sent =
          sent_[row * static_cast<std::size_t>(columns()) + static_cast<std::size_t>((place.x + x) / kSide)];
      const bool same = sent == hash;
      sent = hash;
      if (same) {
        before = nullptr;
      } else if (before != nullptr) {
        changed.back().width += block.width;
      } else {
        changed.push_back({place.x + x, place.y + y, block.width, block.height});
        before = &changed.back();
      }
    }
  }
  return changed;
}

}  // namespace frontier_pilot
