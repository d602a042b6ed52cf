#include "exploration/observed_map.h"

#include <algorithm>
#include <cstring>

namespace frontier_pilot::exploration {
namespace {

int classOf(std::int8_t value) { return isUnknown(value) ? 0 : (isFree(value) ? 1 : 2); }

}  // namespace

CellRect ObservedMap::update(const OccupancyGrid& map, const CellRect& changed) {
  CellRect area = changed.intersection(map.geometry().rect());
  if (map_.geometry() != map.geometry() || map_.empty()) {
    restart(map.geometry());
    area = map.geometry().rect();
  }
  CellRect differing;
  for (int y = area.y; y < area.y + area.height; ++y) updateRow(map, y, area.x, area.x + area.width, differing);
  return differing;
}

void ObservedMap::setBounds(const ExplorationBounds& bounds) {
  allowed_.setBounds(bounds);
  allowed_.cover(map_.geometry());
}

void ObservedMap::restart(const GridGeometry& geometry) {
  map_ = OccupancyGrid(geometry, kUnknown);
  const auto tiles = [](int cells) { return static_cast<std::size_t>(cells / kTile) + 1; };
  tiles_per_row_ = tiles(geometry.width);
  tiles_.assign(tiles_per_row_ * tiles(geometry.height), 0);
  free_cells_ = 0;
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
  ++tile(c);
  differing.include(c);
}

double ObservedMap::freeArea() const {
  return static_cast<double>(free_cells_) * map_.resolution() * map_.resolution();
}

std::uint64_t ObservedMap::changesAround(const Vec2& point, double radius) const {
  const Cell low = geometry().cellAt(point - Vec2(radius, radius));
  const Cell high = geometry().cellAt(point + Vec2(radius, radius));
  std::uint64_t sum = 0;
  for (int ty = std::max(low.y, 0) / kTile; ty <= std::min(high.y, map_.height() - 1) / kTile; ++ty) {
    for (int tx = std::max(low.x, 0) / kTile; tx <= std::min(high.x, map_.width() - 1) / kTile; ++tx) {
      sum += tiles_[static_cast<std::size_t>(ty) * tiles_per_row_ + static_cast<std::size_t>(tx)];
    }
  }
  return sum;
}

}  // namespace frontier_pilot::exploration
