#pragma once

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/scan_matching/parameters.h"
#include "frontier_pilot/surfaces/parameters.h"

namespace frontier_pilot::slam {

/// The motion model of odometry. Variances grow with the distance driven, so that they do not depend on how often
/// odometry is read.
struct OdometryTrust {
  double distance = 0.06;         ///< standard deviation of the position after a metre [m]
  double distance_turn = 0.05;    ///< of the position after a turn of a radian [m]
  double yaw_distance = 0.04;     ///< of the yaw after a metre [rad]
  double yaw_turn = 0.06;         ///< of the yaw after a radian [rad]
  double unmeasured_speed = 0.6;  ///< greatest speed that odometry may fail to measure, such as slip [m/s]
  double unmeasured_turn = 3.0;   ///< greatest rate of turn that it may fail to measure [rad/s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("distance", distance, "m", "standard deviation of the position after a metre of odometry",
            positiveUpTo(1000.0));
    v.field("yaw_distance", yaw_distance, "rad", "standard deviation of the yaw after a metre of odometry",
            positiveUpTo(1000.0));
    v.field("yaw_turn", yaw_turn, "rad", "standard deviation of the yaw after a turn of a radian",
            positiveUpTo(1000.0));
    v.fixed({"distance_turn", "unseen_speed", "unseen_turn"});
  }
};

/// How the robot is tracked, see ScanTracker.
struct ScanTrackerParameters {
  int min_points = 25;         ///< a scan with fewer points is not matched
  double min_score = 0.4;      ///< mean likelihood that a match must reach
  double min_inliers = 0.5;    ///< share of the points that must lie on known surfaces
  double new_inliers = 0.3;    ///< enough if nearly no beam is inconsistent with the map and 30 points lie on surfaces
  double max_distance = 1.0;   ///< greatest half width of the search [m]
  double max_angle = 0.6;      ///< greatest half angle of the search [rad]
  double max_silence = 5.0;    ///< time without a match after which a scan that fits nowhere means `lost` [s]
  double sparse_period = 0.4;  ///< a scan that comes later than this after the last one [s],
  double sparse_distance = 0.3;  ///< and is farther from it than this [m]
  double sparse_angle = 0.25;    ///< or turned farther [rad], may extend the map without a match
  OdometryTrust odometry;
  scan_matching::RefinementParameters refinement;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_points", "min_score", "min_inliers", "new_inliers", "max_distance", "max_angle", "max_silence",
             "sparse_period", "sparse_distance", "sparse_angle"});
    v.group("odometry", odometry, "the motion model of odometry");
    v.group("refinement", refinement, "the sub-cell refinement of a match");
  }
};

/// The front end: keyframes, and submaps of the last few metres.
struct LocalSlamParameters {
  double keyframe_distance = 0.2;  ///< a keyframe is made after moving this far [m]
  double keyframe_angle = 0.2;     ///< or turning this far [rad]
  double keyframe_inliers = 0.8;   ///< with a smaller share of inliers a tenth of either is enough
  int submap_keyframes = 80;       ///< number of keyframes in a finished submap; the next one begins at half of it,
  double submap_length = 12.0;     ///< or at half of this length of the way through a submap [m]
  scan_matching::LikelihoodParameters likelihood;
  ScanTrackerParameters tracker;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"keyframe_distance", "keyframe_angle", "keyframe_inliers", "submap_keyframes", "submap_length"});
    v.group("likelihood", likelihood, "the likelihood field that is searched");
    v.group("tracker", tracker, "how the robot is tracked");
  }
};

/// The uncertainty of a submap's pose relative to its predecessor that remains even where scans determine it fully.
struct SubmapDrift {
  double position = 0.008;  ///< standard deviation [m]
  double yaw = 0.002;       ///< standard deviation [rad]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"position", "yaw"});
  }
};

/// The optimisation of the pose graph.
struct PoseGraphParameters {
  int max_iterations = 50;
  double tolerance = 1e-6;   ///< an optimisation ends when a step lowers the cost by no more than this share
  double outlier_chi2 = 16;  ///< squared Mahalanobis error that quarters a closure's weight, and refuses new ones

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"max_iterations", "tolerance", "outlier_chi2"});
  }
};

/// The search for one keyframe in one submap, and what its result must satisfy to be a match.
struct LoopSearchParameters {
  double min_score = 0.55;     ///< mean likelihood of the points that a match must reach
  double min_inliers = 0.6;    ///< share of the points that must lie on a surface
  double ambiguity = 0.9;      ///< a match is ambiguous if a second pose has this share of its score
  double peak_distance = 0.2;  ///< a pose within this distance of the best one [m]
  double peak_angle = 0.1;     ///< and within this angle belongs to the same peak [rad]
  int submaps_kept = 8;        ///< number of submaps whose maps for the search are kept in memory
  scan_matching::LikelihoodParameters likelihood;
  scan_matching::RefinementParameters refinement;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_score", "min_inliers", "ambiguity", "peak_distance", "peak_angle", "submaps_kept"});
    v.group("likelihood", likelihood, "the likelihood field that is searched");
    v.group("refinement", refinement, "the sub-cell refinement of a match");
  }
};

