#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::slam {

/// The result of an attempt to close a loop.
enum class ClosureVerdict {
  kAccepted,     ///< the closure is in the graph
  kNotFound,     ///< no pose in the window scores well enough, or the best one lies on its border
  kPoor,         ///< found, but with too few inliers, or the refinement moved it too far
  kAmbiguous,    ///< another pose in the window scores nearly as well
  kUnconfirmed,  ///< too few other keyframes had matches that agree with it
  kDisagrees,    ///< with it, the optimised graph has a closure whose error is too large
  kContradicts,  ///< with it, the scans of moved keyframes are less consistent with the map
};
constexpr std::size_t kClosureVerdicts = 7;
const char* toString(ClosureVerdict verdict);

/// A loop closure: the pose of a keyframe relative to an older submap.
struct LoopClosure {
  std::size_t keyframe = 0;
  std::size_t submap = 0;
  Pose2 T_submap_keyframe;
  Time keyframe_stamp;
  Time submap_stamp;  ///< of the submap's first keyframe, whose base frame is the submap's frame
};

/// The number of attempts by verdict.
class ClosureCounts {
 public:
  void add(ClosureVerdict verdict, std::uint64_t times = 1) { counts_[static_cast<std::size_t>(verdict)] += times; }
  std::uint64_t operator[](ClosureVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }

 private:
  std::array<std::uint64_t, kClosureVerdicts> counts_{};
};

}  // namespace frontier_pilot::slam
