#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/parameters.h"

namespace frontier_pilot::navigation {

/// Notices that a driving robot gets nowhere: no nearer to its goal, or nearer all the time but round and round on the
/// spot (each new plan starts the measure of nearness anew, the place does not).
class ProgressWatchdog {
 public:
  enum class Verdict { kFine, kNoProgress, kOscillating };

  explicit ProgressWatchdog(const WatchdogParams& params = {}) : params_(params) {}

  void restart(Time now, const Vec2& position);
  /// The way to go is another one, and may be longer.
  void newPath(double remaining) { best_remaining_ = remaining; }
  Verdict update(Time now, const Vec2& position, double remaining);
  /// Whether the robot has left the place of the last `restart` or trouble behind.
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
