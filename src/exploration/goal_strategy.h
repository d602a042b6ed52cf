#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exploration/frontier_evaluator.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// The mean speed of a robot on its way [m/s], for which costs in seconds are reckoned.
inline double meanSpeed(const RobotLimits& limits) {
  constexpr double kShareOfMaximum = 0.9;
  return kShareOfMaximum * limits.max_linear;
}

/// What the order of the goals depends on besides the frontiers.
struct Situation {
  Pose2 T_map_robot;
  std::optional<Pose2> current;  ///< the goal being driven to
  bool keep_current = false;     ///< the current goal competes too, even if it fails a filter by now
  SharedWork* shared = nullptr;  ///< what is left to others; null: the robot is alone
  std::optional<Vec2> home;      ///< where the robot has to be at the end, if that matters
};

/// The goal that a strategy has chosen.
struct ChosenGoal {
  Vec2 position = Vec2::Zero();  ///< [m]
  double yaw = 0.0;              ///< [rad]
  double distance = 0.0;         ///< travel distance [m]
  double area = 0.0;             ///< unknown area that it is expected to show [m^2]
  std::string why;               ///< what speaks for it
  std::vector<Vec2> tour;        ///< this and the goals planned to follow [m]; empty if the strategy plans none
};

/// Decides which goal comes next.
class GoalStrategy {
 public:
  virtual ~GoalStrategy() = default;
  /// The next goal for the frontiers as they have just been evaluated; nullopt if none can be selected. Sets the scores
  /// or the places in the order of `evaluator.frontiers()`.
  virtual std::optional<ChosenGoal> choose(FrontierEvaluator& evaluator, const Situation& situation) = 0;
  /// The robot has been at the last goal, but most of what it expected to see there stayed unknown.
  virtual void stayedUnknown() {}
  /// Forgets what it has learned.
  virtual void reset() {}
  /// Time between two choices while the robot drives, as a share of decision_period.
  virtual double decisionPeriods() const { return 1.0; }
};

/// Never null. Throws std::invalid_argument if no strategy has this name.
std::unique_ptr<GoalStrategy> makeStrategy(const ExplorerParameters& parameters);

}  // namespace frontier_pilot::exploration
