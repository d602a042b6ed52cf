#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Which robots fleet_stop stops, by the names of their services: the listed ones for ever, and others until an hour
/// after they were seen last. Each costs a thread and a question to the master every half second. [MUL-4]
class KnownRobots {
 public:
  void list(const std::string& service) { seen_[service] = std::nullopt; }
  /// To be called while the robot is connected or the master knows its arbiter.
  void see(const std::string& service, SteadyTime now);
  /// Those that have not been seen for an hour, which are not known from now on.
  std::vector<std::string> forget(SteadyTime now);

 private:
  std::map<std::string, std::optional<SteadyTime>> seen_;  ///< when each was seen last; never asked of a listed one
};

}  // namespace frontier_pilot
