#include "exploration/tour/frontier_views.h"

#include <algorithm>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::exploration {
namespace {

/// How far a view reaches [m]: beyond, the beams lie so far apart that they miss what is small.
double rangeOf(const ViewParameters& parameters) {
  constexpr double kFarthest = 5.0;
  return std::min(parameters.sensor_range, kFarthest);
}

}  // namespace

const std::vector<Glimpse>& FrontierViews::from(Cell viewpoint, const ObservedMap& map) {
  constexpr std::size_t kMostViews = 20000;
  constexpr double kTolerance = 0.05;  // share of the area that may have changed
  if (views_.size() > kMostViews) views_.clear();
  const double cell_area = map.geometry().resolution * map.geometry().resolution;
  const std::uint64_t changes = map.changesAround(map.geometry().centre(viewpoint), rangeOf(parameters_)) + 1;
  View& view = views_[map.geometry().index(viewpoint)];
  const double changed_area = static_cast<double>(changes - view.changes) * cell_area;
  if (view.changes == 0 || changed_area > kTolerance * view.area) {
    view.changes = changes;
    look(viewpoint, map, view);
  }
  return view.glimpses;
}

void FrontierViews::look(Cell viewpoint, const ObservedMap& map, View& view) const {
  view.glimpses.clear();
  view.area = 0.0;
  const OccupancyGrid& grid = map.grid();
  const Vec2 from = grid.geometry().centre(viewpoint);
  const double range = rangeOf(parameters_);
  for (int i = 0; i < parameters_.rays; ++i) {
    const Vec2 unit = direction(2.0 * kPi * i / parameters_.rays);
    Cell last_free = viewpoint;
    double first_unknown = -1.0, reached = 0.0, twice_area = 0.0;
    visitCells(grid.geometry(), from, from + range * unit, [&](Cell c) {
      const std::int8_t value = grid.get(c, kOccupied);
      if (isOccupied(value)) return false;
      const double along = std::clamp((grid.geometry().centre(c) - from).dot(unit), reached, range);
      if (first_unknown < 0.0 && isFree(value)) {
        last_free = c;
        reached = along;
        return true;
      }
      if (first_unknown < 0.0) first_unknown = along;
      if (isUnknown(value)) twice_area += along * along - reached * reached;
      reached = along;
      return along < first_unknown + parameters_.unknown_depth;
    });
    if (twice_area <= 0.0) continue;
    const auto area = static_cast<float>(twice_area * kPi / parameters_.rays);
    view.area += area;
    view.glimpses.push_back({static_cast<std::uint32_t>(grid.geometry().index(last_free)), area});
  }
}

}  // namespace frontier_pilot::exploration
