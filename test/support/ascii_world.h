#pragma once

#include <map>
#include <string>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// A world drawn as text: '#' occupied, '.' or ' ' free, '?' unknown; any other character is a free cell with a mark
/// on it. The first line is the upper edge, so that the picture looks as rviz would show it.
struct AsciiWorld {
  OccupancyGrid map;
  std::map<char, std::vector<Cell>> marks;

  /// The first cell marked `mark`. Throws std::out_of_range if there is none.
  Cell cell(char mark) const { return marks.at(mark).front(); }
  /// The centre of that cell [m].
  Vec2 point(char mark) const { return map.geometry().centre(cell(mark)); }
  /// Non-zero where the drawing is occupied, and with `unknown_is_solid` where it is unknown.
  Grid<std::uint8_t> solid(bool unknown_is_solid = false) const;
};

/// Reads a drawing: lines are split at '\n', empty first and last lines and common indentation are dropped, short lines
/// end in unknown cells. Throws std::invalid_argument on an empty drawing.
AsciiWorld drawWorld(const std::string& drawing, double resolution = 0.05, const Vec2& origin = Vec2::Zero());

/// The drawing of a map, with `marks` on top of it, for failure messages.
std::string toAscii(const OccupancyGrid& map, const std::map<char, std::vector<Cell>>& marks = {});

}  // namespace frontier_pilot::test
