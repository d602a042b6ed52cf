#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// How far a robot has mapped, and how far it had when its map was saved last. Safe to use from several threads.
class MappedWay {
 public:
  /// A scan came into the map from there.
  void note(const Vec2& place);
  /// The way in steps, so that odometry and scan matching which are not quite still make none of a robot that stands.
  std::uint64_t steps() const;
  /// A map that holds so many steps was written at `at`.
  void noteSaved(std::uint64_t steps, SteadyTime at);
  /// Whether a map was saved ever.
  bool wasSaved() const;
  /// Whether the robot has mapped on since. What it has in a few seconds does not count: a map that is saved just
  /// before the end is the last one, although the robot still drives.
  bool hasGoneOn(SteadyTime now) const;

 private:
  struct Saved {
    std::uint64_t steps;
    SteadyTime at;
  };

  mutable std::mutex mutex_;
  std::optional<Vec2> begun_;  ///< where the present step began
  std::uint64_t steps_ = 0;
  std::optional<Saved> saved_;
};

}  // namespace frontier_pilot
