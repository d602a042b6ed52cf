#include "slam/front_end/local_slam.h"

#include <utility>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::slam {
namespace {

/// Whether most of the beams met nothing, or there are few returns at all: some drivers report a beam without a return
/// as invalid. If most beams end nearer than the scanner measures, it is covered.
bool isOpen(const surfaces::SurfaceScan& scan) {
  constexpr std::size_t kFew = 50;
  if (scan.too_near > scan.usableBeams()) return false;
  const bool few = !scan.points.empty() && scan.points.size() < kFew;
  return few || scan.free.size() > scan.points.size();
}

}  // namespace

LocalSlam::LocalSlam(const LocalSlamParameters& parameters, const surfaces::SurfaceParameters& surface)
    : parameters_(parameters), surface_parameters_(surface), tracker_(parameters.tracker) {}

LocalSlamOutput LocalSlam::update(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base) {
  surfaces::SurfacePoints points = surfaces::thinned(scan.points, surface_parameters_);
  LocalSlamOutput output;
  output.track = tracker_.track(points, scan.stamp, T_odom_base, target(), isOpen(scan));
  if (!isKeyframe(output.track) || (points.empty() && !isOpen(scan))) {
    if (isMatched(output.track.verdict)) updateKnown(scan.points, output.track.T_local_base.pose);
    return output;
  }
  const bool elsewhere = output.track.verdict == MatchVerdict::kLost || leavesSubmaps(output.track.T_local_base.pose);
  if (elsewhere) output.finished = takeOldest(active_.size());
  output.keyframe = Keyframe{keyframes_++, scan, std::move(points), output.track.T_local_base.pose, T_odom_base};
  insert(*output.keyframe);
  const bool replaced = active_.size() > 1 && isHalfFull(*active_.back());
  if (replaced) output.finished.push_back(takeOldest(1).front());
  return output;
}

std::optional<MatchTarget> LocalSlam::target() {
  if (active_.empty()) return std::nullopt;
  const Submap& submap = *active_.front();
  if (!pyramid_) {
    const int top = scan_matching::pyramidTop(tracker_.usualWindow(), parameters_.likelihood.resolution);
    pyramid_.emplace(submap.map.field(), top);
  }
  return MatchTarget{submap.map, *pyramid_, submap.T_local_submap};
}

bool LocalSlam::isKeyframe(const Track& track) const {
  if (track.verdict == MatchVerdict::kFirst || track.verdict == MatchVerdict::kLost) return true;
  // A scan that shows new surfaces becomes a keyframe after a tenth of the usual distance or angle.
  constexpr double kSoon = 0.1;
  const bool known = track.inliers >= parameters_.keyframe_inliers || track.verdict == MatchVerdict::kCarried;
  const double share = known ? 1.0 : kSoon;
  return isPlaced(track.verdict) && isJump(*T_local_keyframe_, track.T_local_base.pose,
                                           share * parameters_.keyframe_distance, share * parameters_.keyframe_angle);
}

/// Whether odometry has jumped so far that no submap can hold both ends: its grid covers all that lies between them.
bool LocalSlam::leavesSubmaps(const Pose2& T_local_base) const {
  return T_local_keyframe_ &&
         (T_local_base.position() - T_local_keyframe_->position()).norm() > parameters_.submap_length;
}

void LocalSlam::insert(const Keyframe& keyframe) {
  if (active_.empty() || isHalfFull(*active_.back())) begin(keyframe.T_local_base);
  const Pose2 T_local_last = T_local_keyframe_.value_or(keyframe.T_local_base);
  const double driven = (keyframe.T_local_base.position() - T_local_last.position()).norm();
  const surfaces::SurfacePoints dense = surfaces::filled(keyframe.scan.points, surface_parameters_);
  for (const auto& submap : active_) {
    if (!submap->keyframes.empty()) submap->length += driven;
    submap->map.add(dense, submap->T_local_submap.inverse() * keyframe.T_local_base);
    submap->keyframes.push_back(keyframe.id);
  }
  T_local_keyframe_ = keyframe.T_local_base;
  pyramid_.reset();
}

void LocalSlam::updateKnown(const surfaces::SurfacePoints& surface, const Pose2& T_local_base) {
  const surfaces::SurfacePoints dense = surfaces::filled(surface, surface_parameters_);
  for (const auto& submap : active_) submap->map.updateKnown(dense, submap->T_local_submap.inverse() * T_local_base);
}

bool LocalSlam::isHalfFull(const Submap& submap) const {
  return 2 * submap.keyframes.size() >= static_cast<std::size_t>(parameters_.submap_keyframes) ||
         2.0 * submap.length >= parameters_.submap_length;
}

std::vector<std::shared_ptr<const Submap>> LocalSlam::takeOldest(std::size_t count) {
  const auto end = active_.begin() + static_cast<std::ptrdiff_t>(count);
  std::vector<std::shared_ptr<const Submap>> taken(active_.begin(), end);
  active_.erase(active_.begin(), end);
  return taken;
}

void LocalSlam::begin(const Pose2& T_local_submap) {
  auto submap = std::make_shared<Submap>();
  submap->id = submaps_++;
  submap->T_local_submap = T_local_submap;
  submap->map = scan_matching::SurfaceMap(parameters_.likelihood);
  active_.push_back(std::move(submap));
}

void LocalSlam::reset() { *this = LocalSlam(parameters_, surface_parameters_); }

}  // namespace frontier_pilot::slam
