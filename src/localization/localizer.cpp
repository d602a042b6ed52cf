#include "localization/localizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::localization {
namespace {

constexpr double kSigmas = 3.0;
constexpr double kLeastReach = 0.1;   // [m]
constexpr double kMostReach = 10.0;   // [m]: so that the search does not take too long
constexpr double kLeastAngle = 0.05;  // [rad]
constexpr double kPenalty = 0.0035;   // loss of score at a deviation of one standard deviation

/// Without a time limit: a known map is not given up, however long nothing matches.
slam::ScanTrackerParameters withoutEnd(slam::ScanTrackerParameters parameters) {
  parameters.max_silence = std::numeric_limits<double>::infinity();
  // A known map is not extended.
  parameters.sparse_distance = std::numeric_limits<double>::infinity();
  parameters.sparse_angle = std::numeric_limits<double>::infinity();
  return parameters;
}

double reachOf(double variance) { return std::clamp(kSigmas * std::sqrt(variance), kLeastReach, kMostReach); }

scan_matching::SearchRequest requestFor(const scan_matching::PoseWithCovariance& belief, double min_score) {
  scan_matching::SearchRequest request;
  request.expected = belief.pose;
  const Eigen::Matrix3d& covariance = belief.covariance;
  request.window = {reachOf(covariance(0, 0)), reachOf(covariance(1, 1)),
                    std::clamp(kSigmas * std::sqrt(covariance(2, 2)), kLeastAngle, kPi)};
  request.penalty = {kPenalty, kSigmas, std::max(request.window.x, request.window.y) / kSigmas,
                     request.window.yaw / kSigmas};
  request.min_score = min_score;
  return request;
}

}  // namespace

Localizer::Localizer(const slam::GraphSlamParameters& parameters, const OccupancyGrid& map,
                     const scan_matching::PoseWithCovariance& T_map_base, const std::optional<Pose2>& T_odom_base)
    : parameters_(parameters.local),
      surface_parameters_(parameters.surface),
      map_(parameters_.likelihood),
      tracker_(withoutEnd(parameters_.tracker)),
      sought_(T_map_base),
      T_odom_sought_(T_odom_base) {
  map_.add(surfaces::surfaceOf(map), Pose2());
  if (map_.empty()) return;
  pyramid_.emplace(map_.field(), scan_matching::pyramidTop(tracker_.usualWindow(), parameters_.likelihood.resolution));
}

slam::MatchVerdict Localizer::update(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base) {
  const surfaces::SurfacePoints points = surfaces::thinned(scan.points, surface_parameters_);
  if (sought_) {
    const slam::MatchVerdict verdict = find(points, T_odom_base);
    if (sought_) return verdict;
  }
  const slam::MatchTarget target{map_, *pyramid_, Pose2()};
  const slam::Track track = tracker_.track(points, scan.stamp, T_odom_base, target);
  T_map_odom_ = tracker_.T_local_odom();
  return track.verdict;
}

slam::MatchVerdict Localizer::find(const surfaces::SurfacePoints& points, const Pose2& T_odom_base) {
  if (!T_odom_sought_) T_odom_sought_ = T_odom_base;
  scan_matching::PoseWithCovariance belief = *sought_;
  belief.pose = belief.pose * T_odom_sought_->inverse() * T_odom_base;
  T_map_odom_ = belief.pose * T_odom_base.inverse();
  if (!pyramid_) return slam::MatchVerdict::kFirst;
  if (points.size() < static_cast<std::size_t>(parameters_.tracker.min_points)) return slam::MatchVerdict::kTooFew;
  const scan_matching::SearchRequest request = requestFor(belief, parameters_.tracker.min_score);
  if (!wide_pyramid_) {
    const int top = scan_matching::pyramidTop(request.window, parameters_.likelihood.resolution);
    wide_pyramid_.emplace(map_.field(), top);
  }
  const auto found = scan_matching::correlativeSearch(*wide_pyramid_, points, request);
  if (!found) return slam::MatchVerdict::kPoor;
  // As uncertain as the window is wide: a covariance of zero may just not have been filled in.
  const Eigen::Vector3d sigma = Eigen::Vector3d(request.window.x, request.window.y, request.window.yaw) / kSigmas;
  const scan_matching::PoseWithCovariance prior{belief.pose, sigma.cwiseAbs2().asDiagonal()};
  const scan_matching::Refinement refined =
      scan_matching::refine(map_, points, found->pose, prior, parameters_.tracker.refinement);
  if (refined.inliers < parameters_.tracker.min_inliers || !scan_matching::explains(map_, points, refined))
    return slam::MatchVerdict::kPoor;
  tracker_.reset(refined.pose * T_odom_base.inverse());
  sought_.reset();
  wide_pyramid_.reset();
  return slam::MatchVerdict::kMatched;
}

}  // namespace frontier_pilot::localization
