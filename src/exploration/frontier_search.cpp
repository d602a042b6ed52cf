#include "exploration/frontier_search.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "exploration/run_labels.h"
#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::exploration {

void markFrontierCells(const std::int8_t* below, const std::int8_t* row, const std::int8_t* above, int width,
                       std::vector<std::int8_t>& scratch, std::uint8_t* out) {
  // Unknown cells are negative, so the bitwise OR of several cells is negative if any of them is unknown. The loops
  // over bytes have no branches, so that the compiler can vectorise them.
  const auto n = static_cast<std::size_t>(width);
  scratch.assign(n + 2, 0);
  const std::int8_t* a = below != nullptr ? below : row;
  const std::int8_t* b = above != nullptr ? above : row;
  std::int8_t* column = scratch.data() + 1;
  for (std::size_t x = 0; x < n; ++x) column[x] = static_cast<std::int8_t>(a[x] | row[x] | b[x]);
  const std::int8_t* around = scratch.data();
  for (std::size_t x = 0; x < n; ++x) {
    const auto any = static_cast<std::int8_t>(around[x] | around[x + 1] | around[x + 2]);
    out[x] = static_cast<std::uint8_t>(static_cast<int>(any < 0) & static_cast<int>(row[x] >= 0) &
                                       static_cast<int>(row[x] < 50));
  }
}

void FrontierSearch::update(const OccupancyGrid& map, const CellRect& changed) {
  CellRect area = changed.grown(1).intersection(map.geometry().rect());
  if (map.geometry() != geometry_) {
    geometry_ = map.geometry();
    rows_.assign(static_cast<std::size_t>(map.height()), {});
    marks_.assign(static_cast<std::size_t>(map.width()) + 8, 0);
    cells_in_row_.assign(static_cast<std::size_t>(map.height()), 0);
    cell_count_ = 0;
    rows_kept_ = true;
    area = geometry_.rect();
  }
  searchRows(map, area);
  if (tooMany()) {
    rows_.assign(static_cast<std::size_t>(map.height()), {});
  } else if (!rows_kept_) {
    rows_kept_ = true;
    searchRows(map, geometry_.rect());
  }
}

bool FrontierSearch::tooMany() const { return cell_count_ > bounds::kMostFrontierCells; }

void FrontierSearch::searchRows(const OccupancyGrid& map, const CellRect& area) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    countRow(map, y);
    if (tooMany()) {
      rows_kept_ = false;
    } else {
      keepRow(rows_[static_cast<std::size_t>(y)], map.width());
    }
  }
}

void FrontierSearch::countRow(const OccupancyGrid& map, int y) {
  const int width = map.width();
  markFrontierCells(y > 0 ? map.row(y - 1) : nullptr, map.row(y), y + 1 < map.height() ? map.row(y + 1) : nullptr,
                    width, scratch_, marks_.data());
  std::size_t& cells = cells_in_row_[static_cast<std::size_t>(y)];
  cell_count_ -= cells;
  cells = std::accumulate(marks_.begin(), marks_.begin() + width, std::size_t{0});
  cell_count_ += cells;
}

/// Writes the runs of the row that was marked last to `spans`.
void FrontierSearch::keepRow(std::vector<Span>& spans, int width) const {
  spans.clear();
  int x = 0;
  while (x < width) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, marks_.data() + x, sizeof eight);  // eight cells at once: frontier cells are rare
    if (eight == 0) {
      x += 8;
      continue;
    }
    while (marks_[static_cast<std::size_t>(x)] == 0) ++x;
    if (x >= width) break;
    const int begin = x;
    while (x < width && marks_[static_cast<std::size_t>(x)] != 0) ++x;
    spans.push_back({begin, x});
  }
}

FrontierClusters FrontierSearch::clusters(int min_cells, int max_extent) const {
  FrontierClusters none;
  none.too_many = true;
  if (tooMany()) return none;
  std::vector<FrontierRun> runs;
  for (std::size_t y = 0; y < rows_.size(); ++y) {
    for (const Span& span : rows_[y]) runs.push_back({static_cast<int>(y), span.begin, span.end});
  }
  FrontierClusters all = detail::collectClusters(runs, detail::labelRuns(runs), min_cells, max_extent);
  return all.too_many ? none : all;
}

Cell anchorOf(const FrontierClusters& all, const FrontierCluster& cluster) {
  Cell best;
  double best_distance = -1.0;
  for (std::size_t i = cluster.first_run; i < cluster.first_run + cluster.run_count; ++i) {
    const FrontierRun& run = all.runs[i];
    const int x = std::clamp(static_cast<int>(std::lround(cluster.centroid.x())), run.begin, run.end - 1);
    const double distance = (Vec2(x, run.y) - cluster.centroid).squaredNorm();
    if (best_distance >= 0.0 && distance >= best_distance) continue;
    best = {x, run.y};
    best_distance = distance;
  }
  return best;
}

Cell cellOf(const FrontierClusters& all, const FrontierCluster& cluster, int k) {
  std::size_t i = cluster.first_run;
  while (k >= all.runs[i].end - all.runs[i].begin) {
    k -= all.runs[i].end - all.runs[i].begin;
    ++i;
  }
  return {all.runs[i].begin + k, all.runs[i].y};
}

}  // namespace frontier_pilot::exploration
