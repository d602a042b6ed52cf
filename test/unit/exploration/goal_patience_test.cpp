#include "exploration/progress/goal_patience.h"

#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using exploration::GoalPatience;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

constexpr double kSpeed = 0.2;      // [m/s]
constexpr double kTimeout = 120.0;  // [s]

/// When patience ends with a robot that drives at `speed` [m/s] for `driving` [s] and then stands; the way takes `way`
/// [s].
double endsAfter(double way, double speed, double driving) {
  const Time start = timeFromSeconds(50.0);
  GoalPatience patience(Vec2::Zero(), way, kSpeed, start);
  for (double t = 0.0; t < 1e4; t += 0.1) {
    const Vec2 position(speed * std::min(t, driving), 0.0);
    if (patience.isOver(position, kTimeout, start + fromSeconds(t))) return t;
  }
  return 1e4;
}

// [EXP-5]
TEST(GoalPatience, ARobotThatStandsHasTheTimeout) {
  EXPECT_NEAR(endsAfter(20.0, 0.0, 0.0), kTimeout, 0.2);
  EXPECT_NEAR(endsAfter(1000.0, 0.0, 0.0), kTimeout, 0.2) << "however far the goal is";
  EXPECT_NEAR(endsAfter(1000.0, kSpeed, 60.0), kTimeout, 0.2) << "it has stopped long before";
}

// [EXP-5]
TEST(GoalPatience, ARobotOnAFarWayHasTwiceTheTimeOfThatWay) {
  EXPECT_NEAR(endsAfter(300.0, kSpeed, 1e4), 600.0, 0.2);
  EXPECT_NEAR(endsAfter(20.0, kSpeed, 1e4), kTimeout, 0.2) << "the timeout is long enough for a near goal";
}

// [EXP-5]
TEST(GoalPatience, OnAFarWayItEndsAQuarterOfTheTimeoutAfterTheRobotHasStopped) {
  const double end = endsAfter(300.0, kSpeed, 200.0);
  EXPECT_GT(end, 200.0 + 0.25 * kTimeout - 8.0);
  EXPECT_LT(end, 200.0 + 0.25 * kTimeout + 1.0);
}

// [EXP-5]
TEST(GoalPatience, ARobotThatHardlyMovesStands) { EXPECT_NEAR(endsAfter(1000.0, 0.1 * kSpeed, 1e4), kTimeout, 0.2); }

class SlowExplorer : public test::ExplorerTest {
 protected:
  static exploration::ExplorerParameters slow() {
    exploration::ExplorerParameters parameters = shortSighted();
    parameters.robot.limits.max_linear = 0.005;
    return parameters;
  }
  SlowExplorer() : ExplorerTest(slow()) {}
};

// [EXP-5]
TEST_F(SlowExplorer, AGoalThatIsFartherThanTheTimeoutIsNotGivenUpOnTheWay) {
  show(kTwoEnds);
  tick();
  const Vec2 goal = sent.goal.position();
  const Vec2 step = 0.0004 * (goal - pose.position()).normalized();
  for (int i = 0; i < 1500; ++i) {
    pose = Pose2(pose.position() + step, pose.yaw);
    tick();
  }
  EXPECT_FALSE(wentThrough(State::kEvaluate, Reason::kGoalTimedOut)) << "150 s";
  tickFor(400.0);
  EXPECT_TRUE(wentThrough(State::kEvaluate, Reason::kGoalTimedOut)) << "it stands";
}

}  // namespace
}  // namespace frontier_pilot
