#include "planning/block_summary.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstring>

namespace frontier_pilot::planning {
namespace {

constexpr std::uint16_t kAllCells = 0xFFFF;

/// Of a block's passable cells those of the largest part that is connected by straight steps.
std::uint16_t largestPart(unsigned passable) {
  constexpr unsigned kNotWestmost = 0xEEEE;
  constexpr unsigned kNotEastmost = 0x7777;
  unsigned largest = 0;
  std::size_t most = 0;
  while (passable != 0) {
    unsigned part = 0;
    for (unsigned grown = passable & (~passable + 1U); grown != part;) {
      part = grown;
      grown |= part << 4U | part >> 4U | (part << 1U & kNotWestmost) | (part >> 1U & kNotEastmost);
      grown &= passable;
    }
    const std::size_t size = std::bitset<16>(part).count();
    if (size > most) {
      most = size;
      largest = part;
    }
    passable &= ~part;
  }
  return static_cast<std::uint16_t>(largest);
}

/// The classes of a block's cells, row by row; 0 beyond the map's border.
using Classes = std::array<std::uint8_t, std::size_t{kBlockSide} * kBlockSide>;

Classes classesOf(const ClearanceMap& map, Cell block) {
  Classes classes{};
  const CellRect cells =
      CellRect{block.x * kBlockSide, block.y * kBlockSide, kBlockSide, kBlockSide}.intersection(map.geometry().rect());
  for (int y = 0; y < cells.height; ++y) {
    std::memcpy(classes.data() + std::ptrdiff_t{kBlockSide} * y, map.costs().row(cells.y + y) + cells.x,
                static_cast<std::size_t>(cells.width));
  }
  for (std::uint8_t& cost_class : classes) cost_class &= ClearanceMap::kClassMask;
  return classes;
}

}  // namespace

BlockSummary summarise(const ClearanceMap& map, Cell block) {
  const Classes classes = classesOf(map, block);
  const bool uniform = std::memcmp(classes.data(), classes.data() + 1, classes.size() - 1) == 0;
  if (uniform) return {classes[0] == 0 ? std::uint16_t{0} : kAllCells, classes[0]};
  unsigned passable = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) passable |= (classes[i] != 0 ? 1U : 0U) << i;
  BlockSummary summary;
  summary.cells = passable == kAllCells ? kAllCells : largestPart(passable);
  // Of two classes the greater one is cheaper, but for tight cells, which are the last resort.
  int cheapest = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if ((summary.cells >> i & 1U) != 0) cheapest = std::max(cheapest, classes[i] % ClearanceMap::kTightClass);
  }
  summary.cost_class = static_cast<std::uint8_t>(cheapest == 0 ? ClearanceMap::kTightClass : cheapest);
  return summary;
}

unsigned linkedNeighbours(std::uint16_t cells, const std::array<std::uint16_t, 8>& around) {
  const bool open = std::all_of(around.begin(), around.end(), [](std::uint16_t other) { return other == kAllCells; });
  if (open && cells == kAllCells) return 0xFF;
  const auto across = [](unsigned west, unsigned east) { return ((west & 0x8888U) >> 3U & east) != 0; };
  const auto up = [](unsigned south, unsigned north) { return (south >> 12U & north) != 0; };
  const std::array<bool, 4> straight{across(cells, around[0]), up(cells, around[2]), across(around[4], cells),
                                     up(around[6], cells)};
  const std::array<bool, 4> beyond{up(around[0], around[1]) && across(around[2], around[1]),
                                   up(around[4], around[3]) && across(around[3], around[2]),
                                   up(around[5], around[4]) && across(around[5], around[6]),
                                   up(around[7], around[0]) && across(around[6], around[7])};
  unsigned links = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool diagonal = straight[i] && straight[(i + 1) % 4] && beyond[i];
    links |= (straight[i] ? 1U : 0U) << (2 * i) | (diagonal ? 2U : 0U) << (2 * i);
  }
  return links;
}

}  // namespace frontier_pilot::planning
