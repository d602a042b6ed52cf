#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "ros/common/memory_report.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/session_memory.h"
#include "ros/mapper/map_saver.h"

namespace frontier_pilot {

/// The map as it was when the mapper died, for the mapper that is started again in the same ROS session: saved again
/// and again under ROS_HOME, with the transform from odometry, until the mapper ends in order. At most three maps of
/// earlier sessions are kept. [FLT-2]
class MapAutosave {
 public:
  MapAutosave();

  /// Reads the map of a mapper that died and gives its T_map_odom; nothing if there is none. Throws std::runtime_error,
  /// saying why, if there is one that cannot be read.
  std::optional<Pose2> restore(occupancy::OccupancyMap& map) const;
  /// Saves `map` on the thread of `saver`. Nothing happens for a map that nothing was added to (`content` counts what
  /// was), while an earlier one is still being saved, and so that saving takes a twentieth of the time at most.
  void save(occupancy::OccupancyMap& map, const Pose2& T_map_odom, std::uint64_t content, MapSaver& saver);
  /// The map is another one, whatever its `content`.
  void replace();
  /// There is nothing to restore any more: the map was reset, or its mapper ends in order.
  void forget();
  /// The map that a mapper had when it died is lost. To be said until the map is reset or loaded, or has been made anew
  /// for a minute: an error that nothing mends would soon not be read any more.
  void lose(const std::string& why);
  /// What would be lost with this node, and what was with the one before it.
  void tell(MemoryReport& report) const;
  /// What kept the last one from being saved; empty if nothing did.
  const std::string& problem() const { return problem_; }
  /// From now on in another session of ROS, if this is one.
  void enter(const std::vector<std::string>& sessions);

 private:
  struct Saved {
    std::string problem;
    SteadyTime at;
    Duration took;
  };

  void noteMapping(std::uint64_t content, SteadyTime now);

  SessionMemory memory_;                       ///< holds T_map_odom; the map lies beside it
  std::shared_ptr<std::atomic<bool>> wanted_;  ///< whether what is being saved still is
  std::shared_ptr<Mailbox<Saved>> done_;
  bool saving_ = false;
  SteadyTime next_{};
  std::optional<std::uint64_t> saved_content_;
  std::string problem_;
  std::string loss_;                         ///< why the map before this one is lost
  std::optional<SteadyTime> mapping_since_;  ///< after that
};

}  // namespace frontier_pilot
