#include "mapping/localization_watch.h"

namespace frontier_pilot::mapping {
namespace {

constexpr double kByOdometry = 2.0;  // [m] for which odometry alone is good enough

}  // namespace

void LocalizationWatch::lookFor(bool has_walls) {
  can_be_found_ = has_walls;
  localized_ = !has_walls;
  found_at_.reset();
}

void LocalizationWatch::reset() {
  can_be_found_ = localized_ = true;
  found_at_.reset();
}

void LocalizationWatch::take(bool located, const Pose2& T_odom_base) {
  if (keeps_map_ && !can_be_found_) return;
  if (located) {
    found_at_ = T_odom_base;
    localized_ = true;
    return;
  }
  const bool by_odometry =
      keeps_map_ && found_at_ && (T_odom_base.position() - found_at_->position()).norm() <= kByOdometry;
  localized_ = localized_ && by_odometry;
}

}  // namespace frontier_pilot::mapping
