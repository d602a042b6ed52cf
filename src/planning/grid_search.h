#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "planning/octile.h"

namespace frontier_pilot::planning {

/// Shortest paths over the passable cells of a ClearanceMap, 8-connected; a diagonal step needs both cells beside it to
/// be passable, so the reachable cells are those of a 4-connected flood fill. Complete, optimal for the cells' costs
/// and deterministic.
///
/// A* (Hart, Nilsson & Raphael, IEEE Trans. Systems Science and Cybernetics 4(2), 1968) with integer costs, so that the
/// queue is a ring of buckets (Dial, CACM 12(11), 1969): all open f-values lie within two steps' cost of the least.
/// Nodes carry the number of the search that wrote them; nothing is cleared between searches.
///
/// Where a cell and its neighbours cost the same, many paths through them do too, and only the one whose diagonal steps
/// come first is followed: the neighbours that are not on it are reached as cheaply without passing through the cell
/// (Harabor & Grastien, "Online Graph Pruning for Pathfinding on Grid Maps", AAAI 2011). A cell that several equally
/// cheap paths come to continues all of them, even those that come after it was expanded.
class GridSearch {
 public:
  /// Whether a path from `start` to `goal`, both passable, exists. If not, `reached` holds for all cells that are
  /// reachable.
  bool search(const ClearanceMap& map, Cell start, Cell goal) { return search(map, map.costs(), start, goal); }
  /// The same among the cells that `classes`, in place of the map's own, leaves passable.
  bool search(const ClearanceMap& map, const Grid<std::uint8_t>& classes, Cell start, Cell goal);
  /// Whether the last search expanded `cell`.
  bool reached(Cell cell) const;
  /// The cells from the last start to `cell`, which must have been reached.
  std::vector<Cell> pathTo(Cell cell) const;
  /// The cost of that path, in units of 1/70 cell.
  std::uint32_t costTo(Cell cell) const { return nodes_[geometry_.index(cell)].cost; }
  /// Number of cells that the last search expanded.
  std::size_t expanded() const { return expanded_; }

 private:
  struct Node {
    std::uint32_t cost;   ///< from the start, in units of 1/70 cell
    std::uint32_t label;  ///< number of the search, the directions it was reached by at that cost, and the bits below
  };
  /// More buckets than the cost of two of the most expensive steps.
  using Queue = grids::BucketQueue<4096>;
  static constexpr std::uint32_t kDirectionMask = 7;  ///< the direction that it was first reached by at its cost
  static constexpr std::uint32_t kClosed = 8;         ///< it was expanded
  static constexpr std::uint32_t kPending = 16;       ///< it was reached by a direction since
  static constexpr int kArrivalShift = 5;
  static constexpr int kNumberShift = 13;

  void prepare(const ClearanceMap& map);
  void begin(Cell start, Cell goal);
  void expand(std::uint32_t index, std::uint32_t cost, std::uint32_t label);
  void relax(std::uint32_t index, std::uint32_t cost, std::uint32_t direction, Cell cell);
  bool written(const Node& node) const { return node.label >> kNumberShift == number_; }

  GridGeometry geometry_;
  StepCosts step_cost_{};
  std::array<std::size_t, 8> offsets_{};  ///< of the neighbours' indices
  const std::uint8_t* costs_ = nullptr;   ///< of the map being searched
  std::vector<Node> nodes_;
  std::uint32_t number_ = 0;
  std::size_t expanded_ = 0;
  Cell start_;
  Cell goal_;
  Queue queue_;
};

}  // namespace frontier_pilot::planning
