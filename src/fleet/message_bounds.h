#pragma once

#include <cstddef>
#include <string>

#include "frontier_pilot/core/geometry.h"

/// What a message of another robot may contain: what sizes or reaches more than that is refused.
namespace frontier_pilot::fleet {

constexpr std::size_t kMostHeard = 100;  ///< robots that are remembered
constexpr std::size_t kLongestName = 256;
constexpr double kFarthest = 1e6;       ///< coordinate of a place [m]
constexpr double kLongestValid = 60.0;  ///< for how long a message counts [s]

inline bool isPlace(const Vec2& place) { return place.allFinite() && place.cwiseAbs().maxCoeff() <= kFarthest; }
inline bool isName(const std::string& name) { return !name.empty() && name.size() <= kLongestName; }

}  // namespace frontier_pilot::fleet
