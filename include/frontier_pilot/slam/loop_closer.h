#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/slam/loop_closure.h"
#include "frontier_pilot/slam/loop_search.h"
#include "frontier_pilot/slam/submap_graph.h"

namespace frontier_pilot::slam {

struct LoopCloserParameters {
  int min_gap = 3;                  ///< least number of submaps between the newest one and one that is recognised
  double reach = 4.0;               ///< greatest distance to a submap's keyframes, less half the window [m]
  double sigmas = 3.0;              ///< half width of the search window, in standard deviations
  double min_window = 0.4;          ///< least half width of the window [m]
  double max_window = 8.0;          ///< greatest half width of the window [m]
  double min_angle = 0.1;           ///< least half angle of the window [rad]
  double max_angle = 0.8;           ///< greatest half angle of the window [rad]
  double known_position = 0.05;     ///< no search where the standard deviation of the position is less [m],
  double known_yaw = 0.01;          ///< and that of the yaw is less [rad]
  int max_candidates = 2;           ///< greatest number of submaps searched for each keyframe
  int max_per_pair = 3;             ///< greatest number of closures between the same two submaps
  int confirmations = 3;            ///< number of keyframes whose matches must agree
  double confirm_travel = 0.5;      ///< least distance from the keyframe to the farthest that agrees [m]
  double confirm_jump = 1.0;        ///< added to that distance for each metre that the robot would jump [m/m]
  double confirm_share = 0.5;       ///< least share of the keyframes between them whose matches agree
  int confirm_within = 40;          ///< age at which a match is dropped that nothing has confirmed [keyframes]
  double verify_jump = 0.1;         ///< closures that move the robot farther are checked against the map [m]
  double max_inconsistency = 0.03;  ///< greatest increase of the share of beams that contradict the map
  double agree_distance = 0.2;      ///< two matches agree when their positions differ by no more [m],
  double agree_angle = 0.04;        ///< and their yaws by no more [rad]
  LoopSearchParameters search;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_gap",        "reach",          "sigmas",        "min_window",     "max_window",   "min_angle",
             "max_angle",      "known_position", "known_yaw",     "max_candidates", "max_per_pair", "confirmations",
             "confirm_travel", "confirm_jump",   "confirm_share", "confirm_within", "verify_jump",  "max_contradiction",
             "agree_distance", "agree_angle"});
    v.group("search", search, "the search for one keyframe in one submap");
  }
};

/// Closes loops: searches for each keyframe in the old submaps that it may lie in, in a window given by the graph's
/// covariance. A match becomes a closure when those of several keyframes agree and the map stays consistent. A missing
/// closure costs some accuracy, a false one destroys the map: in doubt there is none.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserParameters& parameters = {});

  /// Looks for the newest keyframe of `graph`, of which `points` are the thinned ones. Gives the closures that have
  /// become certain by that; the graph has then moved.
  std::vector<LoopClosure> update(SubmapGraph& graph, const surfaces::SurfacePoints& points);

  /// The attempts so far.
  const ClosureCounts& counts() const { return counts_; }

 private:
  /// A match that waits for others that agree with it, or, once certain, is one of those others.
  struct Hypothesis {
    std::size_t keyframe = 0;
    std::size_t submap = 0;
    std::size_t of = 0;  ///< the submap that the keyframe is in
    scan_matching::PoseWithCovariance T_submap_keyframe;
    bool certain = false;
  };
  struct Candidate {
    std::size_t submap = 0;
    double distance = 0.0;  ///< from where the robot may be to where it was [m]
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
  std::vector<LoopClosure> accept(SubmapGraph& graph, const std::vector<std::size_t>& chosen);

  LoopCloserParameters parameters_;
  LoopSearch search_;
  std::vector<Hypothesis> hypotheses_;
  ClosureCounts counts_;
};

}  // namespace frontier_pilot::slam
