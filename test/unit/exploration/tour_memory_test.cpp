#include <algorithm>

#include "strategy_fixture.h"

namespace frontier_pilot {
namespace {

using test::Strategies;

/// A corridor of 12 m, closed or going on at either end; the robot in its middle.
std::string corridor(char left, char right) {
  std::string drawing = std::string(120, '#') + "\n";
  for (int row = 0; row < 15; ++row) {
    drawing += left + std::string(59, '.') + (row == 7 ? "r" : ".") + std::string(58, '.') + right + "\n";
  }
  return drawing + std::string(120, '#') + "\n";
}

class TourMemory : public Strategies {
 protected:
  /// Whether the robot at `x` [m] goes on to the end that it is driving to.
  bool goesOnAt(double x) {
    const exploration::ChosenGoal goal = *chooseFrom(Vec2(x, kMiddle.y()));
    const bool goes_on = (goal.position.x() < kMiddle.x()) == (situation.current->x < kMiddle.x());
    situation.current = Pose2(goal.position, goal.yaw);
    return goes_on;
  }
  /// Whether `goal` is the own one of a frontier.
  bool isOwnGoal(const Vec2& goal) const {
    const GridGeometry& geometry = evaluator.map().geometry();
    return std::any_of(evaluator.frontiers().begin(), evaluator.frontiers().end(), [&](const exploration::Frontier& f) {
      return geometry.cellAt(f.goal) == geometry.cellAt(goal);
    });
  }

  const Vec2 kMiddle{6.0, 0.85};
};

// [EXP-9]
TEST_F(TourMemory, EveryChangeOfMindHasToBePaidTwiceAsWellAsTheLastOne_EXP_9) {
  ASSERT_TRUE(choose(corridor('?', '?')));
  situation.current = Pose2(chooseFrom(Vec2(5.0, kMiddle.y()))->position, 0.0);
  ASSERT_LT(situation.current->x, kMiddle.x());
  EXPECT_FALSE(goesOnAt(7.0)) << "4 s are worth a first change";
  EXPECT_TRUE(goesOnAt(5.0)) << "but not a second one";
  EXPECT_FALSE(goesOnAt(4.0)) << "8 s are";
  EXPECT_TRUE(goesOnAt(8.0)) << "but not worth a third one";
  situation.current.reset();  // the goal has been seen
  situation.current = Pose2(chooseFrom(Vec2(5.0, kMiddle.y()))->position, 0.0);
  ASSERT_LT(situation.current->x, kMiddle.x());
  EXPECT_FALSE(goesOnAt(7.0)) << "it counts anew";
}

// [EXP-9]
TEST_F(TourMemory, ARobotThatIsNearlyAtItsGoalArrivesThere_EXP_9) {
  ASSERT_TRUE(choose(corridor('#', '?')));
  // From there something is to be seen at the end of the corridor, but from nearer far more.
  situation.current = Pose2(4.65, kMiddle.y(), 0.0);
  situation.keep_current = true;
  const auto nearly = chooseFrom(Vec2(4.25, kMiddle.y()));
  EXPECT_EQ(nearly->position, situation.current->position());
  EXPECT_EQ(nearly->why, "nearly reached");
  EXPECT_GT(chooseFrom(Vec2(3.45, kMiddle.y()))->position.x(), 6.0) << "not from farther away";
  situation.keep_current = false;
  EXPECT_GT(chooseFrom(Vec2(4.25, kMiddle.y()))->position.x(), 6.0) << "nor if the goal is to be replaced";
}

// [EXP-9]
TEST_F(TourMemory, AFrontierThatStayedUnknownIsSeenFromElsewhereAgainWhenTheMapAroundItHasChanged_EXP_9) {
  const Vec2 first = choose(corridor('#', '?'))->position;
  ASSERT_FALSE(isOwnGoal(first));
  strategy->stayedUnknown();
  EXPECT_TRUE(isOwnGoal(chooseAgain()->position));
  EXPECT_TRUE(isOwnGoal(chooseAgain()->position)) << "for as long as nothing changes";
  for (const std::int8_t value : {kUnknown, kFree}) {
    for (int y = 7; y < 10; ++y) std::fill_n(world.map.row(y) + 113, 5, value);
    evaluator.setMap(world.map, world.map.geometry().rect());
  }
  EXPECT_FALSE(isOwnGoal(chooseAgain()->position));
}

}  // namespace
}  // namespace frontier_pilot
