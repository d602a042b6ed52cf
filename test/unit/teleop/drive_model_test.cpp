#include "frontier_pilot/teleop/drive_model.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

void press(DriveModel& drive, Motion motion, int times) {
  for (int i = 0; i < times; ++i) drive.press(motion);
}

TeleopParameters holdParameters() {
  TeleopParameters parameters;
  parameters.hold_to_run = true;
  return parameters;
}

// [GUI-1]
TEST(DriveModel, StepsBy5CentimetresASecondAndAFifthOfARadian) {
  DriveModel drive{TeleopParameters{}};
  press(drive, Motion::kGo, 2);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.10);
  EXPECT_DOUBLE_EQ(drive.setPoint().angular, 0.0);
  press(drive, Motion::kLeft, 3);
  EXPECT_NEAR(drive.setPoint().angular, 0.6, 1e-12);
  press(drive, Motion::kBack, 5);
  EXPECT_NEAR(drive.setPoint().linear, -0.15, 1e-12);
  press(drive, Motion::kRight, 4);
  EXPECT_NEAR(drive.setPoint().angular, -0.2, 1e-12);
}

// [GUI-1]
TEST(DriveModel, StaysWithinTheLimitsAndComesBackFromThemAtOnce) {
  DriveModel drive{TeleopParameters{}};
  press(drive, Motion::kGo, 100);
  press(drive, Motion::kRight, 100);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.22);
  EXPECT_DOUBLE_EQ(drive.setPoint().angular, -2.84);
  press(drive, Motion::kBack, 1);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.20);
}

TEST(DriveModel, AnExactMultipleAsTheLimitNeedsNoFurtherStep) {
  TeleopParameters parameters;
  parameters.robot.limits.max_linear = 0.2;
  DriveModel drive(parameters);
  press(drive, Motion::kGo, 10);
  press(drive, Motion::kBack, 1);
  EXPECT_NEAR(drive.setPoint().linear, 0.15, 1e-12);
}

TEST(DriveModel, AsManyPressesBackEndAtZeroExactly) {
  DriveModel drive{TeleopParameters{}};
  press(drive, Motion::kGo, 3);
  press(drive, Motion::kBack, 3);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-1]
TEST(DriveModel, StopZeroesBothAxesAtOnce) {
  DriveModel drive{TeleopParameters{}};
  press(drive, Motion::kGo, 3);
  press(drive, Motion::kLeft, 3);
  drive.press(Motion::kStop);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-1]
TEST(DriveModel, ArrowsAndWasdMeanTheSameAndSpaceStops) {
  EXPECT_EQ(motionOf(DriveKey::kUp), Motion::kGo);
  EXPECT_EQ(motionOf(DriveKey::kW), Motion::kGo);
  EXPECT_EQ(motionOf(DriveKey::kDown), Motion::kBack);
  EXPECT_EQ(motionOf(DriveKey::kS), Motion::kBack);
  EXPECT_EQ(motionOf(DriveKey::kLeft), Motion::kLeft);
  EXPECT_EQ(motionOf(DriveKey::kA), Motion::kLeft);
  EXPECT_EQ(motionOf(DriveKey::kRight), Motion::kRight);
  EXPECT_EQ(motionOf(DriveKey::kD), Motion::kRight);
  EXPECT_EQ(motionOf(DriveKey::kSpace), Motion::kStop);
}

// [GUI-4]
TEST(DriveModel, HoldToRunMovesOnlyWhilePressed) {
  const TeleopParameters parameters = holdParameters();
  DriveModel drive(parameters);
  drive.press(Motion::kGo);
  drive.press(Motion::kLeft);
  EXPECT_EQ(drive.setPoint(), (Twist2{parameters.hold_linear, parameters.hold_angular}));
  drive.release(Motion::kGo);
  EXPECT_EQ(drive.setPoint(), (Twist2{0.0, parameters.hold_angular}));
  drive.release(Motion::kLeft);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-4]
TEST(DriveModel, HoldToRunForgetsEverythingHeldWhenTheFocusIsLost) {
  DriveModel drive(holdParameters());
  drive.press(Motion::kGo);
  drive.releaseAll();
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.release(Motion::kGo);  // the late release of a key that counts no more
  drive.press(Motion::kGo);
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(DriveModel, TwoKeysOfOneDirectionHoldUntilBothAreReleased) {
  DriveModel drive(holdParameters());
  drive.press(Motion::kGo);
  drive.press(Motion::kGo);
  drive.release(Motion::kGo);
  EXPECT_FALSE(drive.setPoint().isZero());
  drive.release(Motion::kGo);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, OppositeDirectionsHeldTogetherCancel) {
  DriveModel drive(holdParameters());
  drive.press(Motion::kGo);
  drive.press(Motion::kBack);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, LosingTheFocusDoesNotTouchASteppedSetPoint) {
  DriveModel drive{TeleopParameters{}};
  drive.press(Motion::kGo);
  drive.release(Motion::kGo);
  drive.releaseAll();
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(DriveModel, ChangingTheWayOfDrivingStops) {
  DriveModel drive{TeleopParameters{}};
  drive.press(Motion::kGo);
  drive.setHoldToRun(true);
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.press(Motion::kGo);
  drive.setHoldToRun(false);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, ALockDropsTheSetPointAndPressesUntilItIsTakenAway) {
  for (const DriveLock lock : {DriveLock::kEmergencyStop, DriveLock::kManualOff}) {
    DriveModel drive{TeleopParameters{}};
    drive.press(Motion::kGo);
    drive.setLock(lock);
    EXPECT_TRUE(drive.setPoint().isZero());
    drive.press(Motion::kGo);
    drive.setLock(DriveLock::kNone);
    EXPECT_TRUE(drive.setPoint().isZero()) << "a press while locked must not count later";
    drive.press(Motion::kGo);
    EXPECT_FALSE(drive.setPoint().isZero());
  }
}

TEST(DriveModel, AMachineThatTakesOrGivesBackTheWheelsDropsTheSetPoint) {
  DriveModel drive{TeleopParameters{}};
  drive.setDriver("manual");
  drive.press(Motion::kGo);
  EXPECT_FALSE(drive.setDriver("manual"));
  EXPECT_TRUE(drive.setDriver("patrol"));
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.press(Motion::kGo);
  EXPECT_FALSE(drive.setDriver("nav")) << "from one machine to another nothing changes for the hand";
  EXPECT_FALSE(drive.setPoint().isZero());
  EXPECT_TRUE(drive.setDriver(""));
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, TheAvoiderOnlyInterrupts) {
  DriveModel drive{TeleopParameters{}};
  drive.setDriver("manual");
  drive.press(Motion::kGo);
  EXPECT_FALSE(drive.setDriver("avoid"));
  EXPECT_FALSE(drive.setDriver("manual"));
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(TeleopParameters, AnUnknownPaletteIsRefusedByName) {
  TeleopParameters parameters;
  const Problems problems = loadParameters(parseYaml("palette: pink\n"), parameters);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("palette"), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
