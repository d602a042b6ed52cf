#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"
#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::planning {

/// Shortest paths over the passable cells of a ClearanceMap, 8-connected; a diagonal step needs both cells beside it to
/// be passable, so the reachable cells are those of a 4-connected flood fill. Complete, optimal for the cells' costs
/// and deterministic.
///
/// A* (Hart, Nilsson & Raphael, IEEE Trans. Systems Science and Cybernetics 4(2), 1968) with integer costs, so that the
/// queue is a ring of buckets (Dial, CACM 12(11), 1969): all open f-values lie within two steps' cost of the least.
/// Nodes carry the number of the search that wrote them; nothing is cleared between searches.
class GridSearch {
 public:
  /// Whether a path from `start` to `goal`, both passable, exists. If not, `reached` holds for all cells that are
  /// reachable.
  bool search(const ClearanceMap& map, Cell start, Cell goal);
  /// Whether the last search expanded `cell`.
  bool reached(Cell cell) const;
  /// The cells from the last start to `cell`, which must have been reached.
  std::vector<Cell> pathTo(Cell cell) const;
  /// Number of cells that the last search expanded.
  std::size_t expanded() const { return expanded_; }

 private:
  struct Node {
    std::uint32_t cost;   ///< from the start, in units of 1/70 cell
    std::uint32_t label;  ///< number of the search, closed bit, direction it was reached by
  };
  /// More buckets than the cost of two of the most expensive steps.
  using Queue = grids::BucketQueue<4096>;
  static constexpr std::uint32_t kDirectionMask = 7;
  static constexpr std::uint32_t kClosed = 8;
  static constexpr int kNumberShift = 4;

  void prepare(const ClearanceMap& map);
  void begin(Cell start, Cell goal);
  void expand(const ClearanceMap& map, std::uint32_t index);
  void relax(std::uint32_t index, std::uint32_t cost, std::uint32_t direction);
  std::uint32_t heuristic(Cell cell) const;
  bool written(std::uint32_t index) const { return nodes_[index].label >> kNumberShift == number_; }

  GridGeometry geometry_;
  std::array<std::array<std::uint32_t, 2>, ClearanceMap::kClasses> step_cost_{};  ///< [class][diagonal]
  std::array<std::size_t, 8> offsets_{};                                          ///< of the neighbours' indices
  std::vector<Node> nodes_;
  std::uint32_t number_ = 0;
  std::size_t expanded_ = 0;
  Cell start_;
  Cell goal_;
  Queue queue_;
};

}  // namespace frontier_pilot::planning
