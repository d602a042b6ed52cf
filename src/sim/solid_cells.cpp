#include "sim/solid_cells.h"

#include <algorithm>

namespace frontier_pilot::sim {

Grid<std::uint8_t> solidCells(const OccupancyGrid& map, bool unknown_is_free) {
  GridGeometry framed = map.geometry();
  framed.origin -= Vec2(framed.resolution, framed.resolution);
  framed.width += 2;
  framed.height += 2;
  Grid<std::uint8_t> solid(framed, 1);
  for (int y = 0; y < map.height(); ++y) {
    std::transform(map.row(y), map.row(y) + map.width(), solid.row(y + 1) + 1, [=](std::int8_t value) {
      return static_cast<std::uint8_t>(isOccupied(value) || (isUnknown(value) && !unknown_is_free) ? 1 : 0);
    });
  }
  return solid;
}

}  // namespace frontier_pilot::sim
