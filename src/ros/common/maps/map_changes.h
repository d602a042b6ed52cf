#pragma once

#include <frontier_pilot/MapChanges.h>

#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// A message that was checked completely: its geometry and its blocks are within bounds, the blocks lie in the map, and
/// its runs are exactly their cells. Nothing was decoded for that, so what memory the message may cost is known before
/// any is used. [FLT-1]
class CheckedMapChanges {
 public:
  /// Nothing if the message is malformed; `why` then says what is wrong. `msg` must outlive the result.
  static std::optional<CheckedMapChanges> check(const MapChanges& msg, std::string* why);

  bool isWhole() const { return msg_.whole != 0; }
  const GridGeometry& geometry() const { return geometry_; }
  /// The map, if it is whole.
  OccupancyGrid whole() const;
  /// Writes the cells of the blocks into `map`, which must have this geometry, and returns the bounds of those whose
  /// values were others.
  CellRect applyTo(OccupancyGrid& map) const;

 private:
  CheckedMapChanges(const MapChanges& msg, const GridGeometry& geometry) : msg_(msg), geometry_(geometry) {}

  const MapChanges& msg_;
  GridGeometry geometry_;
};

}  // namespace frontier_pilot
