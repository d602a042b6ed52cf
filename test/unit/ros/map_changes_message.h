#pragma once

#include <frontier_pilot/MapChanges.h>

#include <string>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "ros/common/maps/run_lengths.h"
#include "ros/common/messages/conversions.h"
#include "support/ascii_world.h"

/// Messages of the topic `map_changes`, as a publisher sends them.
namespace frontier_pilot::test {

constexpr const char* kRoom = "#####\n#...#\n#...#\n#####";

inline MapChanges emptyChanges(const GridGeometry& geometry, std::uint32_t sequence, double seconds) {
  MapChanges msg;
  msg.header.frame_id = "map";
  msg.header.stamp = toRosTime(timeFromSeconds(seconds));
  msg.info = toMapMetaDataMsg(geometry);
  msg.sequence = sequence;
  return msg;
}

inline MapChanges wholeMap(const std::string& drawing, std::uint32_t sequence = 1, double seconds = 0.0) {
  const OccupancyGrid map = drawWorld(drawing).map;
  MapChanges msg = emptyChanges(map.geometry(), sequence, seconds);
  msg.whole = 1;
  RunWriter runs;
  runs.add(map.row(0), map.size());
  msg.runs = runs.take();
  return msg;
}

/// Adds a block whose cells all have the same value.
inline void addBlock(MapChanges& msg, const CellRect& rect, std::int8_t value) {
  MapBlock block;
  block.x = static_cast<std::uint16_t>(rect.x);
  block.y = static_cast<std::uint16_t>(rect.y);
  block.width = static_cast<std::uint16_t>(rect.width);
  block.height = static_cast<std::uint16_t>(rect.height);
  msg.blocks.push_back(block);
  const std::vector<std::int8_t> cells(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height),
                                       value);
  RunWriter runs;
  runs.add(cells.data(), cells.size());
  const std::vector<std::uint8_t> bytes = runs.take();
  msg.runs.insert(msg.runs.end(), bytes.begin(), bytes.end());
}

/// A block of the map that was drawn.
inline MapChanges changedBlock(const std::string& drawing, std::uint32_t sequence, const CellRect& rect,
                               std::int8_t value, double seconds = 0.0) {
  MapChanges msg = emptyChanges(drawWorld(drawing).map.geometry(), sequence, seconds);
  addBlock(msg, rect, value);
  return msg;
}

}  // namespace frontier_pilot::test
