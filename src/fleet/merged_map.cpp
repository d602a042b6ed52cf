#include "frontier_pilot/fleet/merged_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fleet/clear_space.h"
#include "fleet/lattice.h"
#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/grids/growing_grid.h"

namespace frontier_pilot::fleet {
namespace {

constexpr int kStep = 32;  ///< the extent of a rotated source ends at multiples of this [cells]

/// std::floor is a call where the compiler may not assume SSE 4.1.
int floorOf(double value) {
  const int whole = static_cast<int>(value);
  return whole - (value < whole ? 1 : 0);
}

bool alignedWith(const GridGeometry& lattice, const GridGeometry& grid, const Pose2& T_lattice_grid) {
  return std::abs(T_lattice_grid.yaw) < 1e-9 &&
         isWhole(offset(lattice, grid) + T_lattice_grid.position() / lattice.resolution);
}

/// The cells of `lattice` whose centres may lie in the cells `cells` of `grid`.
CellRect boxAround(const GridGeometry& lattice, const GridGeometry& grid, const Pose2& T_lattice_grid,
                   const CellRect& cells) {
  if (cells.empty()) return {};
  const int right = cells.x + cells.width - 1;
  const int top = cells.y + cells.height - 1;
  CellRect box;
  for (const Cell corner : {Cell{cells.x, cells.y}, Cell{right, cells.y}, Cell{cells.x, top}, Cell{right, top}}) {
    box.include(lattice.cellAt(T_lattice_grid * grid.centre(corner)));
  }
  return alignedWith(lattice, grid, T_lattice_grid) ? box : box.grown(1);
}

/// `map` in another geometry of the same cells: what lies in both is kept, all else is unknown.
OccupancyGrid moved(const OccupancyGrid& map, const GridGeometry& geometry) {
  const Cell shift = rounded(offset(geometry, map.geometry()));
  const CellRect kept = CellRect{shift.x, shift.y, map.width(), map.height()}.intersection(geometry.rect());
  OccupancyGrid result(geometry, kUnknown);
  for (int y = kept.y; y < kept.y + kept.height; ++y) {
    std::copy_n(map.row(y - shift.y) + (kept.x - shift.x), kept.width, result.row(y) + kept.x);
  }
  return result;
}

}  // namespace

Cell MergedMap::Sampler::at(double x, double y) const {
  return {floorOf(origin.x() + x_axis.x() * x - x_axis.y() * y), floorOf(origin.y() + x_axis.y() * x + x_axis.x() * y)};
}

SourceResult MergedMap::setSource(std::size_t index, const OccupancyGrid& grid, const CellRect& changed,
                                  const Pose2& T_target_source) {
  const auto known = sources_.find(index);
  const bool is_new = known == sources_.end() || known->second.geometry != grid.geometry();
  return setSourceParts(index, grid, {is_new ? grid.geometry().rect() : changed}, T_target_source);
}

SourceResult MergedMap::setSourceParts(std::size_t index, const OccupancyGrid& grid,
                                       const std::vector<CellRect>& changed, const Pose2& T_target_source) {
  const Source source{&grid, grid.geometry(), T_target_source};
  const auto known = sources_.find(index);
  const bool stays = known != sources_.end() && known->second.T_target_source == T_target_source;
  if (!stays || known->second.left_out || !placeOfOld(known->second.geometry, source.geometry))
    return replace(index, source);
  if (known->second.geometry == source.geometry) {
    known->second.grid = &grid;
    samplers_[static_cast<std::size_t>(std::distance(sources_.begin(), known))].grid = &grid;
  } else {
    Sources sources = sources_;
    sources[index] = source;
    if (tooLarge(sources)) return replace(index, source);
    if (!adopt(std::move(sources))) redraw(map_.geometry().rect());
  }
  for (const CellRect& part : changed) redraw(footprint(source, part.intersection(source.geometry.rect())));
  return SourceResult::kTaken;
}

SourceResult MergedMap::replace(std::size_t index, const Source& source) {
  Sources sources = sources_;
  sources.erase(index);
  const bool same_cells = sources.empty() || sameResolution(sources.begin()->second.geometry, source.geometry);
  sources[index] = source;
  const SourceResult result = !same_cells         ? SourceResult::kOtherResolution
                              : tooLarge(sources) ? SourceResult::kTooLarge
                                                  : SourceResult::kTaken;
  if (result != SourceResult::kTaken) sources.erase(index);
  rearrange(std::move(sources), index);
  return result;
}

void MergedMap::removeSource(std::size_t index) {
  if (!hasSource(index)) return;
  Sources sources = sources_;
  sources.erase(index);
  rearrange(std::move(sources), index);
}

bool MergedMap::tooLarge(const Sources& sources) {
  const auto reaches_too_far = [](const Vec2& point) {
    return !bounds::isWithin(point.cwiseAbs().maxCoeff(), bounds::kMostCoordinate);
  };
  for (const auto& [index, source] : sources) {
    if (reaches_too_far(source.geometry.origin) || reaches_too_far(source.T_target_source.position())) return true;
  }
  const GridGeometry extent = extentOf(sources);
  return extent.width > bounds::kMostSide || extent.height > bounds::kMostSide || extent.size() > bounds::kMostMapCells;
}

GridGeometry MergedMap::extentOf(const Sources& sources) {
  GridGeometry geometry;
  if (sources.empty()) return geometry;
  const auto& [index, first] = *sources.begin();
  geometry.resolution = first.geometry.resolution;
  if (index == 0 && first.T_target_source == Pose2()) geometry.origin = first.geometry.origin;
  CellRect extent;
  for (const auto& [other, source] : sources) {
    const CellRect box = boxAround(geometry, source.geometry, source.T_target_source, source.geometry.rect());
    extent.include(alignedWith(geometry, source.geometry, source.T_target_source) ? box : grids::snap(box, kStep));
  }
  geometry.origin += Vec2(extent.x, extent.y) * geometry.resolution;
  geometry.width = extent.width;
  geometry.height = extent.height;
  return geometry;
}

bool MergedMap::adopt(Sources sources) {
  sources_ = std::move(sources);
  const GridGeometry geometry = extentOf(sources_);
  const bool same_cells = sameResolution(map_.geometry(), geometry) && isWhole(offset(map_.geometry(), geometry));
  if (geometry != map_.geometry()) {
    map_ = same_cells ? moved(map_, geometry) : OccupancyGrid(geometry, kUnknown);
    changed_ = geometry.rect();
  }
  makeSamplers();
  return same_cells;
}

void MergedMap::rearrange(Sources sources, std::size_t index) {
  const Sources earlier = sources_;
  const bool same_cells = adopt(std::move(sources));
  const CellRect before = shareOf(earlier, index);
  const CellRect now = same_cells ? shareOf(sources_, index) : map_.geometry().rect();
  redraw(now);
  if (!(before.intersection(now) == before)) redraw(before);
}

void MergedMap::makeSamplers() {
  samplers_.clear();
  const GridGeometry& target = map_.geometry();
  for (const auto& [index, source] : sources_) {
    const GridGeometry& geometry = source.geometry;
    const Pose2 T_source_target = source.T_target_source.inverse();
    samplers_.push_back(
        {source.grid, geometry, true, (T_source_target * target.origin - geometry.origin) / geometry.resolution,
         direction(T_source_target.yaw), alignedWith(target, geometry, source.T_target_source), index == 0});
  }
}

CellRect MergedMap::footprint(const Source& source, const CellRect& cells) const {
  if (cells.empty()) return {};
  const CellRect affected = cells.grown(clearanceCells(source.geometry.resolution));
  return boxAround(map_.geometry(), source.geometry, source.T_target_source, affected);
}

CellRect MergedMap::shareOf(const Sources& sources, std::size_t index) const {
  const auto source = sources.find(index);
  if (source == sources.end()) return {};
  return footprint(source->second, source->second.geometry.rect()).intersection(map_.geometry().rect());
}

CellRect MergedMap::takeChanged() { return std::exchange(changed_, CellRect{}); }

void MergedMap::redraw(const CellRect& cells) {
  auto source = sources_.begin();
  for (Sampler& sampler : samplers_) {
    sampler.current = sampler.grid->geometry() == sampler.geometry;
    if (!sampler.current) source->second.left_out = true;
    ++source;
  }
  const CellRect area = cells.intersection(map_.geometry().rect());
  for (int y = area.y; y < area.y + area.height; ++y) {
    int first = area.x + area.width;
    int last = area.x - 1;
    for (int x = area.x; x < area.x + area.width; ++x) {
      std::int8_t& cell = map_[Cell{x, y}];
      const std::int8_t value = combined({x, y});
      if (cell == value) continue;
      cell = value;
      first = std::min(first, x);
      last = x;
    }
    changed_.include(CellRect{first, y, last - first + 1, 1});
  }
}

std::int8_t MergedMap::combined(Cell cell) const {
  std::int8_t lowest = kOccupied;
  std::int8_t highest = kUnknown;
  for (const Sampler& source : samplers_) {
    const std::int8_t value = source.current ? source.value(cell) : kUnknown;
    if (isUnknown(value)) continue;
    if (first_ == FirstSource::kPrevails && source.is_first) return value;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  if (isUnknown(highest)) return touchesWall(cell) ? kOccupied : kUnknown;
  const bool disputed = isFree(lowest) && isOccupied(highest);
  return disputed && provedFree(cell) ? lowest : highest;
}

bool MergedMap::provedFree(Cell cell) const {
  return std::any_of(samplers_.begin(), samplers_.end(), [cell](const Sampler& source) {
    return source.current && isClearAround(*source.grid, source.at(cell.x + 0.5, cell.y + 0.5));
  });
}

bool MergedMap::touchesWall(Cell cell) const {
  constexpr double kAlmost = 1.0 - 1e-6;
  for (const Sampler& source : samplers_) {
    if (source.aligned || !source.current) continue;
    for (const Vec2& corner : {Vec2(0.0, 0.0), Vec2(kAlmost, 0.0), Vec2(0.0, kAlmost), Vec2(kAlmost, kAlmost)}) {
      if (isOccupied(source.grid->get(source.at(cell.x + corner.x(), cell.y + corner.y()), kUnknown))) return true;
    }
  }
  return false;
}

}  // namespace frontier_pilot::fleet
