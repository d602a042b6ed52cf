#include "slam/back_end/loop_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace frontier_pilot::slam {
namespace {

scan_matching::SurfaceMap surfaceMapOf(const SubmapGraph& graph, std::size_t submap,
                                       const scan_matching::LikelihoodParameters& likelihood,
                                       const surfaces::SurfaceParameters& surface) {
  scan_matching::SurfaceMap map(likelihood);
  for (const std::size_t keyframe : graph.submap(submap).keyframes) {
    const surfaces::SurfacePoints& points = graph.keyframe(keyframe).scan.points;
    map.add(surfaces::filled(points, surface), graph.T_submap_keyframe(submap, keyframe));
  }
  return map;
}

constexpr double kSigmas = 3.0;         // half width of a window, in standard deviations
constexpr double kLoopPenalty = 0.005;  // loss of score at a deviation of one standard deviation

/// The covariance of a match: the window bounds what the points leave open, and a floor prevents overconfidence.
Eigen::Matrix3d covarianceOf(const Eigen::Matrix3d& information, const scan_matching::SearchWindow& window) {
  constexpr double kPosition = 0.02;  // [m]
  constexpr double kYaw = 0.004;      // [rad]
  const Eigen::Vector3d widths(window.x, window.y, std::min(window.yaw, kPi));
  const Eigen::Matrix3d known = information + Eigen::Matrix3d(widths.cwiseProduct(widths).cwiseInverse().asDiagonal());
  const Eigen::Vector3d least(kPosition * kPosition, kPosition * kPosition, kYaw * kYaw);
  return known.inverse() + Eigen::Matrix3d(least.asDiagonal());
}

}  // namespace

const char* toString(ClosureVerdict verdict) {
  switch (verdict) {
    case ClosureVerdict::kAccepted:
      return "accepted";
    case ClosureVerdict::kNotFound:
      return "not found";
    case ClosureVerdict::kPoor:
      return "poor";
    case ClosureVerdict::kAmbiguous:
      return "ambiguous";
    case ClosureVerdict::kUnconfirmed:
      return "unconfirmed";
    case ClosureVerdict::kDisagrees:
      return "disagrees with the graph";
    case ClosureVerdict::kContradicts:
      return "contradicts the map";
  }
  return "unknown";
}

const LoopSearch::Prepared& LoopSearch::prepare(const SubmapGraph& graph, std::size_t submap, int top) {
  const std::size_t keyframes = graph.submap(submap).keyframes.size();
  prepared_.remove_if([&](const Prepared& old) { return old.submap == submap && old.keyframes != keyframes; });
  const auto found = std::find_if(prepared_.begin(), prepared_.end(),
                                  [&](const Prepared& prepared) { return prepared.submap == submap; });
  if (found != prepared_.end()) {
    prepared_.splice(prepared_.begin(), prepared_, found);
    if (found->pyramid.top() < top) found->pyramid = scan_matching::MaxPyramid(found->map.field(), top);
    return *found;
  }
  scan_matching::SurfaceMap map = surfaceMapOf(graph, submap, parameters_.likelihood, surface_parameters_);
  scan_matching::MaxPyramid pyramid(map.field(), top);
  prepared_.push_front({submap, keyframes, std::move(map), std::move(pyramid)});
  if (prepared_.size() > static_cast<std::size_t>(parameters_.submaps_kept)) prepared_.pop_back();
  return prepared_.front();
}

bool LoopSearch::isAmbiguous(const scan_matching::MaxPyramid& pyramid, const surfaces::SurfacePoints& points,
                             scan_matching::SearchRequest request, const scan_matching::SearchResult& best,
                             const Eigen::Matrix3d& information) const {
  request.exclusions = {{best.pose, parameters_.peak_distance, parameters_.peak_angle}};
  request.min_score = parameters_.ambiguity * best.score;
  const auto rival = scan_matching::correlativeSearch(pyramid, points, request);
  if (!rival) return false;
  // Poses along a bare corridor are no rivals: by its information the scan cannot tell them apart.
  constexpr double kSameRidge = 25.0;
  const Eigen::Vector3d apart = scan_matching::difference(rival->pose, best.pose);
  return apart.dot(information * apart) > kSameRidge;
}

surfaces::SurfacePoints LoopSearch::pointsOf(const Keyframe& keyframe) const {
  return surfaces::thinned(keyframe.scan.points, surface_parameters_);
}

double LoopSearch::contradiction(const SubmapGraph& graph, std::size_t submap, const surfaces::SurfacePoints& points,
                                 const Pose2& T_submap_keyframe) {
  const Prepared& prepared = prepare(graph, submap, 0);
  if (prepared.map.empty() || points.empty()) return 0.0;
  return scan_matching::inconsistentShare(prepared.map, points, T_submap_keyframe);
}

LoopSearch::Result LoopSearch::find(const SubmapGraph& graph, std::size_t submap, const surfaces::SurfacePoints& points,
                                    const Pose2& expected, const scan_matching::SearchWindow& window) {
  if (points.empty()) return {};
  const Prepared& prepared =
      prepare(graph, submap, scan_matching::pyramidTop(window, parameters_.likelihood.resolution));
  if (prepared.map.empty()) return {};
  scan_matching::SearchRequest request;
  request.expected = expected;
  request.window = window;
  request.min_score = parameters_.min_score;
  // The expected pose decides only what the scan leaves open: the penalty is bounded.
  const Vec2 sigma(window.x / kSigmas, window.yaw / kSigmas);
  request.penalty = {kLoopPenalty, kSigmas, sigma.x(), sigma.y()};
  const auto best = scan_matching::correlativeSearch(prepared.pyramid, points, request);
  if (!best || best->on_border) return {};
  const scan_matching::PoseWithCovariance prior{
      expected, Eigen::Vector3d(sigma.x(), sigma.x(), sigma.y()).array().square().matrix().asDiagonal()};
  const scan_matching::Refinement refined =
      scan_matching::refine(prepared.map, points, best->pose, prior, parameters_.refinement);
  const Pose2 step = best->pose.inverse() * refined.pose;
  // A correct refinement moves the pose by a few cells at most; beyond that it has slid along a wall.
  constexpr double kFarthest = 4.0;    // [cells]
  constexpr double kMostTurned = 0.1;  // [rad]
  const double farthest = kFarthest * parameters_.likelihood.resolution;
  // A few points, as of trees, lie on surfaces somewhere by chance.
  constexpr double kEvidence = 30.0;
  const bool evident = refined.inliers * static_cast<double>(points.size()) >= kEvidence;
  const bool slid = step.position().norm() > farthest || std::abs(step.yaw) > kMostTurned;
  if (slid || !evident || refined.inliers < parameters_.min_inliers) return {ClosureVerdict::kPoor, {}};
  if (isAmbiguous(prepared.pyramid, points, request, *best, refined.information)) {
    return {ClosureVerdict::kAmbiguous, {}};
  }
  return {ClosureVerdict::kAccepted, {refined.pose, covarianceOf(refined.information, window)}};
}

}  // namespace frontier_pilot::slam
