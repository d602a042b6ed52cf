#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>

#include "gui_fixture.h"

namespace frontier_pilot {
namespace {

const auto* const kApplication = ::testing::AddGlobalTestEnvironment(new test::Application);

class Driving : public test::PilotWidgetTest {};

// [GUI-1]
TEST_F(Driving, TheFiveButtonsChangeTheSetPointByTheirSteps) {
  click("Go");
  click("Go");
  click("Left");
  EXPECT_NEAR(widget_->setPoint().linear, 0.10, 1e-12);
  EXPECT_NEAR(widget_->setPoint().angular, 0.2, 1e-12);
  click("Back");
  click("Right");
  click("Right");
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12);
  EXPECT_NEAR(widget_->setPoint().angular, -0.2, 1e-12);
  click("Stop");
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-1]
TEST_F(Driving, ThePadsButtonsBearTheirNames) {
  for (const char* name : {"Go", "Back", "Left", "Right", "Stop"}) {
    EXPECT_EQ(find<QPushButton>(name)->text(), name);
  }
}

// [GUI-1]
TEST_F(Driving, ArrowsAndWasdDriveAndSpaceStops) {
  for (const auto key : {Qt::Key_Up, Qt::Key_W, Qt::Key_W, Qt::Key_S}) QTest::keyClick(widget_.get(), key);
  for (const auto key : {Qt::Key_Left, Qt::Key_A, Qt::Key_D}) QTest::keyClick(widget_.get(), key);
  EXPECT_NEAR(widget_->setPoint().linear, 0.10, 1e-12);
  EXPECT_NEAR(widget_->setPoint().angular, 0.2, 1e-12);
  QTest::keyClick(widget_.get(), Qt::Key_Down);
  QTest::keyClick(widget_.get(), Qt::Key_Right);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12);
  EXPECT_NEAR(widget_->setPoint().angular, 0.0, 1e-12);
  QTest::keyClick(widget_.get(), Qt::Key_Space);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

TEST_F(Driving, AKeyThatRepeatsItselfCountsOnce) {
  QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier, QString(), true);
  QTest::keyPress(widget_.get(), Qt::Key_Up);
  QApplication::sendEvent(widget_.get(), &repeat);
  QApplication::sendEvent(widget_.get(), &repeat);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12);
}

/// A key event as X sends it, which Qt has not recognised as a repetition.
void sendKey(QWidget& to, QEvent::Type type, unsigned long stamp) {
  QKeyEvent event(type, Qt::Key_Up, Qt::NoModifier);
  event.setTimestamp(stamp);
  QApplication::sendEvent(&to, &event);
}

// [GUI-1] X repeats a key that is held by releases and presses with one time stamp, and Qt may take them for real ones
TEST_F(Driving, AKeyThatIsHeldThroughAStopDoesNotDriveAfterIt_GUI_1) {
  sendKey(*widget_, QEvent::KeyPress, 1000);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12);
  const auto repeat = [&](unsigned long from, unsigned long to) {
    for (unsigned long stamp = from; stamp < to; stamp += 40) {
      sendKey(*widget_, QEvent::KeyRelease, stamp);
      sendKey(*widget_, QEvent::KeyPress, stamp);
    }
  };
  repeat(1500, 2000);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12) << "one press is one step";
  state_.emergency_stop = true;
  widget_->setState(state_);
  repeat(2000, 2500);
  state_.emergency_stop = false;
  widget_->setState(state_);
  repeat(2500, 3000);
  EXPECT_TRUE(widget_->setPoint().isZero());
  sendKey(*widget_, QEvent::KeyRelease, 3000);
  sendKey(*widget_, QEvent::KeyPress, 3100);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12) << "a new press drives";
}

