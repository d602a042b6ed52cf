#pragma once

#include <algorithm>
#include <string>

namespace frontier_pilot {

/// The frame without leading slashes. Drivers of the time of tf1 write "/laser"; tf2 takes that for "laser" in
/// transforms, and refuses it in a lookup.
inline std::string plain(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

inline bool isSameFrame(const std::string& a, const std::string& b) { return plain(a) == plain(b); }

}  // namespace frontier_pilot
