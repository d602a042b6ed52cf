#include "teleop/drive_model.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

void press(teleop::DriveModel& drive, teleop::Motion motion, int times) {
  for (int i = 0; i < times; ++i) drive.press(motion);
}

teleop::TeleopParameters holdParameters() {
  teleop::TeleopParameters parameters;
  parameters.hold_to_run = true;
  return parameters;
}

// [GUI-1]
TEST(DriveModel, StepsBy5CentimetresASecondAndAFifthOfARadian) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  press(drive, teleop::Motion::kGo, 2);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.10);
  EXPECT_DOUBLE_EQ(drive.setPoint().angular, 0.0);
  press(drive, teleop::Motion::kLeft, 3);
  EXPECT_NEAR(drive.setPoint().angular, 0.6, 1e-12);
  press(drive, teleop::Motion::kBack, 5);
  EXPECT_NEAR(drive.setPoint().linear, -0.15, 1e-12);
  press(drive, teleop::Motion::kRight, 4);
  EXPECT_NEAR(drive.setPoint().angular, -0.2, 1e-12);
}

// [GUI-1]
TEST(DriveModel, StaysWithinTheLimitsAndComesBackFromThemAtOnce) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  press(drive, teleop::Motion::kGo, 100);
  press(drive, teleop::Motion::kRight, 100);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.22);
  EXPECT_DOUBLE_EQ(drive.setPoint().angular, -2.84);
  press(drive, teleop::Motion::kBack, 1);
  EXPECT_DOUBLE_EQ(drive.setPoint().linear, 0.20);
}

TEST(DriveModel, AnExactMultipleAsTheLimitNeedsNoFurtherStep) {
  teleop::TeleopParameters parameters;
  parameters.robot.limits.max_linear = 0.2;
  teleop::DriveModel drive(parameters);
  press(drive, teleop::Motion::kGo, 10);
  press(drive, teleop::Motion::kBack, 1);
  EXPECT_NEAR(drive.setPoint().linear, 0.15, 1e-12);
}

TEST(DriveModel, AsManyPressesBackEndAtZeroExactly) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  press(drive, teleop::Motion::kGo, 3);
  press(drive, teleop::Motion::kBack, 3);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-1]
TEST(DriveModel, StopZeroesBothAxesAtOnce) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  press(drive, teleop::Motion::kGo, 3);
  press(drive, teleop::Motion::kLeft, 3);
  drive.press(teleop::Motion::kStop);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-1]
TEST(DriveModel, ArrowsAndWasdMeanTheSameAndSpaceStops) {
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kUp), teleop::Motion::kGo);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kW), teleop::Motion::kGo);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kDown), teleop::Motion::kBack);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kS), teleop::Motion::kBack);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kLeft), teleop::Motion::kLeft);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kA), teleop::Motion::kLeft);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kRight), teleop::Motion::kRight);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kD), teleop::Motion::kRight);
  EXPECT_EQ(teleop::motionOf(teleop::DriveKey::kSpace), teleop::Motion::kStop);
}

// [GUI-4]
TEST(DriveModel, HoldToRunMovesOnlyWhilePressed) {
  const teleop::TeleopParameters parameters = holdParameters();
  teleop::DriveModel drive(parameters);
  drive.press(teleop::Motion::kGo);
  drive.press(teleop::Motion::kLeft);
  EXPECT_EQ(drive.setPoint(), (Twist2{parameters.hold_linear, parameters.hold_angular}));
  drive.release(teleop::Motion::kGo);
  EXPECT_EQ(drive.setPoint(), (Twist2{0.0, parameters.hold_angular}));
  drive.release(teleop::Motion::kLeft);
  EXPECT_TRUE(drive.setPoint().isZero());
}

// [GUI-4]
TEST(DriveModel, HoldToRunForgetsEverythingHeldWhenTheFocusIsLost) {
  teleop::DriveModel drive(holdParameters());
  drive.press(teleop::Motion::kGo);
  drive.releaseAll();
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.release(teleop::Motion::kGo);  // the late release of a key that counts no more
  drive.press(teleop::Motion::kGo);
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(DriveModel, TwoKeysOfOneDirectionHoldUntilBothAreReleased) {
  teleop::DriveModel drive(holdParameters());
  drive.press(teleop::Motion::kGo);
  drive.press(teleop::Motion::kGo);
  drive.release(teleop::Motion::kGo);
  EXPECT_FALSE(drive.setPoint().isZero());
  drive.release(teleop::Motion::kGo);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, OppositeDirectionsHeldTogetherCancel) {
  teleop::DriveModel drive(holdParameters());
  drive.press(teleop::Motion::kGo);
  drive.press(teleop::Motion::kBack);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, LosingTheFocusDoesNotTouchASteppedSetPoint) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  drive.press(teleop::Motion::kGo);
  drive.release(teleop::Motion::kGo);
  drive.releaseAll();
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(DriveModel, ChangingTheWayOfDrivingStops) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  drive.press(teleop::Motion::kGo);
  drive.setHoldToRun(true);
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.press(teleop::Motion::kGo);
  drive.setHoldToRun(false);
  EXPECT_TRUE(drive.setPoint().isZero());
}

