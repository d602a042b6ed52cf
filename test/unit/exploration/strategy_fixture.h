#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "exploration/goal_strategy.h"
#include "support/ascii_world.h"

namespace frontier_pilot::test {

inline exploration::ExplorerParameters touring() {
  exploration::ExplorerParameters parameters;
  parameters.robot.limits.max_linear = 0.5;
  parameters.tour.put_off_share = parameters.tour.left_share = 0.0;  // the drawings are small
  return parameters;
}

/// One decision of a strategy on a drawing.
class Strategies : public ::testing::Test {
 protected:
  std::optional<exploration::ChosenGoal> choose(const std::string& drawing,
                                                const exploration::ExplorerParameters& parameters = touring()) {
    if (strategy == nullptr || parameters.strategy != "tour") strategy = exploration::makeStrategy(parameters);
    world = test::drawWorld(drawing, 0.1);
    evaluator.setMap(world.map, world.map.geometry().rect());
    return chooseAgain();
  }
  std::optional<exploration::ChosenGoal> chooseAgain() { return chooseFrom(world.point('r')); }
  std::optional<exploration::ChosenGoal> chooseFrom(const Vec2& robot) {
    evaluator.evaluate({robot, robot, &history, 0.0});
    situation.T_map_robot = Pose2(robot, 0.0);
    return strategy->choose(evaluator, situation);
  }
  double distanceTo(const exploration::ChosenGoal& goal, char mark) {
    return (goal.position - world.point(mark)).norm();
  }

  exploration::FrontierEvaluator evaluator{exploration::FrontierParameters{}, RobotModel{}.drivenOutline()};
  exploration::GoalHistory history{exploration::BlacklistParameters{}, 1};
  std::unique_ptr<exploration::GoalStrategy> strategy;
  exploration::Situation situation;
  test::AsciiWorld world;
};

}  // namespace frontier_pilot::test
