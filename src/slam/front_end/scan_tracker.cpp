#include "frontier_pilot/slam/scan_tracker.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::slam {
namespace {

// The error of odometry that does not depend on motion: its resolution, and the inaccuracy of its stamps.
constexpr double kLeastPosition = 0.003;  ///< [m]
constexpr double kLeastYaw = 0.002;       ///< [rad]

// The same while the wheels do not turn: any motion that a scan seems to show is then mostly noise.
constexpr double kStanding = 0.0003;       ///< [m, rad]
constexpr double kTurningWheels = 0.0001;  ///< the wheels turn if odometry moves by more than this [m, rad]

constexpr double kPenalty = 0.0035;  ///< loss of score at a deviation of one standard deviation
constexpr double kLimit = 3.0;       ///< half width of the search, in standard deviations of odometry
// Points on new ground lower the score of the true pose. So in a corridor, after a while without scans, poses farther
// back score better, and the penalty must grow up to this limit to keep the pose where odometry says.
constexpr double kPenaltyLimit = 6.0;        ///< standard deviations, beyond which the penalty does not grow
constexpr double kContradiction = 16.0;      ///< squared Mahalanobis distance: exceeded by chance once in a thousand
constexpr double kEvidence = 30.0;           ///< least number of points on surfaces if most of the scan is on none
constexpr double kMostContradictions = 0.1;  ///< greatest share of beams that are inconsistent with the map
constexpr double kRival = 0.95;              ///< a second peak with this share of the score makes a match ambiguous
constexpr double kRidge = 0.9;               ///< least share of the peak's score halfway between two poses of one ridge
constexpr double kRivalDistance = 4;         ///< poses nearer than this to a peak belong to it [cells]
constexpr double kRivalAngle = 0.1;          ///< [rad]
constexpr double kSlide = 0.01;              ///< greatest ratio of the information along a corridor to that across it

scan_matching::PoseWithCovariance beliefOf(const Pose2& pose, double position, double yaw) {
  return {pose, Eigen::Vector3d(position, position, yaw).array().square().matrix().asDiagonal()};
}

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, angleDifference(a.yaw, b.yaw)};
}

/// Whether two estimates contradict each other.
bool contradict(const scan_matching::PoseWithCovariance& a, const scan_matching::PoseWithCovariance& b) {
  const Eigen::Vector3d apart = difference(a.pose, b.pose);
  return apart.dot((a.covariance + b.covariance).ldlt().solve(apart)) > kContradiction;
}

/// The estimate by the points and odometry together.
scan_matching::PoseWithCovariance fused(const scan_matching::Refinement& refined,
                                        const scan_matching::PoseWithCovariance& odometry) {
  const Eigen::Matrix3d covariance = (refined.information + odometry.covariance.inverse()).inverse();
  const Eigen::Vector3d shift = covariance * refined.information * difference(refined.pose, odometry.pose);
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

}  // namespace

const char* toString(MatchVerdict verdict) {
  switch (verdict) {
    case MatchVerdict::kFirst:
      return "first scan";
    case MatchVerdict::kMatched:
      return "matched";
    case MatchVerdict::kContradicts:
      return "matched, contradicts odometry";
    case MatchVerdict::kTooFew:
      return "too few returns";
    case MatchVerdict::kPoor:
      return "does not fit the map";
    case MatchVerdict::kAmbiguous:
      return "ambiguous";
    case MatchVerdict::kLost:
      return "lost, new submap begun";
  }
  return "unknown";
}

const char* describe(const Track& track) {
  if (track.verdict == MatchVerdict::kMatched && track.slides) return "matched, position along the walls from odometry";
  return toString(track.verdict);
}

ScanTracker::Sigma ScanTracker::grown(const Sigma& sigma, const Pose2& motion) const {
  const OdometryTrust& trust = parameters_.odometry;
  const double driven = motion.position().norm();
  const double turned = std::abs(motion.yaw);
  return {std::hypot(sigma.position, trust.distance * std::sqrt(driven)),
          std::hypot(sigma.yaw, trust.yaw_distance * std::sqrt(driven), trust.yaw_turn * std::sqrt(turned))};
}

ScanTracker::Prediction ScanTracker::predict(Time stamp, const Pose2& T_odom_base, const Pose2& T_local_map) const {
  const Pose2 T_map_base = T_local_map.inverse() * T_local_odom_ * T_odom_base;
  if (!last_) return {T_map_base, {kLeastPosition, kLeastYaw}, {kLeastPosition, kLeastYaw}};
  const Pose2 motion = last_->T_odom_base.inverse() * T_odom_base;
  const bool stands = last_->matched == last_->stamp && !isJump(Pose2(), motion, kTurningWheels, kTurningWheels);
  const Sigma sigma = grown(last_->sigma, motion);
  const Sigma odometry = stands ? Sigma{kStanding, kStanding}
                                : Sigma{std::hypot(sigma.position, kLeastPosition), std::hypot(sigma.yaw, kLeastYaw)};
  const double silence = std::max(0.0, toSeconds(stamp - last_->matched));
  return {T_map_base,
          odometry,
          {odometry.position + parameters_.odometry.unmeasured_speed * silence,
           odometry.yaw + parameters_.odometry.unmeasured_turn * silence}};
}

