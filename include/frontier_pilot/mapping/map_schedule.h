#pragma once

#include <cstddef>
#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::mapping {

/// Says when the whole map is to be sent, besides the changes, which are sent at once. It is due when
///  - the map has grown, or a new subscriber has come;
///  - as many cells were sent as changes since the last whole map as the map has;
///  - `max_period` has passed since the last whole map, and either an eighth of its cells were sent as changes or there
///    were no changes for another `max_period`;
///  - 12 times `max_period` has passed and anything has changed.
/// The cost of publishing is thus proportional to what changed, plus one map a minute. [MAP-2]
class MapSchedule {
 public:
  explicit MapSchedule(const MapScheduleParameters& parameters = {}) : parameters_(parameters) {}

  /// Notes what has changed. Gives whether it can be sent as a change: it cannot when the map has grown since the last
  /// whole one, and goes out with the next.
  bool note(const occupancy::MapChanges& changes, Time now);
  /// A new subscriber has come, who has no map yet.
  void noteNewcomer() { newcomer_ = true; }
  /// Whether a map of `cells` cells is to be sent now.
  bool isDue(std::size_t cells, Time now) const;
  /// The whole map was sent. Gives whether it had grown.
  bool sent(Time now);
  /// Forgets what was sent.
  void reset() { *this = MapSchedule(parameters_); }

 private:
  MapScheduleParameters parameters_;
  std::optional<Time> last_;  ///< when the whole map was sent last
  Time last_change_;          ///< when there was a change last
  bool grown_ = true;         ///< since then its geometry has changed: changes would not fit
  std::size_t changed_ = 0;   ///< how many cells were sent as changes since then
  bool newcomer_ = false;     ///< somebody has begun to listen since then
};

}  // namespace frontier_pilot::mapping
