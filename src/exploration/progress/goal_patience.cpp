#include "exploration/progress/goal_patience.h"

namespace frontier_pilot::exploration {

GoalPatience::GoalPatience(const Vec2& position, double way, double speed, Time now)
    : way_(way), speed_(speed), sent_(now), moved_to_(position), moved_(now) {}

bool GoalPatience::isOver(const Vec2& position, double timeout, Time now) {
  constexpr double kLongest = 2.0;  // times what the way takes
  constexpr double kPause = 0.25;   // of the timeout: a robot that has not moved for so long stands
  constexpr double kSlow = 0.25;    // of its mean speed: a robot that moves no faster stands
  const double pause = kPause * timeout;
  if ((position - moved_to_).norm() >= kSlow * speed_ * pause) {
    moved_to_ = position;
    moved_ = now;
  }
  const double taken = toSeconds(now - sent_);
  const bool stands = toSeconds(now - moved_) >= pause;
  return taken >= timeout && (stands || taken >= kLongest * way_);
}

void GoalPatience::skip(Duration gap) {
  sent_ += gap;
  moved_ += gap;
}

}  // namespace frontier_pilot::exploration
