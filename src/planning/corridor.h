#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "planning/block_summary.h"
#include "planning/octile.h"

namespace frontier_pilot::planning {

/// The part of a map in which the cheapest path from one cell to another runs, for a search over the cells that leaves
/// out the rest. It is found over blocks of 4 x 4 cells, a sixteenth of the map, at the cost of each block's cheapest
/// cell: first A* from the goal, which gives the cost from each block to the goal, then from the start with these as
/// exact heuristic, so that only blocks are looked at through which a path of the given cost leads.
///
/// What is known of a block is read from the map when a search comes to it, and nothing is kept for the next one, so
/// that changes of the map cost nothing here. Coarse-to-fine search after Holte, Perez, Zimmer & MacDonald,
/// "Hierarchical A*: Searching Abstraction Hierarchies Efficiently", AAAI 1996.
class Corridor {
 public:
  /// The corridor from `start` to `goal`, both passable: all blocks on paths over the blocks that cost at most `margin`
  /// more than the cheapest, and all on paths that cost at most `least_bound`. False if there is no path over the
  /// blocks; the cells may still have one, because a block's smaller parts do not count.
  bool find(const ClearanceMap& map, Cell start, Cell goal, std::uint32_t least_bound = 0);
  /// Most that a path over the blocks costs that lies in the corridor, in the unit of GridSearch::cost.
  std::uint32_t bound() const { return bound_ * kBlockSide; }
  /// The classes of the cells in the corridor (ClearanceMap::costClass); 0 outside of it.
  const Grid<std::uint8_t>& classes() const { return classes_; }

 private:
  struct Block {
    std::uint32_t to_goal;     ///< cost from the block to the goal's, in units of 1/70 block
    std::uint32_t from_start;  ///< cost from the start's block to this one
    std::uint32_t label;       ///< number of the search, class, and the bits below
    std::uint16_t cells;       ///< BlockSummary::cells
  };
  /// More buckets than the cost of two of the most expensive steps.
  using Queue = grids::BucketQueue<4096>;
  using Around = std::array<std::uint16_t, 8>;
  static constexpr std::uint32_t kClassMask = ClearanceMap::kClassMask;
  static constexpr std::uint32_t kSettled = 64;  ///< `to_goal` is final
  static constexpr std::uint32_t kInside = 128;  ///< the block belongs to the corridor
  static constexpr int kNumberShift = 8;

  void prepare(const ClearanceMap& map);
  void close();
  void open(const ClearanceMap& map, Cell block);
  Block& visit(const ClearanceMap& map, Cell block);
  unsigned links(const ClearanceMap& map, Cell block);
  bool searchBack(const ClearanceMap& map, Cell start, Cell goal, std::uint32_t least_bound);
  void searchForward(const ClearanceMap& map, Cell start);

  GridGeometry grid_;  ///< of the blocks
  std::array<std::size_t, 8> offsets_{};
  StepCosts step_cost_{};
  std::vector<Block> blocks_;
  std::uint32_t number_ = 0;
  std::vector<Cell> inside_;
  Grid<std::uint8_t> classes_;
  std::uint32_t bound_ = 0;
  Queue queue_;
};

}  // namespace frontier_pilot::planning
