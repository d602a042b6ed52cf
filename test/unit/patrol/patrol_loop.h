#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "frontier_pilot/patrol/patrol.h"
#include "support/kinematic_base.h"

namespace frontier_pilot::test {

constexpr patrol::PatrolOrder kSquare{1.0, 1.0, 1.0};

/// A patrol, a base without noise, and the loop around them.
class PatrolLoop {
 public:
  explicit PatrolLoop(double frequency = 20.0, const Pose2& start = {}) : PatrolLoop(parameters(frequency), start) {}
  explicit PatrolLoop(const patrol::PatrolParameters& parameters, const Pose2& start = {})
      : base(start), patrol(parameters), period_(1.0 / parameters.frequency) {}
  static patrol::PatrolParameters parameters(double frequency) {
    patrol::PatrolParameters p;
    p.frequency = frequency;
    return p;
  }
  patrol::PatrolOutput start(const patrol::PatrolOrder& goal) { return patrol.start(goal, base.now()); }
  /// One cycle; `wheels`, if given, replaces the patrol's command on its way to the base.
  patrol::PatrolOutput cycle(const std::optional<Twist2>& wheels = std::nullopt) {
    if (fresh_odometry) inputs.odometry = base.sample();
    const patrol::PatrolOutput output = patrol.update(inputs, base.now());
    if (output.started_leg) legs.push_back(*output.started_leg);
    if (output.command) fastest.linear = std::max(fastest.linear, output.command->linear);
    if (output.command) fastest.angular = std::max(fastest.angular, output.command->angular);
    base.run(wheels ? *wheels : output.command.value_or(Twist2()), period_);
    return output;
  }
  /// Cycles until the patrol ends or `seconds` have passed.
  patrol::PatrolOutput run(double seconds, const std::optional<Twist2>& wheels = std::nullopt) {
    patrol::PatrolOutput output;
    const Time limit = base.now() + fromSeconds(seconds);
    do output = cycle(wheels);
    while (patrol.active() && base.now() < limit);
    return output;
  }

  KinematicBase base;
  patrol::Patrol patrol;
  patrol::PatrolInputs inputs;
  bool fresh_odometry = true;
  std::vector<int> legs;
  Twist2 fastest;

 private:
  double period_;
};

inline void expectEnd(const patrol::PatrolOutput& output, patrol::PatrolOutcome outcome) {
  EXPECT_EQ(output.outcome, outcome) << toString(output.outcome) << ": " << output.text;
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
}

inline void expectClosed(const PatrolLoop& loop, const Pose2& start) {
  EXPECT_LT((loop.base.pose().position() - start.position()).norm(), 0.02);
  EXPECT_NEAR(angleDifference(loop.base.pose().yaw, start.yaw), 0.0, kPi / 180.0);
}

}  // namespace frontier_pilot::test
