#include "exploration/tour/viewpoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "exploration/view_gain.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kWhole = 0.5;             ///< share of the area seen from the best viewpoint
constexpr double kWholeFromPresent = 0.3;  ///< the same for the viewpoint being driven to
constexpr double kLatticeStep = 0.6;       // [m]
constexpr double kLatticeRadius = 3.5;     // [m]: how far from a frontier viewpoints are looked for

/// The reached cell nearest to `node` within a square; `node` itself if there is none.
Cell reachedNear(Cell node, int reach, const TravelField& travel) {
  if (travel.reached(node) || !travel.anyReached(CellRect{node.x, node.y, 1, 1}.grown(reach))) return node;
  Cell best = node;
  int least = std::numeric_limits<int>::max();
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const int distance = dx * dx + dy * dy;
      if (distance >= least || !travel.reached({node.x + dx, node.y + dy})) continue;
      least = distance;
      best = {node.x + dx, node.y + dy};
    }
  }
  return best;
}

}  // namespace

std::vector<Viewpoint> ViewpointSearch::find(const FrontierEvaluator& evaluator,
                                             const std::vector<SoughtFrontier>& sought,
                                             const std::optional<Pose2>& present) {
  label(evaluator, sought);
  const GridGeometry& geometry = evaluator.map().geometry();
  const std::vector<Frontier>& frontiers = evaluator.frontiers();
  const auto present_cell = present ? std::optional<Cell>(geometry.cellAt(present->position())) : std::nullopt;
  std::vector<Viewpoint> all;
  most_.assign(frontiers.size(), 0.0);
  std::vector<bool> trusted(frontiers.size(), true);
  for (const SoughtFrontier& each : sought) trusted[each.index] = each.trusted;
  for (const Cell cell : sample(evaluator, sought, present_cell)) {
    std::vector<Sight> sights = sightsFrom(cell, evaluator);
    for (const Sight& sight : sights) most_[sight.frontier] = std::max(most_[sight.frontier], sight.area);
    if (!sights.empty()) all.push_back({cell, std::move(sights), {}});
  }
  for (Viewpoint& viewpoint : all) {
    const double share = viewpoint.cell == present_cell ? kWholeFromPresent : kWhole;
    const auto seenInPart = [&](const Sight& sight) {
      if (geometry.cellAt(frontiers[sight.frontier].goal) == viewpoint.cell) return false;
      return !trusted[sight.frontier] || sight.area < share * most_[sight.frontier];
    };
    auto& sights = viewpoint.sights;
    sights.erase(std::remove_if(sights.begin(), sights.end(), seenInPart), sights.end());
    viewpoint.look = lookFrom(viewpoint, evaluator);
  }
  all.erase(std::remove_if(all.begin(), all.end(), [](const Viewpoint& v) { return v.sights.empty(); }), all.end());
  addUnseen(evaluator, sought, all);
  return all;
}

/// A frontier that no ray happens to hit is seen from its own goal.
void ViewpointSearch::addUnseen(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought,
                                std::vector<Viewpoint>& all) {
  const std::vector<Frontier>& frontiers = evaluator.frontiers();
  std::vector<bool> seen(frontiers.size(), false);
  for (const Viewpoint& viewpoint : all) {
    for (const Sight& sight : viewpoint.sights) seen[sight.frontier] = true;
  }
  for (const SoughtFrontier& each : sought) {
    if (seen[each.index]) continue;
    const Frontier& frontier = frontiers[each.index];
    const ViewParameters& view = evaluator.view();
    const Look look{view.yawTowards(frontier.heading), view.allAround() ? kPi : 0.25 * view.field_of_view};
    all.push_back({evaluator.map().geometry().cellAt(frontier.goal), {{each.index, frontier.info.area}}, look});
  }
}

