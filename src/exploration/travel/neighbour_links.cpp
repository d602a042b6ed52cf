#include "exploration/travel/neighbour_links.h"

#include <algorithm>
#include <vector>

namespace frontier_pilot::exploration {

void linkNeighbours(const Grid<std::uint8_t>& passable, const CellRect& window, Grid<std::uint8_t>& neighbours) {
  const int width = passable.width();
  const std::vector<std::uint8_t> nothing(static_cast<std::size_t>(width), 0);
  for (int y = window.y; y < window.y + window.height; ++y) {
    const std::uint8_t* south = y > 0 ? passable.row(y - 1) : nothing.data();
    const std::uint8_t* here = passable.row(y);
    const std::uint8_t* north = y + 1 < passable.height() ? passable.row(y + 1) : nothing.data();
    std::uint8_t* out = neighbours.row(y);
    const auto link = [&](int x, bool west, bool east) {
      const int bits = (east ? (here[x + 1] & 1) | (north[x + 1] & 2) | (south[x + 1] & 128) : 0) | (north[x] & 4) |
                       (west ? (north[x - 1] & 8) | (here[x - 1] & 16) | (south[x - 1] & 32) : 0) | (south[x] & 64);
      out[x] = static_cast<std::uint8_t>(bits & here[x]);
    };
    const int begin = std::max(window.x, 1);
    const int end = std::min(window.x + window.width, width - 1);
    if (window.x == 0) link(0, false, width > 1);
    for (int x = begin; x < end; ++x) link(x, true, true);
    if (window.x + window.width == width && width > 1) link(width - 1, true, false);
  }
}

}  // namespace frontier_pilot::exploration
