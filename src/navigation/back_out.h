#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/navigation/recovery.h"

namespace frontier_pilot::navigation {

/// The recovery that backs up along the way that the robot has come (recovery.h).
class BackOut {
 public:
  BackOut(const RecoveryParams& params, const RobotModel& robot, double command_lifetime);

  RecoveryStep update(const RecoveryInputs& in, Time now);

 private:
  void begin(const RecoveryInputs& in);
  bool hasBackedEnough(const RecoveryInputs& in);
  /// The point of the way to steer for, in the base frame; nullopt at its end, and if it is not behind the robot. Where
  /// that is so before the robot has moved, the way is replaced by a straight one.
  std::optional<Vec2> target(const Pose2& T_map_base);
  /// As far behind the robot as it backs up.
  Vec2 straightBehind(const Pose2& T_map_base) const;
  /// Whether backing up by `command`, for as long as the base obeys it if no other comes, brings the outline no nearer
  /// to an obstacle than it is and than it may be, and keeps off what the map shows.
  bool isFree(const Twist2& command, const RecoveryInputs& in) const;

  /// Whether it has got no farther for the time that is allowed.
  bool isOverdue(const Vec2& position, Time now);

  RecoveryParams params_;
  RobotLimits limits_;
  Outline outline_;        ///< with the margin of recoveries
  double ahead_;           ///< for how long the base may obey a command [s]
  std::vector<Vec2> way_;  ///< back to where the robot came from, the nearest first; begun when not empty
  std::size_t next_ = 0;
  Vec2 start_ = Vec2::Zero();
  bool could_turn_ = true;  ///< where it began
  double checked_ = 0.0;    ///< how far the robot had backed up when a path was last looked for [m]
  std::optional<Time> blocked_since_;
  Vec2 anchor_ = Vec2::Zero();    ///< where it last got on
  std::optional<Time> anchored_;  ///< and when
};

}  // namespace frontier_pilot::navigation
