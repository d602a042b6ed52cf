#include <gtest/gtest.h>

#include "behavior_loop.h"

namespace frontier_pilot {
namespace {

using behavior::BehaviorKind;
using behavior::BehaviorOutcome;
using behavior::BehaviorOutput;
using test::BehaviorLoop;

/// A spin by one radian whose last cycle before the target comes `late` [s] late: the base turns on by its last
/// command.
struct LateSpin {
  explicit LateSpin(double late, double target = 1.0) {
    turned.restart(0.0);
    loop.start({BehaviorKind::kSpin, target, 0.0, 0.0, true});
    while (std::abs(target) - std::abs(turned.total()) > 0.15) cycle();
    loop.base.run(last.command.value_or(Twist2()), late);
  }

  void cycle() {
    last = loop.cycle();
    turned.add(loop.base.pose().yaw);
  }
  void run(double seconds) {
    for (const Time limit = loop.base.now() + fromSeconds(seconds); loop.behavior.active() && loop.base.now() < limit;)
      cycle();
  }

  BehaviorLoop loop;
  TurnCounter turned;
  BehaviorOutput last;
};

// [SPN-4]
TEST(Overshoot, ASpinThatTurnedTooFarWhileACycleWasLateTurnsBackToItsTarget) {
  for (const double target : {1.0, -1.0, 3.0}) {
    LateSpin spin(0.3, target);
    spin.run(5.0);
    EXPECT_EQ(spin.last.outcome, BehaviorOutcome::kSucceeded) << spin.last.message;
    spin.loop.rest();
    spin.turned.add(spin.loop.base.pose().yaw);
    EXPECT_NEAR(spin.turned.total(), target, 0.05);
    EXPECT_NEAR(spin.last.progress, spin.turned.total(), 0.005);
  }
}

// [SPN-4]
TEST(Overshoot, ItTurnsBackOnlyOverFreeFloorAndTheTurnHasSucceededAllTheSame) {
  LateSpin spin(0.3);
  spin.loop.scanning = false;
  spin.loop.base.run({}, 1.0);  // the costmap is too old by now
  spin.loop.moved = false;
  spin.run(5.0);
  EXPECT_EQ(spin.last.outcome, BehaviorOutcome::kSucceeded);
  EXPECT_NE(spin.last.message.find("past the target"), std::string::npos) << spin.last.message;
  EXPECT_FALSE(spin.loop.moved);
}

// [SPN-4]
TEST(Overshoot, ItTurnsBackOnceAndSaysThatItMissedTheTargetAgain) {
  LateSpin spin(0.3);
  for (int i = 0; i < 20 && !(spin.last.command && spin.last.command->angular < 0.0); ++i) spin.cycle();
  ASSERT_LT(spin.last.command->angular, 0.0);
  spin.loop.base.run(*spin.last.command, 1.5);
  spin.run(5.0);
  EXPECT_EQ(spin.last.outcome, BehaviorOutcome::kSucceeded);
  EXPECT_EQ(spin.last.message, "done, but past the target: it turned back too far");
}

// [SPN-4]
TEST(Overshoot, AnEmergencyStopOnTheWayBackEndsItAsAnyOther) {
  LateSpin spin(0.3);
  for (int i = 0; i < 20 && !(spin.last.command && spin.last.command->angular < 0.0); ++i) spin.cycle();
  ASSERT_LT(spin.last.command->angular, 0.0);
  spin.loop.inputs.emergency_stop = true;
  spin.cycle();
  EXPECT_EQ(spin.last.outcome, BehaviorOutcome::kNoProgress);
  EXPECT_TRUE(spin.last.command->isZero());
}

// [SPN-4]
TEST(Overshoot, ABaseThatDoesNotTurnBackEndsTheSpinWithAWord) {
  LateSpin spin(0.3);
  const BehaviorOutput output = spin.loop.run(10.0, Twist2());
  EXPECT_EQ(output.outcome, BehaviorOutcome::kSucceeded);
  EXPECT_NE(output.message.find("past the target: no progress"), std::string::npos) << output.message;
}

}  // namespace
}  // namespace frontier_pilot
