#pragma once

#include <ros/console.h>

#include "frontier_pilot/core/time.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

/// Tells the waiting of every start from a fault: a node is up before those whose messages it needs, so that for its
/// first seconds it logs as INFO what it logs as WARN afterwards.
class StartGrace {
 public:
  static constexpr Duration kLength = std::chrono::seconds(10);  ///< enough for a start on a busy computer

  explicit StartGrace(SteadyTime start = steadyNow()) : start_(start) {}

  /// The level at which to log that something is still missing.
  ros::console::Level level(SteadyTime now) const {
    return now - start_ < kLength ? ros::console::levels::Info : ros::console::levels::Warn;
  }

 private:
  SteadyTime start_;
};

}  // namespace frontier_pilot
