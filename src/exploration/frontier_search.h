#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// Frontier cells [begin, end) of row `y`.
struct FrontierRun {
  int y = 0;
  int begin = 0;
  int end = 0;
};

/// An 8-connected component of frontier cells, or a piece of a long one.
struct FrontierCluster {
  std::size_t first_run = 0;  ///< its runs in FrontierClusters::runs, row by row
  std::size_t run_count = 0;
  int cells = 0;                 ///< its own size
  int component_cells = 0;       ///< size of the component, of which it may be a piece
  Vec2 centroid = Vec2::Zero();  ///< [cells], the mean of the cells' indices; may lie in a wall
  CellRect box;
};

struct FrontierClusters {
  std::vector<FrontierRun> runs;
  std::vector<FrontierCluster> clusters;  ///< ordered by their first cell, row by row from the lower left
  bool too_many = false;                  ///< cells or clusters, see core/bounds.h; then both lists are empty
};

/// Writes for each cell of a row whether it is a frontier cell: free, with an unknown 8-neighbour. [EXP-2]
/// `below` and `above` are null at the edge of the map; what is outside of the map is no neighbour. `scratch` is
/// working memory that is kept between calls.
void markFrontierCells(const std::int8_t* below, const std::int8_t* row, const std::int8_t* above, int width,
                       std::vector<std::int8_t>& scratch, std::uint8_t* out);

/// The frontier of a map, kept up to date row by row. After a change only the block it touches is searched again; the
/// clusters are then joined from runs of cells, at a cost that depends on the length of the frontier and not on the
/// size of the map. The result is that of a breadth-first search over 8-neighbours. [EXP-2]
/// A map of noise may have millions of frontier cells: beyond the bound they are only counted. [FLT-1]
/// He, Chao & Suzuki, "A Run-Based Two-Scan Labeling Algorithm", IEEE Trans. Image Processing 17(5), 2008.
class FrontierSearch {
 public:
  /// Searches the cells again that a change of `map` within `changed` can affect; all cells if the geometry is new.
  void update(const OccupancyGrid& map, const CellRect& changed);

  /// Clusters of at least `min_cells`. One wider or higher than `max_extent` cells is cut across its longer side into
  /// equal slabs, so that a long frontier offers goals all along; 0 leaves them whole.
  FrontierClusters clusters(int min_cells = 1, int max_extent = 0) const;

  std::size_t cellCount() const { return cell_count_; }

 private:
  struct Span {
    int begin, end;
  };
  void searchRows(const OccupancyGrid& map, const CellRect& area);
  void countRow(const OccupancyGrid& map, int y, const Span& columns);
  void keepRow(std::vector<Span>& spans, const Span& columns);
  static std::size_t cellsWithin(const std::vector<Span>& spans, const Span& columns);
  bool tooMany() const;

  GridGeometry geometry_;
  std::vector<std::vector<Span>> rows_;
  std::vector<std::size_t> cells_in_row_;
  std::size_t cell_count_ = 0;
  bool rows_kept_ = true;  ///< false: there were too many, and some rows are missing
  std::vector<std::int8_t> scratch_;
  std::vector<std::uint8_t> marks_;
  std::vector<Span> spans_;
};

/// The cell of a cluster nearest to its centroid.
Cell anchorOf(const FrontierClusters& all, const FrontierCluster& cluster);

/// The `k`-th cell of a cluster, row by row; 0 <= k < cells.
Cell cellOf(const FrontierClusters& all, const FrontierCluster& cluster, int k);

}  // namespace frontier_pilot::exploration
