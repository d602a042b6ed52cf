#include "mapping/localization_watch.h"

namespace frontier_pilot::mapping {
namespace {

constexpr double kByOdometry = 2.0;  // [m] for which odometry alone is good enough
constexpr double kStep = 0.05;       // [m] below which odometry may be the jitter of a robot that stands

}  // namespace

void LocalizationWatch::lookFor(bool has_walls) {
  can_be_found_ = has_walls;
  localized_ = !has_walls;
  at_.reset();
}

void LocalizationWatch::reset() {
  can_be_found_ = localized_ = true;
  at_.reset();
}

void LocalizationWatch::take(bool located, const Pose2& T_odom_base) {
  if (keeps_map_ && !can_be_found_) return;
  if (located) {
    at_ = T_odom_base;
    driven_ = 0.0;
    localized_ = true;
    return;
  }
  const double step = at_ ? (T_odom_base.position() - at_->position()).norm() : 0.0;
  if (step >= kStep) {
    driven_ += step;
    at_ = T_odom_base;
  }
  localized_ = localized_ && keeps_map_ && at_ && driven_ <= kByOdometry;
}

}  // namespace frontier_pilot::mapping
