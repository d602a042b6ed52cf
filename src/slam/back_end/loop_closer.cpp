#include "slam/back_end/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontier_pilot/core/motion.h"
#include "slam/graph/covariance.h"

namespace frontier_pilot::slam {
namespace {

constexpr double kSight = 3.0;  ///< range beyond which a scan shows little [m]

/// The distance from a point in a submap's frame to the nearest of its keyframes [m].
double distanceTo(const SubmapGraph& graph, std::size_t submap, const Vec2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::size_t keyframe : graph.submap(submap).keyframes) {
    nearest = std::min(nearest, (graph.T_submap_keyframe(submap, keyframe).position() - point).norm());
  }
  return nearest;
}

/// The newest keyframe's pose in the map, as currently estimated.
Pose2 newestPose(const SubmapGraph& graph) {
  return graph.T_map_local() * graph.keyframe(graph.keyframeCount() - 1).T_local_base;
}

/// The n of "every n-th keyframe" in the check of the map's consistency: neighbouring keyframes see nearly the same.
std::size_t sampling(const SubmapGraph& graph) {
  constexpr std::size_t kLeast = 5;
  constexpr std::size_t kMost = 200;  // about how many keyframes are checked
  return std::max(kLeast, graph.keyframeCount() / kMost);
}

std::vector<Pose2> sampledPoses(const SubmapGraph& graph) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < graph.keyframeCount(); i += sampling(graph)) poses.push_back(graph.T_map_keyframe(i));
  return poses;
}

/// Whether all closures in the graph agree with it.
bool isSound(const SubmapGraph& graph) {
  const PoseGraph& poses = graph.graph();
  return std::all_of(poses.constraints().begin(), poses.constraints().end(), [&](const PoseConstraint& constraint) {
    return !constraint.robust || poses.chi2(constraint) < poses.parameters().outlier_chi2;
  });
}

}  // namespace

LoopCloser::LoopCloser(const LoopCloserParameters& parameters, const surfaces::SurfaceParameters& surface)
    : parameters_(parameters), search_(parameters.search, surface) {}

std::vector<LoopClosure> LoopCloser::update(SubmapGraph& graph, const surfaces::SurfacePoints& points) {
  const std::size_t newest = graph.keyframeCount() - 1;
  forget(newest);
  const Pose2 T_map_keyframe = newestPose(graph);
  bool found = false;
  for (const Candidate& candidate : candidates(graph)) {
    const Pose2 expected = graph.T_map_submap(candidate.submap).inverse() * T_map_keyframe;
    const LoopSearch::Result result = search_.find(graph, candidate.submap, points, expected, candidate.window);
    if (result.verdict != ClosureVerdict::kAccepted) {
      counts_.add(result.verdict);
      continue;
    }
    hypotheses_.push_back({newest, candidate.submap, graph.submapCount() - 1, result.T_submap_keyframe, false});
    found = true;
  }
  if (!found) return {};
  const std::vector<std::size_t> chosen = confirmed(graph);
  return chosen.empty() ? std::vector<LoopClosure>{} : accept(graph, chosen);
}

scan_matching::SearchWindow LoopCloser::windowFor(const Eigen::Matrix3d& covariance) const {
  const double position = parameters_.sigmas * positionSigma(covariance);
  const double yaw = parameters_.sigmas * yawSigma(covariance);
  const double width = std::clamp(position, parameters_.min_window, parameters_.max_window);
  return {width, width, std::clamp(yaw, parameters_.min_angle, parameters_.max_angle)};
}

