#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::slam {

/// What became of an attempt to recognise a place.
enum class ClosureVerdict {
  kAccepted,     ///< it is in the graph
  kNotFound,     ///< the scan does not fit into the window well enough
  kPoor,         ///< found, but too few of its points lie on surfaces
  kAmbiguous,    ///< it fits elsewhere in the window nearly as well
  kUnconfirmed,  ///< too few keyframes near it said the same
  kDisagrees,    ///< with it the graph as a whole contradicts itself
  kContradicts,  ///< with it what was seen from where it moves contradicts the map
};
constexpr std::size_t kClosureVerdicts = 7;
const char* toString(ClosureVerdict verdict);

/// A place seen again: where a keyframe is, seen from an older submap.
struct LoopClosure {
  std::size_t keyframe = 0;
  std::size_t submap = 0;
  Pose2 T_submap_keyframe;
  Time keyframe_stamp;
  Time submap_stamp;  ///< when the keyframe was taken whose base is the submap's frame
};

/// How many attempts met each fate.
class ClosureCounts {
 public:
  void add(ClosureVerdict verdict, std::uint64_t times = 1) { counts_[static_cast<std::size_t>(verdict)] += times; }
  std::uint64_t operator[](ClosureVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }

 private:
  std::array<std::uint64_t, kClosureVerdicts> counts_{};
};

}  // namespace frontier_pilot::slam
