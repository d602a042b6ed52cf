#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/maps/block_changes.h"

namespace frontier_pilot {

/// Publishes a map in few bytes beside `map` and `map_updates`, on the map's topic with `_changes`: whole to begin
/// with, then the blocks that have changed. [MAP-2] [MUL-1]
///
/// The whole map goes to everybody when a subscriber has come, at once after the map has grown, and once a minute, for
/// whom a message was lost. Large maps are sent whole less often, so that a tenth of a core is enough for them; until
/// then no changes are sent. Without subscribers this costs nothing.
class MapChangesPublisher {
 public:
  /// Gives a copy of the cells in a part of the map.
  using CellsIn = std::function<OccupancyGrid(const CellRect&)>;

  /// `map` is the topic of the map.
  void advertise(ros::NodeHandle& node, const std::string& map, const std::string& frame);
  void withdraw() { *this = {}; }
  /// `changed` are the bounds of the cells that have changed since the last call. The map must not be empty.
  void publish(const GridGeometry& geometry, const CellRect& changed, const CellsIn& cells_in, Time now);

 private:
  bool mayBeWhole(const GridGeometry& geometry, Time now) const;
  void publishWhole(const GridGeometry& geometry, const CellsIn& cells_in, Time now);
  void publishBlocks(const CellRect& changed, const CellsIn& cells_in, Time now);

  ros::Publisher publisher_;
  std::string frame_;
  BlockChanges sent_;      ///< of the map that the subscribers have
  bool complete_ = false;  ///< whether all subscribers have it
  Time last_whole_{};      ///< when it was last sent whole
  std::uint32_t sequence_ = 0;
};

}  // namespace frontier_pilot
