#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "slam/front_end/local_slam.h"
#include "slam/graph/pose_graph.h"

namespace frontier_pilot::slam {

/// The step to a keyframe from the one before it, as the front end measured it; the identity for the first one.
struct KeyframeStep {
  Pose2 motion;
  Eigen::Matrix3d drift = Eigen::Matrix3d::Zero();  ///< its covariance along the local frame's axes: DriftCovariance
  bool weak = false;                                ///< mostly by odometry: the scan could hardly be matched
};

/// A keyframe, the submaps that it is in, and its pose in the map.
struct PlacedKeyframe {
  Keyframe keyframe;
  KeyframeStep step;
  struct Place {
    std::size_t submap = 0;
    Pose2 T_local_submap;
  };
  std::vector<Place> places;  ///< the submaps that it is in, the older first
  Pose2 T_map_base;           ///< pose with which it was inserted into the map
};

/// A keyframe that was recognised in an older submap.
struct SubmapClosure {
  std::size_t submap = 0;
  std::size_t keyframe = 0;
  scan_matching::PoseWithCovariance T_submap_keyframe;
};

/// The submaps of a drive as nodes of a pose graph. A submap is rigid, and its keyframes move with it. A keyframe in
/// two submaps is interpolated between the poses that they give it, the closer to the younger one the later it came, so
/// that the map bends smoothly where the graph does.
class SubmapGraph {
 public:
  struct Submap {
    Pose2 T_local_submap;
    std::vector<std::size_t> keyframes;  ///< ascending
  };

  explicit SubmapGraph(const SubmapDrift& drift = {}, const PoseGraphParameters& parameters = {});

  /// Keyframes come in the order of their ids, from 0, each in at least one submap.
  void add(PlacedKeyframe placed);

  std::size_t keyframeCount() const { return keyframes_.size(); }
  std::size_t submapCount() const { return submaps_.size(); }
  const Keyframe& keyframe(std::size_t id) const { return keyframes_[id]; }
  const KeyframeStep& step(std::size_t keyframe) const { return steps_[keyframe]; }
  const Submap& submap(std::size_t id) const { return submaps_[id]; }
  /// The keyframe as it was added, but for T_map_base.
  PlacedKeyframe placed(std::size_t keyframe) const;
  /// The closures that the graph contains, in the order in which they were added.
  const std::vector<SubmapClosure>& closures() const { return closures_; }

  /// The difference between the ids of `submap` and of the nearest submap that the keyframe is in.
  std::size_t gap(std::size_t submap, std::size_t keyframe) const;

  Pose2 T_map_submap(std::size_t submap) const { return graph_.pose(submap); }
  Pose2 T_map_keyframe(std::size_t keyframe) const;
  Pose2 T_submap_keyframe(std::size_t submap, std::size_t keyframe) const;
  /// The keyframe of `submap` that is nearest to a pose in that one's frame; a radian counts as a metre.
  std::size_t nearestKeyframe(std::size_t submap, const Pose2& T_submap_base) const;
  /// The pose of the local frame in the map, as currently estimated.
  Pose2 T_map_local() const;

  /// For each submap an upper bound on the covariance of (x, y, yaw) of its pose relative to `submap`, along that one's
  /// axes: that of the most certain path through the graph. Olson, "Robust and Efficient Robotic Mapping", 2008, 3.3.
  std::vector<Eigen::Matrix3d> uncertaintyFrom(std::size_t submap) const;

  /// Adds a closure: `keyframe`, which is in submap `of`, is at `T_submap_keyframe`. Moves nothing yet.
  void close(std::size_t submap, std::size_t of, std::size_t keyframe,
             const scan_matching::PoseWithCovariance& T_submap_keyframe);
  PoseGraphReport optimize() { return graph_.optimize(); }
  const PoseGraph& graph() const { return graph_; }
  /// Puts an earlier copy of `graph` back: closures that were added since are forgotten.
  void setGraph(const PoseGraph& graph);

 private:
  void begin(const PlacedKeyframe::Place& place);

  SubmapDrift drift_;
  PoseGraph graph_;  ///< node i is submap i
  std::vector<Submap> submaps_;
  std::vector<Keyframe> keyframes_;
  std::vector<KeyframeStep> steps_;  ///< by keyframe
  std::vector<SubmapClosure> closures_;
  struct Range {
    std::size_t first = 0, last = 0;
  };
  std::vector<Range> places_;                              ///< by keyframe: the submaps that it is in
  Eigen::Matrix3d drift_since_ = Eigen::Matrix3d::Zero();  ///< the drift of the steps since the last submap began
  int steps_since_ = 0;                                    ///< their number
};

}  // namespace frontier_pilot::slam