std::vector<LoopCloser::Candidate> LoopCloser::candidates(const SubmapGraph& graph) const {
  const std::size_t of = graph.submapCount() - 1;
  const auto gap = static_cast<std::size_t>(parameters_.min_gap);
  std::vector<Candidate> found;
  if (of < gap) return found;
  const Vec2 robot = newestPose(graph).position();
  const std::vector<Eigen::Matrix3d> uncertainty = graph.uncertaintyFrom(of);
  for (std::size_t submap = 0; submap + gap <= of; ++submap) {
    const Eigen::Matrix3d& covariance = uncertainty[submap];
    const bool known =
        positionSigma(covariance) < parameters_.known_position && yawSigma(covariance) < parameters_.known_yaw;
    if (known || isSaturated(graph, submap, of)) continue;
    const scan_matching::SearchWindow window = windowFor(covariance);
    const double distance = distanceTo(graph, submap, graph.T_map_submap(submap).inverse() * robot) - window.x;
    if (distance < parameters_.reach) found.push_back({submap, distance, window});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  if (found.size() > static_cast<std::size_t>(parameters_.max_candidates)) {
    found.resize(static_cast<std::size_t>(parameters_.max_candidates));
  }
  return found;
}

bool LoopCloser::isSaturated(const SubmapGraph& graph, std::size_t submap, std::size_t of) const {
  const auto& constraints = graph.graph().constraints();
  return std::count_if(constraints.begin(), constraints.end(), [&](const PoseConstraint& constraint) {
           return constraint.robust && constraint.from == submap && constraint.to == of;
         }) >= parameters_.max_per_pair;
}

bool LoopCloser::agree(const SubmapGraph& graph, const Hypothesis& a, const Hypothesis& b) const {
  const Pose2 T_a_b = graph.keyframe(a.keyframe).T_local_base.inverse() * graph.keyframe(b.keyframe).T_local_base;
  const Pose2 by_a = graph.T_map_submap(a.submap) * a.T_submap_keyframe.pose * T_a_b;
  const Pose2 by_b = graph.T_map_submap(b.submap) * b.T_submap_keyframe.pose;
  const Pose2 difference = by_a.inverse() * by_b;
  return difference.position().norm() < parameters_.agree_distance &&
         std::abs(difference.yaw) < parameters_.agree_angle;
}

void LoopCloser::forget(std::size_t newest) {
  const auto isOld = [&](const Hypothesis& hypothesis) {
    return hypothesis.keyframe + static_cast<std::size_t>(parameters_.confirm_within) < newest;
  };
  for (const Hypothesis& hypothesis : hypotheses_) {
    if (isOld(hypothesis) && !hypothesis.certain) counts_.add(ClosureVerdict::kUnconfirmed);
  }
  hypotheses_.erase(std::remove_if(hypotheses_.begin(), hypotheses_.end(), isOld), hypotheses_.end());
}

std::vector<std::size_t> LoopCloser::confirmed(const SubmapGraph& graph) const {
  const std::size_t newest = hypotheses_.back().keyframe;
  for (std::size_t i = hypotheses_.size(); i-- > 0 && hypotheses_[i].keyframe == newest;) {
    std::vector<std::size_t> chosen = supporters(graph, hypotheses_[i]);
    if (!isEnough(graph, hypotheses_[i], chosen)) continue;
    chosen.push_back(i);
    const auto isCertain = [&](std::size_t index) { return hypotheses_[index].certain; };
    chosen.erase(std::remove_if(chosen.begin(), chosen.end(), isCertain), chosen.end());
    return chosen;
  }
  return {};
}

std::vector<std::size_t> LoopCloser::supporters(const SubmapGraph& graph, const Hypothesis& hypothesis) const {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < hypotheses_.size(); ++j) {
    const Hypothesis& other = hypotheses_[j];
    if (other.keyframe != hypothesis.keyframe && agree(graph, other, hypothesis)) found.push_back(j);
  }
  return found;
}

