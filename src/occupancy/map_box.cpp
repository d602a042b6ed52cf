// The box that the map fills: how it grows, and how far it may.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "occupancy/octree_file.h"

namespace frontier_pilot::occupancy {

CellRect OccupancyMap::kept() const { return isBlank() ? CellRect() : extent_; }

CellRect OccupancyMap::needed(const Vec2& low, const Vec2& high) const {
  GridGeometry frame;
  frame.resolution = parameters_.resolution;
  CellRect cells = kept();
  // One cell more on each side: a point on a border may be rounded to either cell.
  const Cell first = frame.cellAt(low);
  const Cell last = frame.cellAt(high);
  cells.include(Cell{first.x - 1, first.y - 1});
  cells.include(Cell{last.x + 1, last.y + 1});
  return cells;
}

MapRoom OccupancyMap::reserve(const Vec2& low, const Vec2& high) {
  // Far beyond any map, so that what follows cannot overflow; the comparison is also false for NaN.
  constexpr double kFar = 1e6;  // [m]
  const bool near = low.cwiseAbs().maxCoeff() < kFar && high.cwiseAbs().maxCoeff() < kFar;
  return near ? reserveCells(needed(low, high)) : MapRoom::kTooFar;
}

CellRect OccupancyMap::snapped(const CellRect& cells) const {
  const int step = std::max(1, static_cast<int>(std::lround(parameters_.growth_step / parameters_.resolution)));
  const CellRect block = grids::snap(cells, step);
  return roomAt(block) == MapRoom::kEnough ? block : cells;
}

MapRoom OccupancyMap::roomAt(const CellRect& cells) const {
  const int limit = std::min(bounds::kMostSide, static_cast<int>(parameters_.max_side / parameters_.resolution));
  if (cells.width > limit || cells.height > limit) return MapRoom::kTooLarge;
  constexpr int kHalf = kOctreeHalfSide;
  const bool is_in_reach = cells.intersection({-kHalf, -kHalf, 2 * kHalf, 2 * kHalf}) == cells;
  return is_in_reach ? MapRoom::kEnough : MapRoom::kTooFar;
}

std::string OccupancyMap::describe(MapRoom room) const {
  if (room == MapRoom::kEnough) return {};
  if (room == MapRoom::kTooLarge) return "is too large, see docs/limits.md";
  if (room == MapRoom::kNoMemory) return "needs more than max_memory of the map";
  std::ostringstream text;
  text << "lies farther than " << kOctreeHalfSide * parameters_.resolution << " m from the frame's origin";
  return text.str();
}

MapRoom OccupancyMap::reserveCells(const CellRect& cells) {
  if (cells == extent_) return MapRoom::kEnough;
  const CellRect grown = snapped(cells);
  const MapRoom room = roomAt(grown);
  if (room == MapRoom::kEnough) resize(grown);
  return room;
}

void OccupancyMap::resize(const CellRect& cells) {
  if (cells == extent_) return;
  geometry_.origin = Vec2(cells.x, cells.y) * parameters_.resolution;
  geometry_.width = cells.width;
  geometry_.height = cells.height;
  extent_ = cells;
  log_odds_.reserve(cells);
  scans_.reserve(cells);
  changes_ = {true, geometry_.rect()};
}

bool OccupancyMap::hasRoomFor(const OccupancyMap& other) const {
  CellRect cells = kept();
  cells.include(other.extent_);
  return cells == other.extent_ || roomAt(other.snapped(cells)) == MapRoom::kEnough;
}

}  // namespace frontier_pilot::occupancy
