#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/surfaces/surface_points.h"

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

/// A loop closure: a keyframe was recognised in an older submap. Its pose is given relative to that keyframe of the
/// submap which is nearest to it, because what the submap has bent since then matters least there.
struct LoopClosure {
  std::size_t keyframe = 0;
  std::size_t submap = 0;
  std::size_t reference = 0;  ///< the nearest keyframe of the submap
  Pose2 T_reference_keyframe;
  Time keyframe_stamp;
  Time reference_stamp;
};

/// The number of attempts by verdict.
class ClosureCounts {
 public:
  void add(ClosureVerdict verdict, std::uint64_t times = 1) { counts_[static_cast<std::size_t>(verdict)] += times; }
  std::uint64_t operator[](ClosureVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }

 private:
  std::array<std::uint64_t, kClosureVerdicts> counts_{};
};

/// The robot's pose when a keyframe was taken: by odometry, and in the map as currently estimated.
struct KeyframePose {
  Time stamp;
  Pose2 T_odom_base;
  Pose2 T_map_base;
};

/// The result of correcting the pose of a scan.
struct CorrectedScan {
  Pose2 T_map_odom;       ///< pose of the odometry frame in the map when the scan was taken
  bool fits_map = true;   ///< false: the scan does not fit the map and must not be inserted
  const char* text = "";  ///< for diagnostics: how the pose was found
  bool sound = true;      ///< false: the operator should be told `text`
  bool located = true;    ///< false: the robot is not where it is on a known map, because the scan fits nowhere there
};

/// Changes to past poses and to the map: the result of RevisionWork.
struct MapRevision {
  std::uint64_t epoch = 0;  ///< number of the mapper's corrector when the work was taken; void if there is another now
  std::uint64_t generation = 0;  ///< number of its resets and abandoned works then; void if there are more now
  Pose2 T_new_old;               ///< left-multiplies `T_map_odom` and the poses of scans inserted meanwhile
  std::optional<occupancy::OccupancyMap> map;  ///< the map, rendered again; none if no pose moved enough
  std::vector<LoopClosure> closures;           ///< new ones. Without any, `T_new_old` is the identity.
  ClosureCounts counts;                        ///< of the attempts made
  std::size_t left_out = 0;                    ///< number of keyframes that `map` lacks: it would have become too large
};

/// Computes a revision. It shares no data with its mapper, so another thread may run it, but only once.
using RevisionWork = std::function<MapRevision()>;

/// The stage between odometry and the map: gives for each scan the pose of the odometry frame in the map.
/// Revisions of past poses are computed by whoever calls `takeWork`, in the background or at once.
class PoseCorrection {
 public:
  virtual ~PoseCorrection() = default;
  /// For a scan taken at `T_odom_base`; `map` is what is known so far, without this scan.
  virtual CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                                const occupancy::OccupancyMap& map) = 0;
  /// A motion by odometry, in the base frame of its start, without the systematic errors that are known of odometry.
  virtual Pose2 withoutErrors(const Pose2& motion) const { return motion; }
  /// The work to be done next, if any; none until the result of the last one was handed to `accept` or `refuse`, or the
  /// work was abandoned.
  virtual RevisionWork takeWork() { return {}; }
  /// Takes over the result of the work: from now on the poses that `correct` gives include it. Returns false, and does
  /// nothing, when it is void.
  virtual bool accept(const MapRevision&) { return false; }
  /// Refuses a revision whose map cannot be taken over: poses stay as they are until a later revision brings a map,
  /// which then includes the changes of this one. Returns false, and does nothing, when the revision is void.
  virtual bool refuse(const MapRevision&) { return false; }
  /// The work taken last threw and may have left an inconsistent state: nothing is revised until a reset.
  virtual void abandonWork() {}
  /// The keyframes so far, if it keeps any. Must not be called while work is under way.
  virtual std::vector<KeyframePose> trajectory() const { return {}; }
  /// How many keyframes it keeps.
  virtual std::size_t keyframes() const { return 0; }
  /// Forgets everything: the map has been reset.
  virtual void reset() = 0;
};

}  // namespace frontier_pilot::slam
