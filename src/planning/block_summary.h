#pragma once

#include <array>
#include <cstdint>

#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::planning {

/// Side of a block [cells]. Passable cells on both sides of a wall are farther apart at the usual resolution.
constexpr int kBlockSide = 4;

/// A block of cells in brief. Of its passable cells only the largest part counts that is connected within the block, so
/// that one can get from each of its sides to each other one, and blocks that are linked are linked over their cells.
struct BlockSummary {
  std::uint16_t cells = 0;      ///< bit 4 y + x for each cell of that part
  std::uint8_t cost_class = 0;  ///< of its cheapest cell (ClearanceMap::costClass); 0 if there is none
};

/// `block` counts blocks from the map's lower left corner; cells beyond the map's border are not passable.
BlockSummary summarise(const ClearanceMap& map, Cell block);

/// The neighbours (bit i for grids::kNeighbourSteps[i]) that one can step to from a block. Diagonal steps need both
/// blocks beside them.
unsigned linkedNeighbours(std::uint16_t cells, const std::array<std::uint16_t, 8>& around);

}  // namespace frontier_pilot::planning
