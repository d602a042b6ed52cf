#include "slam/graph/keyframe_graph.h"

#include <Eigen/LU>

#include "slam/graph/covariance.h"

namespace frontier_pilot::slam {
namespace {

PoseConstraint constraintOf(const SubmapGraph& graph, const SubmapClosure& closure) {
  const std::size_t from = graph.nearestKeyframe(closure.submap, closure.T_submap_keyframe.pose);
  const Pose2 T_submap_from = graph.T_submap_keyframe(closure.submap, from);
  const Eigen::Matrix3d covariance = alongAxes(closure.T_submap_keyframe.covariance, T_submap_from.yaw);
  return {from, closure.keyframe, T_submap_from.inverse() * closure.T_submap_keyframe.pose, covariance.inverse(), true};
}

}  // namespace

std::vector<Pose2> keyframePoses(const SubmapGraph& graph, const RefinementParameters& parameters) {
  PoseGraph poses(graph.graph().parameters());
  const Eigen::Matrix3d least = diagonalCovariance(parameters.position, parameters.yaw);
  for (std::size_t keyframe = 0; keyframe < graph.keyframeCount(); ++keyframe) {
    poses.addNode(graph.T_map_keyframe(keyframe));
    if (keyframe == 0) continue;
    const KeyframeStep& step = graph.step(keyframe);
    const Eigen::Matrix3d drift = alongAxes(step.drift, graph.keyframe(keyframe - 1).T_local_base.yaw) + least;
    poses.addConstraint({keyframe - 1, keyframe, step.motion, drift.inverse(), false});
  }
  for (const SubmapClosure& closure : graph.closures()) poses.addConstraint(constraintOf(graph, closure));
  poses.optimize();
  return poses.poses();
}

}  // namespace frontier_pilot::slam
