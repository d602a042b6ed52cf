// The recoveries of a robot that is a disc.

#include "frontier_pilot/system/behavior_ladder.h"

#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"
#include "support/shipped_robot.h"

namespace frontier_pilot::system {
namespace {

constexpr double kRate = 20.0;  // [Hz]

/// How far a Burger backs up towards a wall that stands this far behind its centre [m]; it moves exactly as commanded.
double backedUpBeforeWall(double wall) {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot("burger");
  const Outline outline = params.robot.exactOutline();
  const double lifetime = params.follower.command_lifetime;
  navigation::RecoveryInputs in;
  in.scan_distance = [wall](const Outline& of, const Pose2& T_map_base) { return T_map_base.x - of.rear() + wall; };
  navigation::Recovery recovery = behaviorLadder(params, kRate).at(1).begin();
  for (int tick = 0; tick < 400; ++tick) {
    const navigation::RecoveryStep step = recovery(in, Time(std::chrono::milliseconds(50 * tick)));
    if (step.done) return -in.T_map_base.x;
    EXPECT_LE(step.command.linear, 0.0);
    Pose2 last = integrate(in.T_map_base, step.command, lifetime);
    last.x -= brakingDistance(step.command.linear, params.robot.limits.max_linear_acc);
    EXPECT_GT(in.scan_distance(outline, last), 0.0) << "each command may be the last, at x = " << in.T_map_base.x;
    in.T_map_base = integrate(in.T_map_base, step.command, 1.0 / kRate);
  }
  ADD_FAILURE() << "it never ended";
  return 0.0;
}

// [NAV-3] [FLT-2]
TEST(BackingUp, LeavesRoomForALastCommandThatStaysInForce) {
  for (const double wall : {0.20, 0.25, 0.28, 0.30, 0.35, 0.40}) {
    SCOPED_TRACE(wall);
    backedUpBeforeWall(wall);
  }
}

// [NAV-3]
TEST(BackingUp, GoesAsFarAsThereIsRoomAndNoFartherThanAskedFor) {
  EXPECT_NEAR(backedUpBeforeWall(1.0), navigation::RecoveryParams().back_up_distance, 0.01);
  EXPECT_GT(backedUpBeforeWall(0.30), 0.04);
  EXPECT_GT(backedUpBeforeWall(0.25), 0.04) << "more slowly";
  EXPECT_NEAR(backedUpBeforeWall(0.15), 0.0, 1e-9) << "there is not room for a quarter of it";
}

}  // namespace
}  // namespace frontier_pilot::system
