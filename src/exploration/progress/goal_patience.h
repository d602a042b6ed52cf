#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::exploration {

/// How long a goal may take. [EXP-5] A robot that stands has the timeout. One that is still moving then, because the
/// goal is far and the robot slow, may go on until twice the time that its way should take has passed since the goal
/// was sent.
class GoalPatience {
 public:
  /// The goal has been sent from `position`; its way takes `way` [s] at the robot's mean speed [m/s].
  GoalPatience(const Vec2& position, double way, double speed, Time now);

  /// To be asked in every tick. `timeout` [s].
  bool isOver(const Vec2& position, double timeout, Time now);

  /// So much time was no time: the clock jumped ahead, or nothing ran.
  void skip(Duration gap);

 private:
  double way_, speed_;
  Time sent_;
  Vec2 moved_to_;  ///< where the robot was at `moved_`
  Time moved_;     ///< when it had moved far enough to count as under way
};

}  // namespace frontier_pilot::exploration