// [GUI-1] a window that was busy reads the press of a repetition late
TEST_F(Driving, ARepetitionThatIsReadLateIsNoNewPress_GUI_1) {
  openHoldToRun();
  sendKey(*widget_, QEvent::KeyPress, 1000);
  sendKey(*widget_, QEvent::KeyRelease, 1500);
  EXPECT_TRUE(QTest::qWaitFor([&] { return widget_->setPoint().isZero(); }, 1000));
  sendKey(*widget_, QEvent::KeyPress, 1500);
  EXPECT_TRUE(widget_->setPoint().isZero());
  sendKey(*widget_, QEvent::KeyRelease, 2000);
  sendKey(*widget_, QEvent::KeyPress, 2100);
  EXPECT_NEAR(widget_->setPoint().linear, 0.15, 1e-12);
}

// [GUI-4] and a finger that lets go stops the robot
TEST_F(Driving, AKeyThatIsHeldToRunStopsTheRobotWhenItIsReleased_GUI_4) {
  openHoldToRun();
  sendKey(*widget_, QEvent::KeyPress, 1000);
  for (unsigned long stamp = 1500; stamp < 2000; stamp += 40) {
    sendKey(*widget_, QEvent::KeyRelease, stamp);
    EXPECT_NEAR(widget_->setPoint().linear, 0.15, 1e-12) << "without an interruption";
    sendKey(*widget_, QEvent::KeyPress, stamp);
  }
  sendKey(*widget_, QEvent::KeyRelease, 2000);
  EXPECT_TRUE(QTest::qWaitFor([&] { return widget_->setPoint().isZero(); }, 1000));
}

TEST_F(Driving, KeysDriveAlsoWhileAButtonHasTheFocus) {
  auto* button = find("patrol(sqr)");
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Up);
  EXPECT_NEAR(widget_->setPoint().linear, 0.05, 1e-12);
}

// [GUI-1]
TEST_F(Driving, SpaceStopsWhereverTheFocusIsAndPressesNothing) {
  for (const char* name : {"patrol(sqr)", "patrol_side", "spin_angle", "emergency_stop", "explore_start", "log"}) {
    click("Go");
    find(name)->setFocus();
    QTest::keyClick(find(name), Qt::Key_Space);
    EXPECT_TRUE(widget_->setPoint().isZero()) << name;
  }
  EXPECT_TRUE(requests_.empty());
}

TEST_F(Driving, EnterPressesTheButtonThatHasTheFocus) {
  QTest::keyClick(find("patrol(tri)"), Qt::Key_Return);
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kPatrol);
}

TEST_F(Driving, ArrowsInANumberFieldEditTheNumberAndDoNotDrive) {
  auto* side = find<QDoubleSpinBox>("patrol_side");
  QTest::keyClick(side, Qt::Key_Up);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_GT(side->value(), 1.0);
}

TEST_F(Driving, CommandKeysAreLeftToTheApplication) {
  QTest::keyClick(widget_.get(), Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

TEST_F(Driving, AChangeOfTheSetPointIsToldAtOnce) {
  std::vector<Twist2> told;
  QObject::connect(widget_.get(), &gui::PilotWidget::setPointChanged,
                   [&](const Twist2& twist) { told.push_back(twist); });
  click("Go");
  click("Stop");
  click("Stop");
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0], (Twist2{0.05, 0.0}));
  EXPECT_TRUE(told[1].isZero());
}

