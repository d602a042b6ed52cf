#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/slam/loop_closure.h"
#include "frontier_pilot/slam/loop_search.h"
#include "frontier_pilot/slam/submap_graph.h"

namespace frontier_pilot::slam {

struct LoopCloserParameters {
  int min_gap = 3;                  ///< submaps that must have begun since the one that is recognised
  double reach = 4.0;               ///< a submap that the robot came this near is worth a look [m]
  double sigmas = 3.0;              ///< the window holds so many standard deviations
  double min_window = 0.4;          ///< its least half width [m]
  double max_window = 8.0;          ///< its greatest [m]
  double min_angle = 0.1;           ///< its least half angle [rad]
  double max_angle = 0.8;           ///< its greatest [rad]
  double known_position = 0.05;     ///< a submap is not looked for where it is known this well [m]
  double known_yaw = 0.01;          ///< and this well [rad]
  int max_candidates = 2;           ///< submaps looked at for each keyframe
  int max_per_pair = 3;             ///< closures between the same two submaps, then no more are sought
  int confirmations = 3;            ///< keyframes that must say the same
  double confirm_travel = 0.5;      ///< these lie at least this far apart [m]
  double confirm_jump = 1.0;        ///< and farther by this for each metre that the robot would jump [m/m]
  double confirm_share = 0.5;       ///< share of the keyframes between them that must say the same, too
  int confirm_within = 40;          ///< and at most so many keyframes
  double verify_jump = 0.1;         ///< what a closure moves this far is held against the map [m]
  double max_contradiction = 0.03;  ///< so much more of its beams may contradict it than did before
  double agree_distance = 0.2;      ///< the same: it puts the robot this near [m]
  double agree_angle = 0.04;        ///< and turned by no more than this [rad]
  LoopSearchParameters search;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("min_gap", min_gap, "", "submaps that must have begun since the one that is recognised", between(2, 1000));
    v.field("reach", reach, "m", "a submap that the robot came this near is worth a look", positive());
    v.field("sigmas", sigmas, "", "the search window holds so many standard deviations", between(1.0, 10.0));
    v.field("min_window", min_window, "m", "least half width of the window", positive());
    v.field("max_window", max_window, "m", "greatest half width of the window", positive());
    v.field("min_angle", min_angle, "rad", "least half angle of the window", positive());
    v.field("max_angle", max_angle, "rad", "greatest half angle of the window", between(0.01, kPi));
    v.field("known_position", known_position, "m", "a submap is not looked for where it is known this well",
            atLeast(0.0));
    v.field("known_yaw", known_yaw, "rad", "and this well", atLeast(0.0));
    v.field("max_candidates", max_candidates, "", "submaps looked at for each keyframe", between(1, 100));
    v.field("max_per_pair", max_per_pair, "", "closures between the same two submaps, then no more are sought",
            between(1, 100));
    v.field("confirmations", confirmations, "", "keyframes that must say the same", between(1, 100));
    v.field("confirm_travel", confirm_travel, "m", "these lie at least this far apart", atLeast(0.0));
    v.field("confirm_jump", confirm_jump, "m/m", "and farther by this for each metre that the robot would jump",
            atLeast(0.0));
    v.field("confirm_share", confirm_share, "", "share of the keyframes between them that must say the same, too",
            between(0.0, 1.0));
    v.field("confirm_within", confirm_within, "", "and at most so many keyframes", between(1, 10000));
    v.field("verify_jump", verify_jump, "m", "what a closure moves this far is held against the map", atLeast(0.0));
    v.field("max_contradiction", max_contradiction, "",
            "so much more of its beams may contradict the map than did before", between(0.0, 1.0));
    v.field("agree_distance", agree_distance, "m", "the same: it puts the robot this near", positive());
    v.field("agree_angle", agree_angle, "rad", "the same: it turns the robot by no more", positive());
    v.group("search", search, "the search for one keyframe in one submap");
  }
};

/// Closes loops: looks for each keyframe in the old submaps that it may be in, as far around as the graph is uncertain,
/// and believes what several keyframes say and the graph does not contradict. A closure too few costs some accuracy, a
/// false one the map: in doubt there is none.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserParameters& parameters = {});

  /// Looks for the newest keyframe of `graph`, of which `points` are the thinned ones. Gives the closures that have
  /// become certain by that; the graph has then moved.
  std::vector<LoopClosure> update(SubmapGraph& graph, const surfaces::SurfacePoints& points);

  /// The attempts so far.
  const ClosureCounts& counts() const { return counts_; }

 private:
  /// A closure that waits for others to say the same, or, once certain, is one of those others.
  struct Hypothesis {
    std::size_t keyframe = 0;
    std::size_t submap = 0;
    std::size_t of = 0;  ///< the submap that the keyframe is in
    scan_matching::PoseBelief T_submap_keyframe;
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
  /// Whether what has moved since `before`, when the sampled keyframes were at `then`, does not contradict the rest of
  /// the map more than it did.
  bool makesSense(const SubmapGraph& graph, const PoseGraph& before, const std::vector<Pose2>& then);
  std::vector<LoopClosure> accept(SubmapGraph& graph, const std::vector<std::size_t>& chosen);

  LoopCloserParameters parameters_;
  LoopSearch search_;
  std::vector<Hypothesis> hypotheses_;
  ClosureCounts counts_;
};

}  // namespace frontier_pilot::slam