TEST(DriveModel, ALockDropsTheSetPointAndPressesUntilItIsTakenAway) {
  using teleop::DriveLock;
  for (const DriveLock lock : {DriveLock::kEmergencyStop, DriveLock::kArbiterSilent, DriveLock::kManualOff}) {
    teleop::DriveModel drive{teleop::TeleopParameters{}};
    drive.press(teleop::Motion::kGo);
    drive.setLock(lock);
    EXPECT_TRUE(drive.setPoint().isZero());
    drive.press(teleop::Motion::kGo);
    drive.setLock(teleop::DriveLock::kNone);
    EXPECT_TRUE(drive.setPoint().isZero()) << "a press while locked must not count later";
    drive.press(teleop::Motion::kGo);
    EXPECT_FALSE(drive.setPoint().isZero());
  }
}

TEST(DriveModel, AMachineThatTakesOrGivesBackTheWheelsDropsTheSetPoint) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  drive.setDriver("manual");
  drive.press(teleop::Motion::kGo);
  EXPECT_FALSE(drive.setDriver("manual"));
  EXPECT_TRUE(drive.setDriver("patrol"));
  EXPECT_TRUE(drive.setPoint().isZero());
  EXPECT_FALSE(drive.setDriver("nav")) << "from one machine to another nothing changes for the hand";
  EXPECT_FALSE(drive.setDriver(""));
  EXPECT_TRUE(drive.setPoint().isZero());
  drive.press(teleop::Motion::kGo);
  EXPECT_FALSE(drive.setPoint().isZero());
}

// [GUI-1] [GUI-4] A machine that falls silent is known of only by the next status, and until then the robot would move.
TEST(DriveModel, PressesWhileAMachineDrivesHaveNoEffectNotEvenAMomentAfterIt_GUI_1) {
  for (const teleop::TeleopParameters& parameters : {teleop::TeleopParameters{}, holdParameters()}) {
    teleop::DriveModel drive{parameters};
    drive.setDriver("patrol");
    drive.press(teleop::Motion::kGo);
    EXPECT_TRUE(drive.setPoint().isZero());
    drive.setDriver("");
    EXPECT_TRUE(drive.setPoint().isZero());
    drive.press(teleop::Motion::kGo);
    EXPECT_FALSE(drive.setPoint().isZero());
  }
}

// [GUI-1] In rviz' panel manual is silent until a press, so that a source below it may drive all the time.
TEST(DriveModel, APressTakesTheWheelsFromASourceOverWhichManualHasPriority_GUI_1) {
  for (const teleop::TeleopParameters& parameters : {teleop::TeleopParameters{}, holdParameters()}) {
    teleop::DriveModel drive{parameters};
    drive.press(teleop::Motion::kGo);
    EXPECT_TRUE(drive.setDriver("idle", true)) << "manual was not heard: its old set-point must not come back";
    EXPECT_TRUE(drive.setPoint().isZero());
    EXPECT_FALSE(drive.machineDrives());
    drive.press(teleop::Motion::kGo);
    EXPECT_FALSE(drive.setDriver("idle", true));
    EXPECT_FALSE(drive.setDriver("manual"));
    EXPECT_FALSE(drive.setPoint().isZero());
    EXPECT_TRUE(drive.setDriver("nav"));
    EXPECT_FALSE(drive.setDriver("idle", true));
    EXPECT_TRUE(drive.setPoint().isZero());
  }
}

TEST(DriveModel, TheAvoiderOnlyInterrupts) {
  teleop::DriveModel drive{teleop::TeleopParameters{}};
  drive.setDriver("manual");
  drive.press(teleop::Motion::kGo);
  EXPECT_FALSE(drive.setDriver("avoid"));
  EXPECT_FALSE(drive.setDriver("manual"));
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(DriveModel, MotionsAreNamedAsTheButtonsAre) {
  EXPECT_STREQ(toString(teleop::Motion::kGo), "Go");
  EXPECT_STREQ(toString(teleop::Motion::kBack), "Back");
  EXPECT_STREQ(toString(teleop::Motion::kLeft), "Left");
  EXPECT_STREQ(toString(teleop::Motion::kRight), "Right");
  EXPECT_STREQ(toString(teleop::Motion::kStop), "Stop");
}

TEST(DriveModel, ALockSaysWhyTheButtonsHaveNoEffect) {
  EXPECT_STREQ(toString(teleop::DriveLock::kNone), "");
  EXPECT_STREQ(toString(teleop::DriveLock::kManualOff), "manual is switched off");
  EXPECT_STREQ(toString(teleop::DriveLock::kArbiterSilent), "the arbiter is silent");
  EXPECT_STREQ(toString(teleop::DriveLock::kEmergencyStop), "the emergency stop is latched");
}

// [GUI-4] A stop is not held, and there is no place to count it: a sanitizer reports it if it is counted.
TEST(DriveModel, ReleasingTheStopKeyChangesNothing) {
  teleop::DriveModel drive(holdParameters());
  drive.press(teleop::Motion::kStop);
  drive.press(teleop::Motion::kGo);
  drive.release(teleop::Motion::kStop);
  EXPECT_FALSE(drive.setPoint().isZero());
}

TEST(TeleopParameters, AnUnknownPaletteIsRefusedByName) {
  teleop::TeleopParameters parameters;
  const Problems problems = loadParameters(parseYaml("palette: pink\n"), parameters);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("palette"), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
