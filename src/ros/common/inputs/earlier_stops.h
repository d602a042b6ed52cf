#pragma once

#include <cstdint>
#include <optional>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Whether the robot was stopped while a node was not there to hear of it. Such a stop may have been cleared since, and
/// then only the count of stops in the arbiter's status tells of it. [ARB-8] [FLT-2]
class EarlierStops {
 public:
  /// Asks for stops beyond the `known` ones. Until the answer, but no longer than `patience`, the node holds back.
  void ask(std::uint64_t known, Duration patience, SteadyTime now);
  /// Nothing is asked any more: whoever drives the robot now knows whether it was stopped.
  void dismiss() { asked_.reset(); }

  /// A message of the emergency stop came: no later one can be missed any more.
  void hear() { hears_ = true; }
  bool hears() const { return hears_; }
  /// The count of stops in a status of the arbiter. The answer is whether there were any; there is none if nothing is
  /// asked, or if a stop may still be missed after this count.
  std::optional<bool> take(std::uint64_t stops);

  bool asks() const { return asked_.has_value(); }
  bool holdsBack(SteadyTime now) const { return asked_ && now - *asked_ < patience_; }

 private:
  std::optional<SteadyTime> asked_;  ///< since when
  std::uint64_t known_ = 0;
  Duration patience_{};
  bool hears_ = false;
};

}  // namespace frontier_pilot
