#include "exploration/frontier_search.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "exploration/run_labels.h"
#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::exploration {
namespace {

constexpr int kMarksAtOnce = 8;  ///< that are looked at when the runs of a row are collected

}  // namespace

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
    marks_.assign(static_cast<std::size_t>(map.width()) + kMarksAtOnce, 0);
    cells_in_row_.assign(static_cast<std::size_t>(map.height()), 0);
    cell_count_ = 0;
    rows_kept_ = true;
    area = geometry_.rect();
  }
  if (!rows_kept_) {  // what a row holds outside of the area is not known
    area.x = 0;
    area.width = map.width();
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
    countRow(map, y, {area.x, area.x + area.width});
    if (tooMany()) {
      rows_kept_ = false;
    } else {
      keepRow(rows_[static_cast<std::size_t>(y)], {area.x, area.x + area.width});
    }
  }
}

/// Marks the frontier cells of a row within `columns`, and clears the marks beside them, which `keepRow` reads.
void FrontierSearch::countRow(const OccupancyGrid& map, int y, const Span& columns) {
  const int begin = std::max(columns.begin - 1, 0);  // one more column on either side, for the neighbours
  const int end = std::min(columns.end + 1, map.width());
  const auto rowAt = [&](int row) { return row >= 0 && row < map.height() ? map.row(row) + begin : nullptr; };
  std::uint8_t* marks = marks_.data();
  markFrontierCells(rowAt(y - 1), rowAt(y), rowAt(y + 1), end - begin, scratch_, marks + begin);
  std::fill(marks + begin, marks + columns.begin, std::uint8_t{0});
  std::fill_n(marks + columns.end, kMarksAtOnce, std::uint8_t{0});
  const std::size_t found = std::accumulate(marks + columns.begin, marks + columns.end, std::size_t{0});
  std::size_t& cells = cells_in_row_[static_cast<std::size_t>(y)];
  cell_count_ -= cells;
  cells = columns.end - columns.begin == map.width()
              ? found
              : cells + found - cellsWithin(rows_[static_cast<std::size_t>(y)], columns);
  cell_count_ += cells;
}

std::size_t FrontierSearch::cellsWithin(const std::vector<Span>& spans, const Span& columns) {
  int cells = 0;
  for (const Span& span : spans) {
    cells += std::max(0, std::min(span.end, columns.end) - std::max(span.begin, columns.begin));
  }
  return static_cast<std::size_t>(cells);
}

/// Replaces the runs of the row that was marked last within `columns`.
void FrontierSearch::keepRow(std::vector<Span>& spans, const Span& columns) {
  spans_.clear();
  const auto add = [this](int begin, int end) {
    if (begin >= end) return;
    if (!spans_.empty() && spans_.back().end == begin) {
      spans_.back().end = end;
    } else {
      spans_.push_back({begin, end});
    }
  };
  for (const Span& span : spans) add(span.begin, std::min(span.end, columns.begin));
  int x = columns.begin;
  while (x < columns.end) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, marks_.data() + x, sizeof eight);  // frontier cells are rare
    if (eight == 0) {
      x += kMarksAtOnce;
      continue;
    }
    while (marks_[static_cast<std::size_t>(x)] == 0) ++x;
    if (x >= columns.end) break;
    const int begin = x;
    while (x < columns.end && marks_[static_cast<std::size_t>(x)] != 0) ++x;
    add(begin, x);
  }
  for (const Span& span : spans) add(std::max(span.begin, columns.end), span.end);
  spans.assign(spans_.begin(), spans_.end());
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
