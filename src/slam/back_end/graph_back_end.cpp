#include "slam/back_end/graph_back_end.h"

#include <cmath>
#include <utility>

#include "slam/graph/covariance.h"

namespace frontier_pilot::slam {

GraphBackEnd::GraphBackEnd(const GraphSlamParameters& parameters, const occupancy::OccupancyMapParameters& map,
                           const occupancy::ScanInsertionParameters& insertion, std::string base)
    : parameters_(parameters),
      map_parameters_(map),
      inserter_(insertion),
      base_(std::move(base)),
      graph_(parameters.drift, parameters.graph),
      closer_(parameters.loops, parameters.surface),
      refinement_(parameters) {}

MapRevision GraphBackEnd::update(std::vector<PlacedKeyframe> batch) {
  MapRevision revision;
  const Pose2 T_map_front = this->T_map_front();
  const std::size_t known = closures_.size();
  for (PlacedKeyframe& placed : batch) {
    const surfaces::SurfacePoints points = std::exchange(placed.keyframe.points, {});
    rendered_.push_back(placed.T_map_base);
    add(std::move(placed));
    for (const LoopClosure& closure : closer_.update(graph_, points)) report(closure);
  }
  if (closures_.size() > known && refinement_.isDue()) refine();
  // A new submap is placed by the present estimate of the local frame, so only closures move that frame.
  if (closures_.size() > known) {
    const Pose2 jump = this->T_map_front() * T_map_front.inverse();
    T_new_old_ = withheld_ ? jump * T_new_old_ : jump;
    moved_ = true;
  }
  revision.counts = closer_.counts();
  if (isRenderingDue()) render(revision);
  if (withheld_) return revision;
  revision.closures = std::exchange(closures_, {});
  revision.T_new_old = std::exchange(T_new_old_, Pose2());
  return revision;
}

void GraphBackEnd::add(PlacedKeyframe placed) {
  refinement_.note(placed.step);
  T_front_last_ = placed.keyframe.T_local_base;
  placed.keyframe.T_local_base = T_local_front_ * T_front_last_;
  if (T_local_front_.yaw != 0.0) placed.step.drift = alongAxes(placed.step.drift, -T_local_front_.yaw);
  for (PlacedKeyframe::Place& place : placed.places) place.T_local_submap = T_local_front_ * place.T_local_submap;
  graph_.add(std::move(placed));
}

void GraphBackEnd::report(LoopClosure closure) {
  if (reported_.emplace(closure.submap, closure.keyframe).second) closures_.push_back(closure);
}

void GraphBackEnd::refine() {
  for (const LoopClosure& closure : refinement_.refine(graph_, closer_)) report(closure);
  const std::size_t last = graph_.keyframeCount() - 1;
  T_local_front_ = graph_.keyframe(last).T_local_base * T_front_last_.inverse();
}

void GraphBackEnd::takeBack(const MapRevision& refused) {
  rendered_ = replaced_;
  closures_ = refused.closures;
  T_new_old_ = refused.T_new_old;
  moved_ = true;
  withheld_ = true;
}

bool GraphBackEnd::isRenderingDue() const {
  if (!moved_) return false;
  bool visible = false;
  for (std::size_t i = 0; i < rendered_.size(); ++i) {
    const Pose2 step = rendered_[i].inverse() * graph_.T_map_keyframe(i);
    const double distance = step.position().norm();
    // After a refused map the next one is probably too large as well, so it is not rendered for every keyframe.
    if (distance > parameters_.rendering.urgent_distance && !withheld_) return true;
    visible = visible || distance > parameters_.rendering.min_distance ||
              std::abs(step.yaw) > parameters_.rendering.min_angle;
  }
  const auto fresh = static_cast<double>(rendered_.size() - rendered_count_);
  return visible && fresh >= parameters_.rendering.share * static_cast<double>(rendered_.size());
}

void GraphBackEnd::render(MapRevision& revision) {
  occupancy::OccupancyMap& map = revision.map.emplace(map_parameters_);
  if (!base_.empty()) {
    std::string ignored;  // no error to report: a map of the same parameters wrote `base_`
    map.read(base_, ignored);
  }
  replaced_ = rendered_;
  inserter_.forgetLoneReturns();
  for (std::size_t i = 0; i < rendered_.size(); ++i) {
    rendered_[i] = graph_.T_map_keyframe(i);
    if (lacksRoom(inserter_.insert(graph_.keyframe(i).scan, rendered_[i], map))) ++revision.left_out;
  }
  rendered_count_ = rendered_.size();
  moved_ = false;
  withheld_ = false;
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

}  // namespace frontier_pilot::slam