// [GUI-4]
TEST_F(Driving, HoldToRunMovesFromPressToRelease) {
  openHoldToRun();
  QTest::mousePress(find("Go"), Qt::LeftButton);
  EXPECT_GT(widget_->setPoint().linear, 0.0);
  QTest::mouseRelease(find("Go"), Qt::LeftButton);
  EXPECT_TRUE(widget_->setPoint().isZero());
  QTest::keyPress(widget_.get(), Qt::Key_A);
  EXPECT_GT(widget_->setPoint().angular, 0.0);
  QTest::keyRelease(widget_.get(), Qt::Key_A);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(Driving, HoldToRunStopsWhenThePointerLeavesThePressedButton) {
  openHoldToRun();
  QTest::mousePress(find("Go"), Qt::LeftButton);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(find("Go"), &leave);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(Driving, HoldToRunStopsWhenTheFocusIsLost) {
  openHoldToRun();
  QTest::keyPress(widget_.get(), Qt::Key_W);
  ASSERT_GT(widget_->setPoint().linear, 0.0);
  QWidget other;
  other.show();
  QApplication::setActiveWindow(&other);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(Driving, HoldToRunStopsWhenTheWidgetIsHidden) {
  openHoldToRun();
  QTest::keyPress(widget_.get(), Qt::Key_W);
  widget_->hide();
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-3] rviz only hides a panel that is closed, or behind another one.
TEST_F(Driving, TheRobotIsNotDrivenByAWidgetThatIsHidden_GUI_3) {
  click("Go");
  ASSERT_FALSE(widget_->setPoint().isZero());
  widget_->hide();
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(Driving, HoldToRunIsAnOptionOfTheWindow) {
  click("Go");
  auto* hold = find<QAbstractButton>("hold_to_run");
  hold->click();
  EXPECT_TRUE(widget_->setPoint().isZero());
  click("Go");
  EXPECT_TRUE(widget_->setPoint().isZero()) << "a click is over when the button is released";
}

TEST_F(Driving, ALatchedEmergencyStopDropsTheSetPointAndLocksThePad) {
  click("Go");
  state_.emergency_stop = true;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_FALSE(find("Go")->isEnabled());
  EXPECT_TRUE(find("Stop")->isEnabled());
  EXPECT_TRUE(text("drive_hint").contains("emergency stop"));
  QTest::keyClick(widget_.get(), Qt::Key_Up);
  state_.emergency_stop = false;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-1] [ARB-8] The robot may be stopped and cleared while the window hears nothing of it.
TEST_F(Driving, AnArbiterThatFallsSilentDropsTheSetPointAndLocksThePad_GUI_1) {
  const auto hear = [this](double age) {
    state_.arbiter->status_age = age;
    widget_->setState(state_);
  };
  click("Go");
  hear(2.9);
  EXPECT_FALSE(widget_->setPoint().isZero());
  hear(3.1);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_FALSE(find("Go")->isEnabled());
  EXPECT_TRUE(find("Stop")->isEnabled());
  EXPECT_EQ(find<gui::ElidedLabel>("drive_hint")->fullText(), "Locked: the arbiter is silent.");
  EXPECT_TRUE(find<QPlainTextEdit>("log")->toPlainText().contains("set-point dropped: the arbiter is silent"));
  QTest::keyClick(widget_.get(), Qt::Key_Up);
  hear(0.0);
  EXPECT_TRUE(widget_->setPoint().isZero());
  click("Go");
  EXPECT_FALSE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(Driving, AKeyThatIsHeldWhileTheArbiterIsSilentDrivesOnlyAfterANewPress_GUI_4) {
  openHoldToRun();
  QTest::keyPress(widget_.get(), Qt::Key_W);
  state_.arbiter->status_age = 60.0;
  widget_->setState(state_);
  state_.arbiter->status_age = 0.0;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
  QTest::keyRelease(widget_.get(), Qt::Key_W);
  QTest::keyPress(widget_.get(), Qt::Key_W);
  EXPECT_FALSE(widget_->setPoint().isZero());
}

// [GUI-1]
TEST_F(Driving, AnArbiterThatWasStartedAnewIsNotDrivenByTheSetPointOfBefore) {
  state_.arbiter_changes = 1;
  widget_->setState(state_);
  click("Go");
  widget_->setState(state_);
  EXPECT_FALSE(widget_->setPoint().isZero());
  state_.arbiter_changes = 2;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_TRUE(find<QPlainTextEdit>("log")->toPlainText().contains(
      "set-point dropped: the arbiter has ended or was started anew"));
}

TEST_F(Driving, WhenAPatrolTakesTheWheelsTheSetPointIsDropped) {
  click("Go");
  state_.arbiter->active_source = "patrol";
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_TRUE(find<QPlainTextEdit>("log")->toPlainText().contains("set-point dropped"));
}

}  // namespace
}  // namespace frontier_pilot
