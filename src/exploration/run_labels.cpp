#include "exploration/run_labels.h"

#include <algorithm>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::exploration::detail {
namespace {

int cellsOf(const FrontierRun& run) { return run.end - run.begin; }

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/// The smaller index stays the root, so that labels do not depend on the order of joining.
void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t root_a = rootOf(parent, a);
  const std::uint32_t root_b = rootOf(parent, b);
  parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

bool touch(const FrontierRun& lower, const FrontierRun& upper) {
  return lower.y + 1 == upper.y && lower.begin <= upper.end && upper.begin <= lower.end;
}

void add(FrontierCluster& cluster, const FrontierRun& run) {
  const int n = cellsOf(run);
  cluster.centroid += n * Vec2(0.5 * (run.begin + run.end - 1), run.y);  // a sum until finish()
  cluster.cells += n;
  cluster.box.include(CellRect{run.begin, run.y, n, 1});
  ++cluster.run_count;
}

void finish(FrontierCluster& cluster, int component_cells) {
  cluster.centroid /= cluster.cells;
  cluster.component_cells = component_cells;
}

/// Appends one cluster made of `runs`.
void append(FrontierClusters& all, const std::vector<FrontierRun>& runs, int component_cells) {
  FrontierCluster cluster;
  cluster.first_run = all.runs.size();
  for (const FrontierRun& run : runs) add(cluster, run);
  finish(cluster, component_cells);
  all.runs.insert(all.runs.end(), runs.begin(), runs.end());
  all.clusters.push_back(cluster);
}

/// The part of `run` within columns [begin, end); empty where there is none.
FrontierRun cut(const FrontierRun& run, int begin, int end) {
  return {run.y, std::max(run.begin, begin), std::min(run.end, end)};
}

/// Appends the component in equal slabs across its longer side. Each run is visited once, however many slabs there are:
/// slab k begins at extent * k / slabs.
void appendSlabs(FrontierClusters& all, const std::vector<FrontierRun>& runs, const FrontierCluster& whole,
                 int max_extent) {
  const bool wide = whole.box.width >= whole.box.height;
  const int extent = wide ? whole.box.width : whole.box.height;
  const int slabs = (extent + max_extent - 1) / max_extent;
  const int origin = wide ? whole.box.x : whole.box.y;
  const auto slabOf = [&](int position) { return ((position - origin + 1) * slabs - 1) / extent; };
  const auto beginOf = [&](int slab) { return origin + extent * slab / slabs; };
  std::vector<std::vector<FrontierRun>> parts(static_cast<std::size_t>(slabs));
  for (const FrontierRun& run : runs) {
    const int first = slabOf(wide ? run.begin : run.y);
    const int last = wide ? slabOf(run.end - 1) : first;
    for (int k = first; k <= last; ++k) {
      parts[static_cast<std::size_t>(k)].push_back(wide ? cut(run, beginOf(k), beginOf(k + 1)) : run);
    }
  }
  for (const std::vector<FrontierRun>& slab : parts) {
    if (!slab.empty()) append(all, slab, whole.cells);
  }
}

/// Indices of the runs grouped by component, the components in the order of their first runs.
std::vector<std::uint32_t> orderByLabel(const std::vector<std::uint32_t>& labels) {
  std::vector<std::uint32_t> start(labels.size() + 1, 0);
  for (const std::uint32_t label : labels) ++start[label + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<std::uint32_t> order(labels.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) order[start[labels[i]]++] = i;
  return order;
}

}  // namespace

std::vector<std::uint32_t> labelRuns(const std::vector<FrontierRun>& runs) {
  std::vector<std::uint32_t> parent(runs.size());
  std::uint32_t below = 0;  // the first run of the row below that can still touch
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    parent[i] = i;
    while (below < i &&
           (runs[below].y + 1 < runs[i].y || (runs[below].y + 1 == runs[i].y && runs[below].end < runs[i].begin))) {
      ++below;
    }
    for (std::uint32_t j = below; j < i && touch(runs[j], runs[i]); ++j) join(parent, j, i);
  }
  for (std::uint32_t i = 0; i < runs.size(); ++i) parent[i] = rootOf(parent, i);
  return parent;
}

FrontierClusters collectClusters(const std::vector<FrontierRun>& runs, const std::vector<std::uint32_t>& labels,
                                 int min_cells, int max_extent) {
  FrontierClusters all;
  all.runs.reserve(runs.size());
  const std::vector<std::uint32_t> order = orderByLabel(labels);
  std::vector<FrontierRun> component;
  for (std::size_t i = 0; i < order.size();) {
    component.clear();
    FrontierCluster whole;
    const std::uint32_t label = labels[order[i]];
    for (; i < order.size() && labels[order[i]] == label; ++i) {
      component.push_back(runs[order[i]]);
      add(whole, component.back());
    }
    if (whole.cells < min_cells) continue;
    const bool is_long = max_extent > 0 && std::max(whole.box.width, whole.box.height) > max_extent;
    if (is_long) {
      appendSlabs(all, component, whole, max_extent);
    } else {
      append(all, component, whole.cells);
    }
    all.too_many = all.clusters.size() > bounds::kMostFrontiers;
    if (all.too_many) break;
  }
  return all;
}

}  // namespace frontier_pilot::exploration::detail
