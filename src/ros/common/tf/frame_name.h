#pragma once

#include <algorithm>
#include <string>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {

/// The frame without leading slashes. Drivers of the time of tf1 write "/laser"; tf2 takes that for "laser" in
/// transforms, and refuses it in a lookup.
inline std::string plain(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

inline bool isSameFrame(const std::string& a, const std::string& b) { return plain(a) == plain(b); }

/// What is wrong with the name of a frame that no transform can lead to, because it is too long; empty if nothing is.
inline std::string problemOfFrameName(const std::string& frame) {
  if (frame.size() <= bounds::kMostName) return "";
  return "the name of the frame has more than " + std::to_string(bounds::kMostName) + " characters";
}

}  // namespace frontier_pilot
