#include "ros/common/maps/map_changes.h"

#include <algorithm>
#include <vector>

#include "ros/common/maps/run_lengths.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

CellRect rectOf(const MapBlock& block) { return {block.x, block.y, block.width, block.height}; }

/// What is wrong with the blocks and the runs; empty if nothing is.
std::string problemOf(const MapChanges& msg, const GridGeometry& geometry) {
  if (geometry.size() == 0) return "map empty";
  if (msg.whole != 0 && !msg.blocks.empty()) return "blocks in a whole map";
  std::size_t cells = msg.whole != 0 ? geometry.size() : 0;
  for (const MapBlock& block : msg.blocks) {
    const CellRect rect = rectOf(block);
    if (rect.empty()) return "block empty";
    if (!(rect.intersection(geometry.rect()) == rect)) return "block reaches beyond the map";
    cells += static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
    if (cells > geometry.size()) return "blocks of more cells than the map has";
  }
  if (countCells(msg.runs, cells) != cells) return "runs malformed, or not as many cells as the blocks have";
  return {};
}

/// Writes the `count` new values over the old ones of a row that begins at `x`, `y`, and adds those that differ.
void copyRow(const std::int8_t* values, std::int8_t* row, int count, Cell begin, CellRect& changed) {
  const auto first = std::mismatch(values, values + count, row).first - values;
  if (first == count) return;
  auto last = static_cast<std::ptrdiff_t>(count) - 1;
  while (values[last] == row[last]) --last;
  changed.include({begin.x + static_cast<int>(first), begin.y, static_cast<int>(last - first) + 1, 1});
  std::copy_n(values, count, row);
}

}  // namespace

std::optional<CheckedMapChanges> CheckedMapChanges::check(const MapChanges& msg, std::string* why) {
  const auto geometry = toGridGeometry(msg.info, why);
  if (!geometry) return std::nullopt;
  const std::string problem = problemOf(msg, *geometry);
  if (problem.empty()) return CheckedMapChanges(msg, *geometry);
  if (why != nullptr) *why = problem;
  return std::nullopt;
}

OccupancyGrid CheckedMapChanges::whole() const {
  OccupancyGrid map(geometry_);
  RunReader(msg_.runs).read(map.row(0), map.size());
  return map;
}

CellRect CheckedMapChanges::applyTo(OccupancyGrid& map) const {
  CellRect changed;
  RunReader reader(msg_.runs);
  std::vector<std::int8_t> values(static_cast<std::size_t>(geometry_.width));
  for (const MapBlock& block : msg_.blocks) {
    const CellRect rect = rectOf(block);
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      reader.read(values.data(), static_cast<std::size_t>(rect.width));
      copyRow(values.data(), map.row(y) + rect.x, rect.width, {rect.x, y}, changed);
    }
  }
  return changed;
}

}  // namespace frontier_pilot