Track ScanTracker::track(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
                         const std::optional<MatchTarget>& target) {
  // The clock was set back: the time without a match counts from now.
  if (last_ && stamp < last_->stamp) last_->matched = stamp;
  Track track;
  track.T_local_base.pose = T_local_odom_ * T_odom_base;
  if (target) {
    const Prediction prediction = predict(stamp, T_odom_base, target->T_local_map);
    track.T_local_base = beliefOf(track.T_local_base.pose, prediction.odometry.position, prediction.odometry.yaw);
    const Track matched = match(points, *target, prediction);
    if (isMatched(matched.verdict)) {
      track = matched;
    } else {
      track.verdict = matched.verdict;
      track.score = matched.score;
      track.inliers = matched.inliers;
    }
    const bool silent = last_ && toSeconds(stamp - last_->matched) > parameters_.max_silence;
    if (silent && (track.verdict == MatchVerdict::kPoor || track.verdict == MatchVerdict::kAmbiguous))
      track.verdict = MatchVerdict::kLost;
  }
  remember(stamp, T_odom_base, track);
  return track;
}

bool ScanTracker::fits(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                       const scan_matching::SurfaceMap& map) const {
  if (refined.inliers >= parameters_.min_inliers) return true;
  // A few points may lie on a surface by chance, as those of a hand in front of the scanner.
  const bool evident = refined.inliers * static_cast<double>(points.size()) >= kEvidence;
  return evident && refined.inliers >= parameters_.new_inliers &&
         scan_matching::inconsistentShare(map, points, refined.pose) <= kMostContradictions;
}

bool ScanTracker::overrulesOdometry(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                                    const MatchTarget& target, const Prediction& prediction) const {
  // A long time without a match makes the window wide, and half of the points may lie on surfaces by chance then.
  constexpr double kWide = 0.75;  // [m]
  constexpr double kSure = 0.8;
  return prediction.unseen.position < kWide || refined.inliers >= kSure ||
         scan_matching::inconsistentShare(target.map, points, refined.pose) <= kMostContradictions;
}

Track ScanTracker::match(const surfaces::SurfacePoints& points, const MatchTarget& target,
                         const Prediction& prediction) const {
  Track track;
  track.verdict = MatchVerdict::kTooFew;
  if (points.size() < static_cast<std::size_t>(parameters_.min_points)) return track;
  track.verdict = MatchVerdict::kPoor;
  const auto found = find(points, target.pyramid, prediction);
  if (!found) return track;
  track.score = found->score;
  // Odometry is only a loose prior at first: it may be wrong, and must not bias the match then.
  const scan_matching::PoseWithCovariance loose =
      beliefOf(prediction.T_map_base, prediction.unseen.position, prediction.unseen.yaw);
  const scan_matching::Refinement refined =
      scan_matching::refine(target.map, points, found->pose, loose, parameters_.refinement);
  track.inliers = refined.inliers;
  track.slides = slidesAlong(refined.information);
  if (!fits(refined, points, target.map)) return track;
  const scan_matching::PoseWithCovariance seen{refined.pose,
                                               (refined.information + loose.covariance.inverse()).inverse()};
  const scan_matching::PoseWithCovariance odometry =
      beliefOf(prediction.T_map_base, prediction.odometry.position, prediction.odometry.yaw);
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

scan_matching::SearchRequest ScanTracker::request(const Prediction& prediction, double resolution) const {
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

std::optional<scan_matching::SearchResult> ScanTracker::find(const surfaces::SurfacePoints& points,
                                                             const scan_matching::MaxPyramid& pyramid,
                                                             const Prediction& prediction) const {
  return scan_matching::correlativeSearch(pyramid, points, request(prediction, pyramid.geometry().resolution));
}

bool ScanTracker::hasRival(const surfaces::SurfacePoints& points, const scan_matching::MaxPyramid& pyramid,
                           const Prediction& prediction, const scan_matching::SearchResult& found) const {
  const double cell = pyramid.geometry().resolution;
  scan_matching::SearchRequest other = request(prediction, cell);
  other.exclusion = scan_matching::SearchExclusion{found.pose, kRivalDistance * cell, kRivalAngle};
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

scan_matching::SearchWindow ScanTracker::usualWindow() const {
  constexpr double kUsualGap = 0.3;
  const double reach =
      parameters_.odometry.unmeasured_speed * kUsualGap + kLimit * parameters_.odometry.distance * std::sqrt(kUsualGap);
  return {reach, reach, parameters_.odometry.unmeasured_turn * kUsualGap};
}

void ScanTracker::remember(Time stamp, const Pose2& T_odom_base, const Track& track) {
  const bool known = isMatched(track.verdict) || !last_ || track.verdict == MatchVerdict::kFirst ||
                     track.verdict == MatchVerdict::kLost;
  const Sigma sigma = known ? Sigma{} : grown(last_->sigma, last_->T_odom_base.inverse() * T_odom_base);
  last_ = Last{stamp, T_odom_base, known ? stamp : last_->matched, sigma};
  T_local_odom_ = track.T_local_base.pose * T_odom_base.inverse();
}

void ScanTracker::reset(const Pose2& T_local_odom) {
  T_local_odom_ = T_local_odom;
  last_.reset();
}

}  // namespace frontier_pilot::slam
