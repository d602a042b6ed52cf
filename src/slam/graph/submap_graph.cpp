#include "slam/graph/submap_graph.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "slam/graph/covariance.h"

namespace frontier_pilot::slam {
namespace {

/// The uncertainty of a pose as one number [m^2]: yaw counts by how far it moves points at a scanner's usual range.
double spread(const Eigen::Matrix3d& covariance) {
  constexpr double kReach = 5.0;  // [m]
  return covariance(0, 0) + covariance(1, 1) + kReach * kReach * covariance(2, 2);
}

}  // namespace

SubmapGraph::SubmapGraph(const SubmapDrift& drift, const PoseGraphParameters& parameters)
    : drift_(drift), graph_(parameters) {}

void SubmapGraph::add(PlacedKeyframe placed) {
  const std::size_t id = keyframes_.size();
  drift_since_ += placed.step.drift;
  ++steps_since_;
  for (const PlacedKeyframe::Place& place : placed.places) {
    if (place.submap == submaps_.size()) begin(place);
    submaps_[place.submap].keyframes.push_back(id);
  }
  places_.push_back({placed.places.front().submap, placed.places.back().submap});
  keyframes_.push_back(std::move(placed.keyframe));
  steps_.push_back(placed.step);
}

PlacedKeyframe SubmapGraph::placed(std::size_t keyframe) const {
  PlacedKeyframe placed;
  placed.keyframe = keyframes_[keyframe];
  placed.step = steps_[keyframe];
  for (std::size_t submap = places_[keyframe].first; submap <= places_[keyframe].last; ++submap) {
    placed.places.push_back({submap, submaps_[submap].T_local_submap});
  }
  return placed;
}

void SubmapGraph::begin(const PlacedKeyframe::Place& place) {
  const Pose2 T_map_submap = submaps_.empty() ? place.T_local_submap : T_map_local() * place.T_local_submap;
  submaps_.push_back({place.T_local_submap, {}});
  const std::size_t node = graph_.addNode(T_map_submap);
  if (node == 0) return;
  const Pose2& T_local_before = submaps_[node - 1].T_local_submap;
  // Odometry's errors persist for a while: their standard deviations add up, not their variances.
  const Eigen::Matrix3d drifted = static_cast<double>(steps_since_) * drift_since_;
  drift_since_.setZero();
  steps_since_ = 0;
  const Eigen::Matrix3d covariance =
      alongAxes(drifted, T_local_before.yaw) + diagonalCovariance(drift_.position, drift_.yaw);
  graph_.addConstraint({node - 1, node, T_local_before.inverse() * place.T_local_submap, covariance.inverse(), false});
}

std::size_t SubmapGraph::gap(std::size_t submap, std::size_t keyframe) const {
  const auto [first, last] = places_[keyframe];
  if (submap < first) return first - submap;
  return submap > last ? submap - last : 0;
}

Pose2 SubmapGraph::T_submap_keyframe(std::size_t submap, std::size_t keyframe) const {
  return submaps_[submap].T_local_submap.inverse() * keyframes_[keyframe].T_local_base;
}

std::size_t SubmapGraph::nearestKeyframe(std::size_t submap, const Pose2& T_submap_base) const {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t keyframe : submaps_[submap].keyframes) {
    const Pose2 apart = T_submap_keyframe(submap, keyframe).inverse() * T_submap_base;
    const double distance = apart.position().norm() + std::abs(apart.yaw);
    if (distance >= least) continue;
    least = distance;
    nearest = keyframe;
  }
  return nearest;
}

Pose2 SubmapGraph::T_map_keyframe(std::size_t keyframe) const {
  const auto [first, last] = places_[keyframe];
  const Pose2 by_first = T_map_submap(first) * T_submap_keyframe(first, keyframe);
  if (first == last) return by_first;
  // The overlap ends with the older submap. While that still grows, its present end is used: both nearly agree then.
  const std::size_t begin = submaps_[last].keyframes.front();
  const std::size_t end = submaps_[first].keyframes.back();
  const double share = (static_cast<double>(keyframe - begin) + 0.5) / static_cast<double>(end - begin + 1);
  return interpolate(by_first, T_map_submap(last) * T_submap_keyframe(last, keyframe), share);
}

Pose2 SubmapGraph::T_map_local() const {
  return submaps_.empty() ? Pose2() : graph_.poses().back() * submaps_.back().T_local_submap.inverse();
}

std::vector<Eigen::Matrix3d> SubmapGraph::uncertaintyFrom(std::size_t submap) const {
  std::vector<std::vector<std::size_t>> incident(submaps_.size());
  for (std::size_t i = 0; i < graph_.constraints().size(); ++i) {
    incident[graph_.constraints()[i].from].push_back(i);
    incident[graph_.constraints()[i].to].push_back(i);
  }
  const Pose2 T_origin_map = graph_.pose(submap).inverse();
  constexpr double kFar = 1e6;  // [m]: not connected, nothing is known
  std::vector<Eigen::Matrix3d> covariances(submaps_.size(), diagonalCovariance(kFar, kFar));
  covariances[submap].setZero();
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(0.0, submap);
  std::vector<bool> done(submaps_.size(), false);
  while (!open.empty()) {
    const std::size_t at = open.top().second;
    open.pop();
    if (done[at]) continue;
    done[at] = true;
    const Pose2 T_origin_at = T_origin_map * graph_.pose(at);
    for (const std::size_t index : incident[at]) {
      const PoseConstraint& constraint = graph_.constraints()[index];
      const bool forward = constraint.from == at;
      const std::size_t next = forward ? constraint.to : constraint.from;
      if (done[next]) continue;
      const Eigen::Matrix3d inverse = constraint.information.inverse();
      const Eigen::Matrix3d step = forward ? inverse : reversed(inverse, constraint.T_from_to);
      const Eigen::Matrix3d covariance =
          compounded(T_origin_at, covariances[at], T_origin_map * graph_.pose(next), step);
      if (spread(covariance) >= spread(covariances[next])) continue;
      covariances[next] = covariance;
      open.emplace(spread(covariance), next);
    }
  }
  return covariances;
}

void SubmapGraph::close(std::size_t submap, std::size_t of, std::size_t keyframe,
                        const scan_matching::PoseWithCovariance& T_submap_keyframe) {
  const Pose2 T_submap_of = T_submap_keyframe.pose * this->T_submap_keyframe(of, keyframe).inverse();
  const Eigen::Matrix3d covariance =
      compounded(T_submap_keyframe.pose, T_submap_keyframe.covariance, T_submap_of, Eigen::Matrix3d::Zero());
  graph_.addConstraint({submap, of, T_submap_of, covariance.inverse(), true});
  closures_.push_back({submap, keyframe, T_submap_keyframe});
}

void SubmapGraph::setGraph(const PoseGraph& graph) {
  graph_ = graph;
  const auto closures = std::count_if(graph_.constraints().begin(), graph_.constraints().end(),
                                      [](const PoseConstraint& constraint) { return constraint.robust; });
  closures_.resize(static_cast<std::size_t>(closures));
}

}  // namespace frontier_pilot::slam
