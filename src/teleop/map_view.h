#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

/// What the operator's window shows on the map, as plain data without ROS or Qt, in the frame of the map.
namespace frontier_pilot::teleop {

/// New values of a block of cells.
struct MapChange {
  GridGeometry geometry;  ///< of the whole map; if it is another one than before, the block is all of it
  CellRect rect;
  std::vector<std::int8_t> cells;  ///< those of `rect` row by row, as in OccupancyGrid
};

/// What is drawn over the cells. A part of which nothing is known is empty.
struct MapScene {
  std::string frame;           ///< of the map; empty: there is no map yet
  std::uint32_t replaced = 0;  ///< how often another map has come in place of the one of before
  std::string problem;         ///< what is missing or was refused, in words; empty: nothing
  std::optional<Pose2> T_map_base;
  std::optional<Pose2> goal;         ///< of the navigation
  std::vector<Vec2> plan;            ///< of the navigation
  std::vector<Vec2> frontier_cells;  ///< their centres; of very many only some
};

/// What a link hands over at once.
struct MapView {
  std::optional<MapChange> change;  ///< since the view before
  MapScene scene;
};

}  // namespace frontier_pilot::teleop
