#include "slam/back_end/refinement.h"

#include <utility>
#include <vector>

#include "slam/graph/covariance.h"
#include "slam/graph/keyframe_graph.h"

namespace frontier_pilot::slam {

void Refinement::note(const KeyframeStep& step) {
  ++keyframes_;
  if (step.weak) ++weak_;
}

bool Refinement::isDue() const {
  const RefinementParameters& limits = parameters_.refinement;
  const auto count = static_cast<double>(keyframes_);
  return keyframes_ >= static_cast<std::size_t>(limits.min_keyframes) &&
         static_cast<double>(weak_) >= limits.weak_share * count && count >= limits.growth * static_cast<double>(last_);
}

std::vector<LoopClosure> Refinement::refine(SubmapGraph& graph, LoopCloser& closer) {
  last_ = keyframes_;
  const std::vector<Pose2> T_map_base = keyframePoses(graph, parameters_.refinement);
  LoopCloserParameters loops = parameters_.loops;
  loops.max_candidates = parameters_.refinement.max_candidates;
  LoopCloser again(loops, parameters_.surface);
  std::vector<LoopClosure> closures;
  SubmapGraph bent(parameters_.drift, parameters_.graph);
  for (std::size_t i = 0; i < graph.keyframeCount(); ++i) {
    PlacedKeyframe placed = graph.placed(i);
    placed.keyframe.T_local_base = T_map_base[i];
    if (i > 0) {  // the drift lies along the axes of the local frame, in which the step before has been turned
      const double turned = T_map_base[i - 1].yaw - graph.keyframe(i - 1).T_local_base.yaw;
      placed.step.drift = alongAxes(placed.step.drift, -turned);
    }
    for (PlacedKeyframe::Place& place : placed.places) {
      place.T_local_submap = T_map_base[graph.submap(place.submap).keyframes.front()];
    }
    const surfaces::SurfacePoints points = surfaces::thinned(placed.keyframe.scan.points, parameters_.surface);
    bent.add(std::move(placed));
    for (const LoopClosure& closure : again.update(bent, points)) closures.push_back(closure);
  }
  // A graph that has lost its closures would be bent for good.
  if (2 * bent.closures().size() < graph.closures().size()) return {};
  again.setCounts(closer.counts());
  graph = std::move(bent);
  closer = std::move(again);
  return closures;
}

}  // namespace frontier_pilot::slam
