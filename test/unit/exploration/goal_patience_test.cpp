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
  explicit SlowExplorer(const exploration::ExplorerParameters& parameters = slow()) : ExplorerTest(parameters) {}
  /// It moves along x at `speed` [m/s].
  void drive(double speed, double seconds) {
    for (const Time end = now + fromSeconds(seconds); now < end; tick()) pose.x += 0.1 * speed;
  }
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

/// An exploration that the battery ends, far from where it began.
class SlowReturn : public SlowExplorer {
 protected:
  static exploration::ExplorerParameters returning() {
    exploration::ExplorerParameters parameters = slow();
    parameters.until.battery = 0.2;
    parameters.return_to_start = true;
    return parameters;
  }
  SlowReturn() : SlowExplorer(returning()) {}
  /// Begins at `start`, and has to return from `end`.
  void returnFrom(Pose2 end, Pose2 start) {
    inputs.battery = 0.5;
    pose = start;
    tick();
    pose = end;
    inputs.battery = 0.2;
    ASSERT_EQ(tick().status.reason, Reason::kReturningToStart);
  }
};

// [EXP-5] [EXP-10] The last decision was made at the start, from where there is no way to it.
TEST_F(SlowReturn, AWayBackThatTakesLongerThanTheTimeoutIsNotGivenUpOnTheWay_EXP_5_EXP_10) {
  show(kTwoEnds);
  returnFrom(Pose2(2.0, pose.y, 0.0), pose);
  drive(-0.004, 150.0);
  EXPECT_FALSE(wentThrough(State::kEvaluate, Reason::kGoalTimedOut));
}

// [EXP-5] [EXP-10]
TEST_F(SlowReturn, AWayBackAroundAWallHasItsTimeAlsoIfTheStartIsTooNearToAWall_EXP_5_EXP_10) {
  show(R"(
    ##############################################
    #............................................#
    #............................................#
    #............................................#
    #............................................#
    #............................................#
    #............................................#
    ###################################..........#
    #............................................#
    #............................................#
    #............................................#
    #...r........................................#
    #............................................#
    #............................................#
    ##############################################
  )");
  returnFrom(pose, Pose2(0.2, 0.66, 0.0));
  drive(0.004, 300.0);
  EXPECT_FALSE(wentThrough(State::kEvaluate, Reason::kGoalTimedOut)) << "the straight line takes 110 s, the way 700 s";
}

}  // namespace
}  // namespace frontier_pilot
