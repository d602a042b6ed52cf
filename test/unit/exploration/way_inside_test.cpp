#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;

/// A hall of 5 m x 3 m that is unknown at its right end; the robot is at the left.
class WayInside : public ExplorerTest {
 protected:
  static std::string hall() {
    std::string drawing = std::string(100, '#') + "\n";
    for (int row = 0; row < 58; ++row) {
      drawing +=
          "#" + std::string(9, '.') + (row == 29 ? "r" : ".") + std::string(79, '.') + std::string(10, '?') + "\n";
    }
    return drawing + std::string(100, '#') + "\n";
  }
  /// Across the middle of the hall; a gap is left at its upper wall.
  static exploration::ExplorationBounds barrier() {
    exploration::ExplorationBounds bounds;
    bounds.keep_out = {{{2.0, -1.0}, {3.0, -1.0}, {3.0, 2.2}, {2.0, 2.2}}};
    return bounds;
  }
  /// Whether the straight line touches the keep-out area of `barrier`.
  static bool crossesBarrier(const Vec2& from, const Vec2& to) {
    for (int i = 0; i <= 1000; ++i) {
      if (!barrier().contain(from + i / 1000.0 * (to - from))) return true;
    }
    return false;
  }
};

// [EXP-10]
TEST_F(WayInside, LeadsAroundAKeepOutAreaInStraightLegs_EXP_10) {
  show(hall());
  tick();
  ASSERT_TRUE(crossesBarrier(pose.position(), sent.goal.position())) << "without bounds it goes straight";
  explorer.setBounds(barrier(), world.map);
  int legs = 0;
  for (; tick().status.goals_reached == 0 && legs < 10; ++legs) {
    ASSERT_FALSE(crossesBarrier(pose.position(), sent.goal.position())) << "leg " << legs;
    pose = sent.goal;
    goalEnds(exploration::GoalEvent::Kind::kReached);
  }
  EXPECT_GT(pose.x, 3.5) << "stops on the way do not count as goals";
  EXPECT_GT(legs, 1);
  EXPECT_LE(legs, 4);
}

// [EXP-10]
TEST_F(WayInside, AGoalThatIsInSightIsSentAsItIs_EXP_10) {
  show(hall());
  tick();
  const Pose2 straight = sent.goal;
  exploration::ExplorationBounds bounds;
  bounds.keep_out = {{{2.0, -1.0}, {3.0, -1.0}, {3.0, 0.5}, {2.0, 0.5}}};
  explorer.setBounds(bounds, world.map);
  tickFor(3.0);
  EXPECT_EQ(sent.goal, straight);
}

// [EXP-10]
TEST_F(WayInside, AStopThatCannotBeReachedCountsAgainstTheGoalBehindIt_EXP_10) {
  show(hall());
  explorer.setBounds(barrier(), world.map);
  for (int i = 0; i < 2; ++i) {
    tickFor(0.3);
    goalEnds(exploration::GoalEvent::Kind::kAborted, "no path");
  }
  tick();
  EXPECT_EQ(notesWith("goal blacklisted: no path"), 1U);
}

}  // namespace
}  // namespace frontier_pilot
