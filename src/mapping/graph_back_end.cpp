#include <cmath>
#include <utility>

#include "frontier_pilot/mapping/graph_slam.h"

namespace frontier_pilot {

GraphBackEnd::GraphBackEnd(const GraphSlamParameters& parameters, const OccupancyMapParameters& map,
                           const ScanInsertionParameters& insertion, std::string base)
    : parameters_(parameters),
      map_parameters_(map),
      inserter_(insertion, parameters.local.surface),
      base_(std::move(base)),
      graph_(parameters.drift, parameters.graph),
      closer_(parameters.loops) {}

MapRevision GraphBackEnd::update(std::vector<PlacedKeyframe> batch) {
  MapRevision revision;
  const Pose2 T_map_local = graph_.T_map_local();
  for (PlacedKeyframe& placed : batch) {
    const SurfacePoints points = std::exchange(placed.keyframe.points, {});
    rendered_.push_back(placed.T_map_base);
    graph_.add(std::move(placed));
    for (const LoopClosure& closure : closer_.update(graph_, points)) revision.closures.push_back(closure);
  }
  moved_ = moved_ || !revision.closures.empty();
  revision.counts = closer_.counts();
  // A submap begins where the local frame is thought to be, so that only closures move that.
  if (!revision.closures.empty()) revision.T_new_old = graph_.T_map_local() * T_map_local.inverse();
  if (isRenderingDue()) revision.map = render();
  return revision;
}

bool GraphBackEnd::isRenderingDue() const {
  if (!moved_) return false;
  bool visible = false;
  for (std::size_t i = 0; i < rendered_.size(); ++i) {
    const Pose2 step = rendered_[i].inverse() * graph_.T_map_keyframe(i);
    const double distance = step.position().norm();
    if (distance > parameters_.rendering.urgent_distance) return true;
    visible = visible || distance > parameters_.rendering.min_distance ||
              std::abs(step.yaw) > parameters_.rendering.min_angle;
  }
  const auto fresh = static_cast<double>(rendered_.size() - rendered_count_);
  return visible && fresh >= parameters_.rendering.share * static_cast<double>(rendered_.size());
}

OccupancyMap GraphBackEnd::render() {
  OccupancyMap map(map_parameters_);
  if (!base_.empty()) {
    std::string ignored;  // it was this map's own once
    map.read(base_, ignored);
  }
  map.beginBatch();
  for (std::size_t i = 0; i < rendered_.size(); ++i) {
    rendered_[i] = graph_.T_map_keyframe(i);
    inserter_.insert(graph_.keyframe(i).scan, rendered_[i], map);
  }
  map.endBatch();
  rendered_count_ = rendered_.size();
  moved_ = false;
  return map;
}

std::vector<KeyframePose> GraphBackEnd::trajectory() const {
  std::vector<KeyframePose> trajectory;
  trajectory.reserve(graph_.keyframeCount());
  for (std::size_t i = 0; i < graph_.keyframeCount(); ++i) {
    const Keyframe& keyframe = graph_.keyframe(i);
    trajectory.push_back({keyframe.scan.stamp, keyframe.T_odom_base, graph_.T_map_keyframe(i)});
  }
  return trajectory;
}

}  // namespace frontier_pilot
