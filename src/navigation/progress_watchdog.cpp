#include "navigation/progress_watchdog.h"

#include <limits>

namespace frontier_pilot::navigation {

void ProgressWatchdog::restart(Time now, const Vec2& position) {
  best_remaining_ = std::numeric_limits<double>::infinity();
  last_progress_ = now;
  anchor_ = position;
  anchored_ = now;
  moved_ = false;
}

ProgressWatchdog::Verdict ProgressWatchdog::update(Time now, const Vec2& position, double remaining) {
  if (remaining <= best_remaining_ - params_.progress_distance) {
    best_remaining_ = remaining;
    last_progress_ = now;
  }
  if ((position - anchor_).norm() > params_.oscillation_distance) {
    anchor_ = position;
    anchored_ = now;
    moved_ = true;
  }
  if (toSeconds(now - last_progress_) > params_.progress_timeout) return Verdict::kNoProgress;
  if (toSeconds(now - anchored_) > params_.oscillation_timeout) return Verdict::kOscillating;
  return Verdict::kFine;
}

}  // namespace frontier_pilot::navigation