/// Where loops are searched for, and which matches are accepted.
struct LoopCloserParameters {
  int min_gap = 3;                  ///< only submaps at least this many older than the newest are searched,
  double reach = 4.0;               ///< and with a keyframe nearer than this plus the window's half width [m]
  double sigmas = 3.0;              ///< half width of the search window, in standard deviations
  double min_window = 0.4;          ///< least half width of the window [m]
  double max_window = 8.0;          ///< greatest half width of the window [m]
  double min_angle = 0.1;           ///< least half angle of the window [rad]
  double max_angle = 0.8;           ///< greatest half angle of the window [rad]
  double known_position = 0.05;     ///< no search where the standard deviation of the position is less [m],
  double known_yaw = 0.01;          ///< and that of the yaw is less [rad]
  int max_candidates = 2;           ///< greatest number of submaps searched for each keyframe
  int max_per_pair = 3;             ///< greatest number of closures between the same two submaps
  int confirmations = 3;            ///< number of keyframes whose matches must agree, the newest included
  double confirm_travel = 0.5;      ///< least distance from the keyframe to the farthest that agrees [m]
  double confirm_jump = 1.0;        ///< added to that distance for each metre that the robot would jump [m/m]
  double confirm_share = 0.5;       ///< least share that agrees of the keyframes from the oldest of these to the newest
  int confirm_within = 40;          ///< age beyond which a match is dropped [keyframes]
  double verify_jump = 0.1;         ///< keyframes that closures move farther are checked against the map [m]
  double max_inconsistency = 0.03;  ///< greatest mean increase of the share of beams that are inconsistent with the map
  double agree_distance = 0.2;      ///< two matches agree when their positions differ by no more [m],
  double agree_angle = 0.04;        ///< and their yaws by no more [rad]
  LoopSearchParameters search;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_gap",        "reach",          "sigmas",        "min_window",     "max_window",   "min_angle",
             "max_angle",      "known_position", "known_yaw",     "max_candidates", "max_per_pair", "confirmations",
             "confirm_travel", "confirm_jump",   "confirm_share", "confirm_within", "verify_jump",  "max_inconsistency",
             "agree_distance", "agree_angle"});
    v.group("search", search, "the search for one keyframe in one submap");
  }
};

/// When the map is rendered again.
struct RenderingParameters {
  double min_distance = 0.025;    ///< a map with a keyframe that moved this far [m] is out of date,
  double min_angle = 0.005;       ///< and so is one with a keyframe that turned this far [rad]
  double urgent_distance = 0.05;  ///< one that moved this far [m] has the map rendered again at once;
  double share = 0.02;            ///< otherwise this share of all keyframes has to be new

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_distance", "min_angle", "urgent_distance", "share"});
  }
};

/// When past closures are searched for again in bent submaps, see Refinement.
struct RefinementParameters {
  double weak_share = 0.02;  ///< if at least this share of the steps between keyframes is mostly by odometry,
  int min_keyframes = 30;    ///< there are so many keyframes,
  double growth = 1.15;      ///< and so many times as many as the last time
  int max_candidates = 4;    ///< number of submaps that are then searched for each keyframe
  double position = 0.005;   ///< standard deviation of each step that remains where a match determines it fully [m]
  double yaw = 0.0015;       ///< the same for its yaw [rad]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"weak_share", "min_keyframes", "growth", "max_candidates", "position", "yaw"});
  }
};

/// All parameters of GraphSlam.
struct GraphSlamParameters {
  surfaces::SurfaceParameters surface;
  LocalSlamParameters local;
  SubmapDrift drift;
  PoseGraphParameters graph;
  LoopCloserParameters loops;
  RefinementParameters refinement;
  RenderingParameters rendering;

  template <class Visitor>
  void describe(Visitor& v) {
    v.group("surface", surface, "how the surfaces of a scan are read, for matching and mapping");
    v.group("local", local, "matching of scans with the last few metres");
    v.group("drift", drift, "the drift of the local map from submap to submap");
    v.group("graph", graph, "the pose graph");
    v.group("loops", loops, "loop closing");
    v.group("refinement", refinement, "the refinement of drives with few scans");
    v.group("rendering", rendering, "when the map is rendered again");
  }
};

}  // namespace frontier_pilot::slam
