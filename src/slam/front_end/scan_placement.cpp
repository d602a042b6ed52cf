#include "slam/front_end/scan_placement.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::slam {
namespace {

constexpr double kPenalty = 0.0035;  ///< loss of score at a deviation of one standard deviation
constexpr double kLimit = 3.0;       ///< half width of the search, in standard deviations of odometry
// Points on new ground lower the score of the true pose. So in a corridor, after a while without scans, poses farther
// back score better, and the penalty must grow up to this limit to keep the pose where odometry says.
constexpr double kPenaltyLimit = 6.0;    ///< standard deviations, beyond which the penalty does not grow
constexpr double kContradiction = 16.0;  ///< squared Mahalanobis distance: exceeded by chance once in a thousand
constexpr double kEvidence = 30.0;       ///< least number of points on surfaces if most of the scan is on none
constexpr double kRival = 0.95;          ///< a second peak with this share of the score makes a match ambiguous
constexpr double kRidge = 0.9;           ///< least share of the peak's score halfway between two poses of one ridge
constexpr double kRivalDistance = 4;     ///< poses nearer than this to a peak belong to it [cells]
constexpr double kRivalAngle = 0.1;      ///< [rad]
constexpr double kSlide = 0.01;          ///< greatest ratio of the information along a corridor to that across it

/// Whether two estimates contradict each other.
bool contradict(const scan_matching::PoseWithCovariance& a, const scan_matching::PoseWithCovariance& b) {
  const Eigen::Vector3d apart = scan_matching::difference(a.pose, b.pose);
  return apart.dot((a.covariance + b.covariance).ldlt().solve(apart)) > kContradiction;
}

/// The covariance of an estimate by the points and `prior` together.
Eigen::Matrix3d posterior(const scan_matching::Refinement& refined, const scan_matching::PoseWithCovariance& prior) {
  return (refined.information + prior.covariance.inverse()).inverse();
}

/// The estimate by the points and odometry together.
scan_matching::PoseWithCovariance fused(const scan_matching::Refinement& refined,
                                        const scan_matching::PoseWithCovariance& odometry) {
  const Eigen::Matrix3d covariance = posterior(refined, odometry);
  const Eigen::Vector3d shift =
      covariance * refined.information * scan_matching::difference(refined.pose, odometry.pose);
  const Pose2& pose = odometry.pose;
  return {Pose2(pose.x + shift.x(), pose.y + shift.y(), normalizeAngle(pose.yaw + shift.z())), covariance};
}

/// An estimate in a map's frame, expressed in the local frame.
scan_matching::PoseWithCovariance moved(const Pose2& T_local_map, const scan_matching::PoseWithCovariance& belief) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Rotation2(T_local_map.yaw).matrix();
  return {T_local_map * belief.pose, turn * belief.covariance * turn.transpose()};
}

/// Whether the points hardly constrain the position in some direction.
bool slidesAlong(const Eigen::Matrix3d& information) {
  const Eigen::Matrix2d position = information.topLeftCorner<2, 2>();
  const Eigen::Vector2d known = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(position).eigenvalues();
  return known(0) < kSlide * known(1);
}

double resolutionOf(const MatchTarget& target) { return target.pyramid.geometry().resolution; }

}  // namespace

scan_matching::PoseWithCovariance beliefOf(const Pose2& pose, const PoseSigma& sigma) {
  const Eigen::Vector3d deviations(sigma.position, sigma.position, sigma.yaw);
  return {pose, deviations.array().square().matrix().asDiagonal()};
}

Track ScanPlacement::place(const surfaces::SurfacePoints& points, const MatchTarget& target,
                           const Prediction& prediction) const {
  Track matched = match(points, target, prediction);
  if (isBeyondTheMap(points, target, prediction, matched)) matched.verdict = MatchVerdict::kCarried;
  const bool placed = isPlaced(matched.verdict) && matched.verdict != MatchVerdict::kContradicts;
  if (!prediction.sparse || placed || matched.verdict == MatchVerdict::kTooFew) return matched;
  const Track extension = extend(points, target, prediction);
  return isPreferred(matched, extension, target, prediction) ? matched : extension;
}

bool ScanPlacement::isBeyondTheMap(const surfaces::SurfacePoints& points, const MatchTarget& target,
                                   const Prediction& prediction, const Track& match) const {
  if (match.verdict == MatchVerdict::kTooFew) return prediction.open;
  if (match.verdict != MatchVerdict::kPoor || !prediction.carried) return false;
  return scan_matching::isConsistent(target.map, points, prediction.T_map_base);
}

Track ScanPlacement::match(const surfaces::SurfacePoints& points, const MatchTarget& target,
                           const Prediction& prediction) const {
  Track track;
  track.verdict = MatchVerdict::kTooFew;
  if (points.size() < static_cast<std::size_t>(parameters_.min_points)) return track;
  track.verdict = MatchVerdict::kPoor;
  const auto found =
      scan_matching::correlativeSearch(target.pyramid, points, request(prediction, resolutionOf(target)));
  if (!found) return track;
  track.score = found->score;
  // Odometry is only a loose prior at first: it may be wrong, and must not bias the match then.
  const scan_matching::PoseWithCovariance loose = beliefOf(prediction.T_map_base, prediction.unseen);
  const scan_matching::Refinement refined =
      scan_matching::refine(target.map, points, found->pose, loose, parameters_.refinement);
  track.inliers = refined.inliers;
  track.slides = slidesAlong(refined.information);
  if (!fits(refined, points, target.map)) return track;
  const scan_matching::PoseWithCovariance seen{refined.pose, posterior(refined, loose)};
  const scan_matching::PoseWithCovariance odometry = beliefOf(prediction.T_map_base, prediction.odometry);
  if (!contradict(seen, odometry)) {
    track.verdict = MatchVerdict::kMatched;
    track.T_local_base = moved(target.T_local_map, fused(refined, odometry));
    return track;
  }
  if (!overrulesOdometry(refined, points, target, prediction)) return track;
  const bool ambiguous = hasRival(points, target.pyramid, prediction, *found);
  track.verdict = ambiguous ? MatchVerdict::kAmbiguous : MatchVerdict::kContradicts;
  track.T_local_base = moved(target.T_local_map, seen);
  return track;
}

