#pragma once

#include <cstddef>
#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::mapping {

/// Decides when the whole map is sent, in addition to the changes, which are sent at once. It is due if none was sent
/// yet or the clock was set back; or, at least `min_period` after the last one, if the map has grown, or if cells were
/// sent as changes since then and one of these holds:
///  - a new subscriber has come;
///  - as many cells were sent as changes as the map has;
///  - `max_period` has passed since the last whole map, and either as many cells were sent as changes as an eighth of
///    the map has, or the last change was `max_period` ago;
///  - 12 times `max_period` has passed since the last whole map.
/// The cost of publishing is thus proportional to what changed, plus one map a minute. [MAP-2]
class MapSchedule {
 public:
  explicit MapSchedule(const MapScheduleParameters& parameters = {}) : parameters_(parameters) {}

  /// Notes what has changed. Returns whether there is anything that can be sent as a change: after the map has grown
  /// there is not, and changes go out with the next whole map.
  bool note(const occupancy::MapChanges& changes, Time now);
  /// A new subscriber has come, which has the last whole map, but not the changes since.
  void noteNewcomer() { newcomer_ = true; }
  /// Whether a map of `cells` cells is to be sent now.
  bool isDue(std::size_t cells, Time now) const;
  /// The whole map was sent. Returns whether it had grown since the one before.
  bool sent(Time now);
  /// Forgets what was sent.
  void reset() { *this = MapSchedule(parameters_); }

 private:
  MapScheduleParameters parameters_;
  std::optional<Time> last_;  ///< when the whole map was sent last
  Time last_change_;          ///< when something was last sent as a change
  bool grown_ = true;         ///< its geometry has changed since then, so cell indices have too
  std::size_t changed_ = 0;   ///< how many cells were sent as changes since then
  bool newcomer_ = false;     ///< a subscriber has come since then
};

}  // namespace frontier_pilot::mapping
