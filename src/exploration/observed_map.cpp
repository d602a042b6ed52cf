#include "exploration/observed_map.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace frontier_pilot::exploration {
namespace {

int classOf(std::int8_t value) { return isUnknown(value) ? 0 : (isFree(value) ? 1 : 2); }

/// Where the first cell of `old` lies in `geometry`; nothing if the cells do not lie on each other, or are all others.
std::optional<Cell> placeIn(const GridGeometry& geometry, const GridGeometry& old) {
  constexpr double kOnEachOther = 0.01;  // [cells]
  if (old.resolution != geometry.resolution) return std::nullopt;
  const Vec2 offset = (old.origin - geometry.origin) / geometry.resolution;
  const Vec2 whole = offset.array().round().matrix();
  const auto sizes = [](const GridGeometry& g) { return Vec2(g.width, g.height); };
  const bool overlap = (offset + sizes(old)).minCoeff() > 0.5 && (sizes(geometry) - offset).minCoeff() > 0.5;
  if (!overlap || (offset - whole).cwiseAbs().maxCoeff() > kOnEachOther) return std::nullopt;
  return Cell{static_cast<int>(whole.x()), static_cast<int>(whole.y())};
}

/// A grid of `geometry` with the cells of `old`, whose first one comes to `at`, that fit in; all others are `fill`.
template <class T>
Grid<T> moved(const Grid<T>& old, const GridGeometry& geometry, Cell at, T fill) {
  Grid<T> grid(geometry, fill);
  const CellRect common = CellRect{at.x, at.y, old.width(), old.height()}.intersection(geometry.rect());
  for (int y = common.y; y < common.y + common.height; ++y) {
    std::copy_n(old.row(y - at.y) + (common.x - at.x), common.width, grid.row(y) + common.x);
  }
  return grid;
}

}  // namespace

CellRect ObservedMap::update(const OccupancyGrid& map, const CellRect& changed) {
  const bool is_new = map_.geometry() != map.geometry() || map_.empty();
  if (is_new) moveTo(map.geometry());
  const CellRect area = is_new ? map.geometry().rect() : changed.intersection(map.geometry().rect());
  CellRect differing;
  for (int y = area.y; y < area.y + area.height; ++y) updateRow(map, y, area.x, area.x + area.width, differing);
  return is_new ? area : differing;
}

void ObservedMap::setBounds(const ExplorationBounds& bounds) {
  allowed_.setBounds(bounds);
  allowed_.cover(map_.geometry());
}

/// Keeps what is known of the cells that both geometries have, and how often they have changed.
void ObservedMap::moveTo(const GridGeometry& geometry) {
  const std::optional<Cell> kept = map_.empty() ? std::nullopt : placeIn(geometry, map_.geometry());
  const Cell at = kept.value_or(Cell{});
  const Cell corner = kept ? Cell{withinTile(corner_.x - at.x), withinTile(corner_.y - at.y)} : Cell{};
  GridGeometry tiles;
  tiles.width = (geometry.width + corner.x) / kTile + 1;
  tiles.height = (geometry.height + corner.y) / kTile + 1;
  const Cell first{(at.x + corner.x - corner_.x) / kTile, (at.y + corner.y - corner_.y) / kTile};
  tiles_ = kept ? moved(tiles_, tiles, first, 0U) : Grid<std::uint32_t>(tiles, 0U);
  map_ = kept ? moved(map_, geometry, at, kUnknown) : OccupancyGrid(geometry, kUnknown);
  corner_ = corner;
  if (!kept) ++restarts_;
  ++changes_;
  free_cells_ = static_cast<std::uint64_t>(std::count_if(map_.cells().begin(), map_.cells().end(), isFree));
  allowed_.cover(geometry);
}

void ObservedMap::updateRow(const OccupancyGrid& map, int y, int begin, int end, CellRect& differing) {
  const std::int8_t* theirs = allowed_.shown(map.row(y), y, begin, end);
  std::int8_t* ours = map_.row(y);
  for (int x = begin; x < end;) {
    const int n = std::min(64, end - x);
    if (std::memcmp(theirs + x, ours + x, static_cast<std::size_t>(n)) == 0) {
      x += n;
      continue;
    }
    for (const int stop = x + n; x < stop; ++x) {
      if (theirs[x] != ours[x]) updateCell({x, y}, theirs[x], differing);
    }
  }
}

void ObservedMap::updateCell(Cell c, std::int8_t value, CellRect& differing) {
  const int before = classOf(map_[c]);
  const int after = classOf(value);
  map_[c] = value;
  if (before == after) return;
  free_cells_ += static_cast<std::uint64_t>(after == 1);
  free_cells_ -= static_cast<std::uint64_t>(before == 1);
  ++changes_;
  ++tiles_[tileOf(c)];
  differing.include(c);
}

double ObservedMap::freeArea() const {
  return static_cast<double>(free_cells_) * map_.resolution() * map_.resolution();
}

std::uint64_t ObservedMap::changesAround(const Vec2& point, double radius) const {
  if (map_.empty()) return 0;
  // Slightly less, so that a square that ends where a cell does holds the same cells whatever the map's origin is.
  const double half_side = radius - 0.01 * map_.resolution();
  const Cell low = geometry().cellAt(point - Vec2(half_side, half_side));
  const Cell high = geometry().cellAt(point + Vec2(half_side, half_side));
  const Cell from = tileOf({std::max(low.x, 0), std::max(low.y, 0)});
  const Cell to = tileOf({std::min(high.x, map_.width() - 1), std::min(high.y, map_.height() - 1)});
  std::uint64_t sum = 0;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) sum += tiles_[Cell{x, y}];
  }
  return sum;
}

}  // namespace frontier_pilot::exploration