bool LoopCloser::isEnough(const SubmapGraph& graph, const Hypothesis& hypothesis,
                          const std::vector<std::size_t>& supporters) const {
  if (supporters.empty()) return false;
  const Vec2 here = graph.keyframe(hypothesis.keyframe).T_local_base.position();
  std::size_t keyframes = 1;
  std::size_t last = hypothesis.keyframe;
  double travel = 0.0;
  for (const std::size_t index : supporters) {
    const std::size_t keyframe = hypotheses_[index].keyframe;
    if (keyframe != last) ++keyframes;
    last = keyframe;
    travel = std::max(travel, (graph.keyframe(keyframe).T_local_base.position() - here).norm());
  }
  const Pose2 found = graph.T_map_submap(hypothesis.submap) * hypothesis.T_submap_keyframe.pose;
  const double jump = (found.position() - newestPose(graph).position()).norm();
  const std::size_t asked = hypothesis.keyframe - hypotheses_[supporters.front()].keyframe + 1;
  return keyframes >= static_cast<std::size_t>(parameters_.confirmations) &&
         static_cast<double>(keyframes) >= parameters_.confirm_share * static_cast<double>(asked) &&
         travel >= parameters_.confirm_travel + parameters_.confirm_jump * jump;
}

bool LoopCloser::makesSense(const SubmapGraph& graph, const PoseGraph& before, const std::vector<Pose2>& then) {
  const std::vector<Pose2> now = sampledPoses(graph);
  double worse = 0.0;
  int views = 0;
  for (std::size_t submap = 0; submap < graph.submapCount(); ++submap) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      const std::size_t keyframe = i * sampling(graph);
      if (graph.gap(submap, keyframe) < static_cast<std::size_t>(parameters_.min_gap)) continue;
      const Pose2 seen_now = graph.T_map_submap(submap).inverse() * now[i];
      const Pose2 seen_then = before.pose(submap).inverse() * then[i];
      const bool moved = isJump(seen_then, seen_now, parameters_.verify_jump, parameters_.verify_jump / kSight);
      if (!moved || distanceTo(graph, submap, seen_now.position()) > kSight) continue;
      const surfaces::SurfacePoints points = search_.pointsOf(graph.keyframe(keyframe));
      worse += search_.contradiction(graph, submap, points, seen_now) -
               search_.contradiction(graph, submap, points, seen_then);
      ++views;
    }
  }
  return worse <= parameters_.max_inconsistency * views;
}

LoopClosure LoopCloser::closureOf(const SubmapGraph& graph, const Hypothesis& hypothesis) {
  const Pose2& T_submap_keyframe = hypothesis.T_submap_keyframe.pose;
  const std::size_t reference = graph.nearestKeyframe(hypothesis.submap, T_submap_keyframe);
  const Pose2 T_submap_reference = graph.T_submap_keyframe(hypothesis.submap, reference);
  return {hypothesis.keyframe,
          hypothesis.submap,
          reference,
          T_submap_reference.inverse() * T_submap_keyframe,
          graph.keyframe(hypothesis.keyframe).scan.stamp,
          graph.keyframe(reference).scan.stamp};
}

std::vector<LoopClosure> LoopCloser::accept(SubmapGraph& graph, const std::vector<std::size_t>& chosen) {
  const PoseGraph before = graph.graph();
  const std::vector<Pose2> then = sampledPoses(graph);
  std::vector<LoopClosure> closures;
  for (const std::size_t index : chosen) {
    Hypothesis& hypothesis = hypotheses_[index];
    graph.close(hypothesis.submap, hypothesis.of, hypothesis.keyframe, hypothesis.T_submap_keyframe);
    hypothesis.certain = true;
    closures.push_back(closureOf(graph, hypothesis));
  }
  graph.optimize();
  ClosureVerdict verdict = ClosureVerdict::kAccepted;
  if (!isSound(graph)) {
    verdict = ClosureVerdict::kDisagrees;
  } else if (!makesSense(graph, before, then)) {
    verdict = ClosureVerdict::kContradicts;
  }
  counts_.add(verdict, chosen.size());
  if (verdict == ClosureVerdict::kAccepted) return closures;
  graph.setGraph(before);
  hypotheses_.clear();
  return {};
}

}  // namespace frontier_pilot::slam
