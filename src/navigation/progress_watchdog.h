#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/parameters.h"

namespace frontier_pilot::navigation {

/// Notices that a driving robot gets nowhere: it comes no nearer to its goal, or it stays in one place while new plans
/// let it seem to make progress (each restarts the measure of progress, but not the check of the place).
class ProgressWatchdog {
 public:
  enum class Verdict { kFine, kNoProgress, kOscillating };

  explicit ProgressWatchdog(const WatchdogParams& params = {}) : params_(params) {}

  void restart(Time now, const Vec2& position);
  /// A new path, `remaining` [m] long and possibly longer than the old one, restarts the measure of progress.
  void newPath(double remaining) { best_remaining_ = remaining; }
  Verdict update(Time now, const Vec2& position, double remaining);
  /// Whether the robot has moved farther than oscillation_distance since the last `restart`.
  bool hasMoved() const { return moved_; }

 private:
  WatchdogParams params_;
  double best_remaining_ = 0.0;
  Time last_progress_;
  Vec2 anchor_ = Vec2::Zero();
  Time anchored_;
  bool moved_ = false;
};

}  // namespace frontier_pilot::navigation
