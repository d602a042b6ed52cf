#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "slam/back_end/loop_search.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// Closes loops: searches for each keyframe in the old submaps that it may lie in, in a window given by the graph's
/// covariance. Matches become closures when those of several keyframes agree and the map stays consistent. A missing
/// closure costs some accuracy, a false one destroys the map: doubtful matches are not accepted.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserParameters& parameters = {}, const surfaces::SurfaceParameters& surface = {});

  /// Searches for the newest keyframe of `graph`; `points` are its thinned points. Returns the closures that this has
  /// confirmed; the graph has then been optimised with them.
  std::vector<LoopClosure> update(SubmapGraph& graph, const surfaces::SurfacePoints& points);

  /// The number of attempts so far, by verdict.
  const ClosureCounts& counts() const { return counts_; }
  /// Goes on from the counts of another one.
  void setCounts(const ClosureCounts& counts) { counts_ = counts; }

 private:
  /// A match: waiting for others that agree with it or, if `certain`, accepted already and able to confirm others.
  struct Hypothesis {
    std::size_t keyframe = 0;
    std::size_t submap = 0;
    std::size_t of = 0;  ///< the newest submap, which the keyframe is in
    scan_matching::PoseWithCovariance T_submap_keyframe;
    bool certain = false;
  };
  struct Candidate {
    std::size_t submap = 0;
    double distance = 0.0;  ///< to the submap's nearest keyframe, less the half width of the window [m]
    scan_matching::SearchWindow window;
  };

  std::vector<Candidate> candidates(const SubmapGraph& graph) const;
  scan_matching::SearchWindow windowFor(const Eigen::Matrix3d& covariance) const;
  bool isSaturated(const SubmapGraph& graph, std::size_t submap, std::size_t of) const;
  bool agree(const SubmapGraph& graph, const Hypothesis& a, const Hypothesis& b) const;
  void forget(std::size_t newest);
  std::vector<std::size_t> confirmed(const SubmapGraph& graph) const;
  std::vector<std::size_t> supporters(const SubmapGraph& graph, const Hypothesis& hypothesis) const;
  bool isEnough(const SubmapGraph& graph, const Hypothesis& hypothesis,
                const std::vector<std::size_t>& supporters) const;
  /// Whether the sampled keyframes, which were at `then` in `before`, are now about as consistent with the rest of the
  /// map as they were.
  bool makesSense(const SubmapGraph& graph, const PoseGraph& before, const std::vector<Pose2>& then);
  static LoopClosure closureOf(const SubmapGraph& graph, const Hypothesis& hypothesis);
  std::vector<LoopClosure> accept(SubmapGraph& graph, const std::vector<std::size_t>& chosen);

  LoopCloserParameters parameters_;
  LoopSearch search_;
  std::vector<Hypothesis> hypotheses_;
  ClosureCounts counts_;
};

}  // namespace frontier_pilot::slam
