#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <list>

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// Searches for a keyframe in an old submap: finds the exact optimum in a window, refines it, and checks the result.
class LoopSearch {
 public:
  struct Result {
    ClosureVerdict verdict = ClosureVerdict::kNotFound;  ///< kAccepted: found, and every check passed
    scan_matching::PoseWithCovariance T_submap_keyframe;
  };

  explicit LoopSearch(const LoopSearchParameters& parameters = {}, const surfaces::SurfaceParameters& surface = {})
      : parameters_(parameters), surface_parameters_(surface) {}

  /// Searches around `expected`, a T_submap_keyframe. `points`: thinned, in the keyframe's base frame.
  Result find(const SubmapGraph& graph, std::size_t submap, const surfaces::SurfacePoints& points,
              const Pose2& expected, const scan_matching::SearchWindow& window);
  /// The points of a keyframe that are matched: thinned, in its base frame.
  surfaces::SurfacePoints pointsOf(const Keyframe& keyframe) const;
  /// Share of the points of a keyframe at `T_submap_keyframe` that are inconsistent with a submap: `inconsistentShare`.
  double contradiction(const SubmapGraph& graph, std::size_t submap, const surfaces::SurfacePoints& points,
                       const Pose2& T_submap_keyframe);

 private:
  /// A submap's map and pyramid for the search, built from its keyframes.
  struct Prepared {
    std::size_t submap;
    std::size_t keyframes;  ///< number of its keyframes in `map`: the newest submaps still grow
    scan_matching::SurfaceMap map;
    scan_matching::MaxPyramid pyramid;
  };

  const Prepared& prepare(const SubmapGraph& graph, std::size_t submap, int top);
  bool isAmbiguous(const scan_matching::MaxPyramid& pyramid, const surfaces::SurfacePoints& points,
                   scan_matching::SearchRequest request, const scan_matching::SearchResult& best,
                   const Eigen::Matrix3d& information) const;

  LoopSearchParameters parameters_;
  surfaces::SurfaceParameters surface_parameters_;
  std::list<Prepared> prepared_;  ///< the most recently used first
};

}  // namespace frontier_pilot::slam
