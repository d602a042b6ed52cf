#include "map_files/grid_drawing.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::map_files {
namespace {

/// How many updates by `step` take a cell's log-odds from 0 to `limit`.
int timesUntil(float limit, float step) { return static_cast<int>(std::ceil(limit / step)); }

CellRect knownCells(const OccupancyGrid& image) {
  CellRect known;
  for (std::size_t k = 0; k < image.size(); ++k) {
    if (image[k] != kUnknown) known.include(image.geometry().cell(k));
  }
  return known;
}

}  // namespace

std::string draw(const OccupancyGrid& image, occupancy::OccupancyMap& map) {
  const GridGeometry& from = image.geometry();
  // Without what is unknown around it, so that a map does not grow each time that its picture is edited and loaded. One
  // cell more on each side, because of rounding.
  const CellRect box = knownCells(image).grown(1);
  const Vec2 low = from.centre({box.x, box.y}), high = from.centre({box.x + box.width - 1, box.y + box.height - 1});
  const occupancy::MapRoom room = map.reserve(low, high);
  if (room != occupancy::MapRoom::kEnough) return map.describe(room);
  // One shift in whole cells for all: converting each centre would round those near a border between cells either way.
  const Vec2 shift = (from.origin - map.geometry().origin) / from.resolution;
  const auto dx = static_cast<int>(std::lround(shift.x()));
  const auto dy = static_cast<int>(std::lround(shift.y()));
  const occupancy::LogOddsModel model(map.parameters().model);
  const int times = std::max(timesUntil(model.max, model.hit), timesUntil(model.min, model.miss));
  for (int i = 0; i < times; ++i) {
    map.beginScan();
    for (std::size_t k = 0; k < image.size(); ++k) {
      const Cell cell{from.cell(k).x + dx, from.cell(k).y + dy};
      if (frontier_pilot::isOccupied(image[k])) map.hit(cell);
      if (isFree(image[k])) map.miss(cell);
    }
  }
  return map.describe(map.isFull() ? occupancy::MapRoom::kNoMemory : occupancy::MapRoom::kEnough);
}

}  // namespace frontier_pilot::map_files
