#pragma once

#include <frontier_pilot/ArbiterStatus.h>

#include <algorithm>
#include <optional>
#include <string>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {

/// The arbiter's source that takes its commands from `topic`, a whole name; null if it has none. Its name is what the
/// arbiter's configuration calls it.
inline const ArbiterSource* findSource(const ArbiterStatus& status, const std::string& topic) {
  const auto found = std::find_if(status.sources.begin(), status.sources.end(),
                                  [&topic](const ArbiterSource& source) { return source.topic == topic; });
  return found == status.sources.end() ? nullptr : &*found;
}

/// The source that drives, if that is not the one whose commands come from `topic`. That one is called `name` if the
/// status lists none with this topic.
inline std::optional<std::string> findOtherDriver(const ArbiterStatus& status, const std::string& topic,
                                                  const std::string& name) {
  const ArbiterSource* own = findSource(status, topic);
  const bool is_own = status.active_source == (own != nullptr ? own->name : name);
  if (status.state != ArbiterStatus::DRIVING || is_own) return std::nullopt;
  return status.active_source.substr(0, bounds::kMostName);
}

}  // namespace frontier_pilot