void ViewpointSearch::label(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought) {
  const GridGeometry& geometry = evaluator.map().geometry();
  if (labels_.geometry() != geometry) {
    labels_ = Grid<std::uint16_t>(geometry, 0);
    views_.clear();
  } else {
    for (const std::size_t index : labelled_) labels_[index] = 0;
  }
  labelled_.clear();
  const FrontierClusters& clusters = evaluator.clusters();
  sought_.clear();
  for (const SoughtFrontier& each : sought) {
    sought_.push_back(each.index);
    const FrontierCluster& cluster = clusters.clusters[each.index];
    for (std::size_t r = cluster.first_run; r < cluster.first_run + cluster.run_count; ++r) {
      const FrontierRun& run = clusters.runs[r];
      for (int x = run.begin; x < run.end; ++x) {
        labelled_.push_back(geometry.index({x, run.y}));
        labels_[labelled_.back()] = static_cast<std::uint16_t>(sought_.size());
      }
    }
  }
}

std::vector<Cell> ViewpointSearch::sample(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought,
                                          const std::optional<Cell>& present) const {
  const GridGeometry& geometry = evaluator.map().geometry();
  const TravelField& travel = evaluator.travel();
  const int step = std::max(1, static_cast<int>(std::lround(kLatticeStep / geometry.resolution)));
  const int radius = static_cast<int>(kLatticeRadius / geometry.resolution);
  std::vector<Cell> cells;
  std::unordered_set<std::size_t> known;
  const auto add = [&](Cell cell) {
    if (known.insert(geometry.index(cell)).second) cells.push_back(cell);
  };
  if (present && travel.reached(*present)) add(*present);
  GridGeometry lattice;
  lattice.width = geometry.width / step + 1;
  lattice.height = geometry.height / step + 1;
  std::vector<bool> visited(lattice.size(), false);
  for (const SoughtFrontier& each : sought) {
    const Frontier& frontier = evaluator.frontiers()[each.index];
    add(geometry.cellAt(frontier.goal));
    if (!each.trusted) continue;
    const CellRect box =
        CellRect{frontier.anchor.x, frontier.anchor.y, 1, 1}.grown(radius).intersection(geometry.rect());
    for (int y = (box.y + step - 1) / step * step; y < box.y + box.height; y += step) {
      for (int x = (box.x + step - 1) / step * step; x < box.x + box.width; x += step) {
        const std::size_t node = lattice.index({x / step, y / step});
        if (visited[node]) continue;
        visited[node] = true;
        const Cell cell = reachedNear({x, y}, step / 3, travel);
        if (evaluator.allowsGoal(cell)) add(cell);
      }
    }
  }
  return cells;
}

std::vector<Sight> ViewpointSearch::sightsFrom(Cell viewpoint, const FrontierEvaluator& evaluator) {
  std::vector<Sight> sights;
  for (const Glimpse& glimpse : views_.from(viewpoint, evaluator.map())) {
    const std::uint16_t label = labels_[glimpse.cell];
    if (label == 0) continue;
    const std::size_t frontier = sought_[label - 1U];
    const auto known =
        std::find_if(sights.begin(), sights.end(), [&](const Sight& sight) { return sight.frontier == frontier; });
    if (known == sights.end()) {
      sights.push_back({frontier, glimpse.area});
    } else {
      known->area += glimpse.area;
    }
  }
  return sights;
}

/// By the frontiers that the viewpoint shows whole: others must not make the robot face away from them.
Look ViewpointSearch::lookFrom(const Viewpoint& viewpoint, const FrontierEvaluator& evaluator) {
  if (evaluator.view().allAround()) return {};
  std::vector<Glimpse> whole;
  for (const Glimpse& glimpse : views_.from(viewpoint.cell, evaluator.map())) {
    const std::uint16_t label = labels_[glimpse.cell];
    const bool is_shown = std::any_of(viewpoint.sights.begin(), viewpoint.sights.end(), [&](const Sight& sight) {
      return label != 0 && sight.frontier == sought_[label - 1U];
    });
    if (is_shown) whole.push_back(glimpse);
  }
  return bestLook(whole, evaluator.view());
}

}  // namespace frontier_pilot::exploration
