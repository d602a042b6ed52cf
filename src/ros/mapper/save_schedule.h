#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// When the copy of the map is to be written anew: when the map has changed, one save at a time, and so seldom that
/// saving takes a twentieth of the time at most, or a quarter while it fails. [FLT-2]
class SaveSchedule {
 public:
  /// Whether a map with this `content`, which counts its changes, is to be saved now.
  bool isDue(std::uint64_t content, SteadyTime now) const;
  void begin(std::uint64_t content, SteadyTime now);
  /// The save has ended that was begun last, at `at`, and took so long.
  void end(bool saved, SteadyTime at, Duration took);
  /// The copy, and one that is being written, are of no use any more: the next map is saved as soon as it can be.
  void discard();
  /// The next map that has changed is saved as soon as it can be, because it may be the last one.
  void hurry() { next_ = {}; }
  /// Whether the copy belongs to the map as it is, or to an earlier state of it.
  bool hasCopy() const { return has_copy_; }
  /// What is wrong when a save does not end; empty if nothing is.
  std::string delay(SteadyTime now) const;

 private:
  std::optional<SteadyTime> begun_;       ///< when the save began that has not ended
  SteadyTime next_{};                     ///< not before that
  std::optional<std::uint64_t> content_;  ///< of the map that was saved last, or is being saved
  bool has_copy_ = false;
};

}  // namespace frontier_pilot
