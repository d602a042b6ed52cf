#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/slam/loop_closure.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::slam {

/// Where the robot was when a keyframe was taken, by odometry and by what is known now.
struct KeyframePose {
  Time stamp;
  Pose2 T_odom_base;
  Pose2 T_map_base;
};

/// What is thought of a scan.
struct CorrectedScan {
  Pose2 T_map_odom;       ///< where odometry's frame lay in the map when it was taken
  bool fits_map = true;   ///< false: it belongs elsewhere, and would only smear the map
  const char* text = "";  ///< for diagnostics: how the pose was found
  bool sound = true;      ///< false: that is worth the operator's attention
};

/// A revision of the past.
struct MapRevision {
  std::uint64_t epoch = 0;       ///< of the mapper that the work was taken from: another map makes it void
  std::uint64_t generation = 0;  ///< of the corrector that the work was taken from: a reset makes it void
  Pose2 T_new_old;               ///< takes what was put into the map since the work was taken to its place now
  std::optional<occupancy::OccupancyMap> map;  ///< the map, rendered again; none where nothing moved enough to be seen
  std::vector<LoopClosure> closures;           ///< new ones. Without any `T_new_old` is the identity.
  ClosureCounts counts;                        ///< of the attempts made
  std::size_t left_out = 0;                    ///< keyframes that `map` lacks, because it would have become too large
};

/// The work of revising the past. It shares nothing with its mapper: another thread may run it, once.
using RevisionWork = std::function<MapRevision()>;

/// The stage between odometry and the map: says where odometry's frame lies in the map when a scan was taken.
/// Revisions of the past are worked out by whoever calls `takeWork`, in the background or at once.
class PoseCorrection {
 public:
  virtual ~PoseCorrection() = default;
  /// For a scan taken at `T_odom_base`; `map` is what is known so far, without this scan.
  virtual CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                                const occupancy::OccupancyMap& map) = 0;
  /// Work that should be done, if any; none until the last one's result was handed to `accept` or `refuse`, or the work
  /// abandoned.
  virtual RevisionWork takeWork() { return {}; }
  /// Takes over what the work came to: from now on `correct` says where things are after it. False, and nothing
  /// happens, when it is void.
  virtual bool accept(const MapRevision&) { return false; }
  /// The map that the work came to cannot be taken over: poses stay as they are, and nothing moves before a later
  /// revision brings a map, which then stands for this one too. False, and nothing happens, when the revision is void.
  virtual bool refuse(const MapRevision&) { return false; }
  /// The work taken last threw, and may have left anything behind: nothing is revised until a reset.
  virtual void abandonWork() {}
  /// The keyframes so far, if it keeps any. Not while work is out.
  virtual std::vector<KeyframePose> trajectory() const { return {}; }
  /// Forgets everything: the map has been reset.
  virtual void reset() = 0;
};

/// Takes odometry for the truth: `map` and `odom` are the same frame.
class TrustOdometry final : public PoseCorrection {
 public:
  CorrectedScan correct(const surfaces::SurfaceScan&, const Pose2&, const occupancy::OccupancyMap&) override {
    return {Pose2(), true, "odometry taken as given"};
  }
  void reset() override {}
};

}  // namespace frontier_pilot::slam
