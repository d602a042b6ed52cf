#pragma once

#include <cstddef>
#include <optional>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::mapping {

struct MapScheduleParameters {
  double min_period = 1.0;  ///< between two whole maps, at least [s]
  double max_period = 5.0;  ///< changes wait for a whole map this long, 12 times that while there are few [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("min_period", min_period, "s", "between two whole maps, at least", timeSpan());
    v.field("max_period", max_period, "s", "changes wait for a whole map this long, 12 times that while there are few",
            timeSpan());
  }
};

/// Says when the whole of a map is to be sent, besides the changes that are sent at once: when it has grown, when
/// somebody new listens, when what was sent as changes since the last one comes to as much; after a while when it comes
/// to an eighth, or when there have been no more for as long; and never later than 12 times that. So all in all
/// publishing costs what changed, and the map once a minute. [MAP-2]
class MapSchedule {
 public:
  explicit MapSchedule(const MapScheduleParameters& parameters = {}) : parameters_(parameters) {}

  /// Notes what has changed. Gives whether it can be sent as a change: it cannot when the map has grown since the last
  /// whole one, and goes out with the next.
  bool note(const occupancy::MapChanges& changes, Time now);
  /// Somebody has begun to listen, who knows nothing yet.
  void noteNewcomer() { newcomer_ = true; }
  /// Whether a map of `cells` cells is to be sent now.
  bool isDue(std::size_t cells, Time now) const;
  /// The whole map was sent. Gives whether it had grown.
  bool sent(Time now);
  /// Nobody knows anything any more.
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
