#include "exploration/tour/frontier_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  drawRays(map.geometry().resolution);
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

void FrontierViews::drawRays(double resolution) {
  if (resolution == resolution_) return;
  resolution_ = resolution;
  GridGeometry geometry;
  geometry.resolution = resolution;
  const Vec2 from = geometry.centre({0, 0});
  const double range = rangeOf(parameters_);
  rays_.assign(static_cast<std::size_t>(parameters_.rays), {});
  for (int i = 0; i < parameters_.rays; ++i) {
    const Vec2 unit = direction(2.0 * kPi * i / parameters_.rays);
    double reached = 0.0;
    visitCells(geometry, from, from + range * unit, [&](Cell c) {
      reached = std::clamp((geometry.centre(c) - from).dot(unit), reached, range);
      rays_[static_cast<std::size_t>(i)].push_back(
          {static_cast<std::int16_t>(c.x), static_cast<std::int16_t>(c.y), static_cast<float>(reached)});
      return true;
    });
  }
}

void FrontierViews::look(Cell viewpoint, const ObservedMap& map, View& view) const {
  const OccupancyGrid& grid = map.grid();
  const int reach = static_cast<int>(rangeOf(parameters_) / grid.resolution()) + 1;
  const CellRect box = CellRect{viewpoint.x, viewpoint.y, 1, 1}.grown(reach);
  if (box.intersection(grid.geometry().rect()) == box) {  // the usual case, in which no cell can lie outside of the map
    const std::int8_t* from = &grid[viewpoint];
    const int width = grid.width();
    look(viewpoint, map, view, [=](const RayCell& at) { return from[at.y * width + at.x]; });
  } else {
    look(viewpoint, map, view, [&](const RayCell& at) {
      return grid.get({viewpoint.x + at.x, viewpoint.y + at.y}, kOccupied);
    });
  }
}

template <class ValueAt>
void FrontierViews::look(Cell viewpoint, const ObservedMap& map, View& view, ValueAt value_at) const {
  view.glimpses.clear();
  view.area = 0.0;
  for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
    RayCell last_free;
    const auto twice_area_per_radian = unknownAlong(rays_[ray], value_at, last_free);
    if (twice_area_per_radian <= 0.0F) continue;
    const auto area = static_cast<float>(twice_area_per_radian * kPi / parameters_.rays);
    const Cell seen_through{viewpoint.x + last_free.x, viewpoint.y + last_free.y};
    view.area += area;
    const auto cell = static_cast<std::uint32_t>(map.geometry().index(seen_through));
    view.glimpses.push_back({cell, area, static_cast<std::uint16_t>(ray)});
  }
}

/// Twice the unknown area per radian along a ray [m^2], up to `unknown_depth` behind the first unknown cell;
/// `last_free` is the last known one before that.
template <class ValueAt>
float FrontierViews::unknownAlong(const std::vector<RayCell>& ray, ValueAt value_at, RayCell& last_free) const {
  const auto depth = static_cast<float>(parameters_.unknown_depth);
  float end = std::numeric_limits<float>::infinity();
  float reached = 0.0F, twice_area = 0.0F;
  for (const RayCell& at : ray) {
    const std::int8_t value = value_at(at);
    if (isOccupied(value)) break;
    if (isUnknown(value)) {
      end = std::min(end, at.along + depth);
      twice_area += at.along * at.along - reached * reached;
    } else if (std::isinf(end)) {
      last_free = at;
    }
    reached = at.along;
    if (reached >= end) break;
  }
  return twice_area;
}

}  // namespace frontier_pilot::exploration