Track ScanPlacement::extend(const surfaces::SurfacePoints& points, const MatchTarget& target,
                            const Prediction& prediction) const {
  Track track;
  track.verdict = MatchVerdict::kExtended;
  const auto found =
      scan_matching::correlativeSearch(target.pyramid, points, nearRequest(prediction, resolutionOf(target)));
  if (found) track.score = found->score;
  const scan_matching::PoseWithCovariance odometry = beliefOf(prediction.T_map_base, prediction.odometry);
  const Pose2& start = found ? found->pose : prediction.T_map_base;
  const scan_matching::Refinement refined =
      scan_matching::refine(target.map, points, start, odometry, parameters_.refinement);
  track.inliers = refined.inliers;
  track.T_local_base = moved(target.T_local_map, {refined.pose, posterior(refined, odometry)});
  return track;
}

bool ScanPlacement::isPreferred(const Track& match, const Track& extension, const MatchTarget& target,
                                const Prediction& prediction) const {
  // Within these bounds odometry is only worse than was assumed. Beyond them a scan may look like another place, and
  // the match must explain far more of it.
  constexpr double kNear = 0.5;       // [m]
  constexpr double kNearAngle = 0.4;  // [rad]
  constexpr double kShare = 0.5;
  if (match.verdict != MatchVerdict::kContradicts) return false;
  const Pose2 expected = target.T_local_map * prediction.T_map_base;
  return !isJump(expected, match.T_local_base.pose, kNear, kNearAngle) || extension.inliers < kShare * match.inliers;
}

bool ScanPlacement::fits(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                         const scan_matching::SurfaceMap& map) const {
  if (refined.inliers >= parameters_.min_inliers) return true;
  // A few points may lie on a surface by chance, as those of a hand in front of the scanner.
  const bool evident = refined.inliers * static_cast<double>(points.size()) >= kEvidence;
  return evident && refined.inliers >= parameters_.new_inliers &&
         scan_matching::isConsistent(map, points, refined.pose);
}

bool ScanPlacement::overrulesOdometry(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                                      const MatchTarget& target, const Prediction& prediction) const {
  constexpr double kWide = 0.75;  // [m]: so wide is the window only after a long time without a match
  return prediction.unseen.position < kWide || scan_matching::explains(target.map, points, refined);
}

scan_matching::SearchRequest ScanPlacement::request(const Prediction& prediction, double resolution) const {
  scan_matching::SearchRequest request;
  request.expected = prediction.T_map_base;
  const double reach =
      std::min(parameters_.max_distance, kLimit * prediction.odometry.position + prediction.unseen.position);
  const double turn = std::min(parameters_.max_angle, kLimit * prediction.odometry.yaw + prediction.unseen.yaw);
  request.window = {reach, reach, turn};
  request.penalty = {kPenalty, kPenaltyLimit, std::max(prediction.odometry.position, 0.5 * resolution),
                     std::max(prediction.odometry.yaw, 0.01)};
  request.min_score = parameters_.min_score;
  return request;
}

scan_matching::SearchRequest ScanPlacement::nearRequest(const Prediction& prediction, double resolution) const {
  constexpr double kLeastScore = 0.1;
  constexpr double kFirmPenalty = 0.01;
  scan_matching::SearchRequest near = request(prediction, resolution);
  const double reach = std::min(parameters_.max_distance, kLimit * prediction.odometry.position);
  near.window = {reach, reach, std::min(parameters_.max_angle, kLimit * prediction.odometry.yaw)};
  near.penalty.weight = kFirmPenalty;
  near.min_score = kLeastScore;
  return near;
}

bool ScanPlacement::hasRival(const surfaces::SurfacePoints& points, const scan_matching::MaxPyramid& pyramid,
                             const Prediction& prediction, const scan_matching::SearchResult& found) const {
  const double cell = pyramid.geometry().resolution;
  scan_matching::SearchRequest other = request(prediction, cell);
  other.exclusions = {{found.pose, kRivalDistance * cell, kRivalAngle}};
  other.min_score = kRival * found.score;
  const auto rival = scan_matching::correlativeSearch(pyramid, points, other);
  if (!rival) return false;
  // Poses along a corridor fit equally well, and so do all between them: that is a ridge, not two peaks.
  scan_matching::SearchRequest between;
  const Vec2 middle = 0.5 * (found.pose.position() + rival->pose.position());
  between.expected = Pose2(middle, found.pose.yaw + 0.5 * angleDifference(rival->pose.yaw, found.pose.yaw));
  between.window = {cell, cell, 0.0};
  between.min_score = kRidge * found.score;
  return !scan_matching::correlativeSearch(pyramid, points, between);
}

}  // namespace frontier_pilot::slam
