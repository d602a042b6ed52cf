#include <QDoubleSpinBox>
#include <QMenu>

#include "gui_fixture.h"

namespace frontier_pilot {
namespace {

class HoldToRun : public test::PilotWidgetTest {
 protected:
  void SetUp() override {
    openHoldToRun();
    QTest::keyPress(widget_.get(), Qt::Key_W);
    ASSERT_GT(widget_->setPoint().linear, 0.0);
  }
};

// [GUI-4]
TEST_F(HoldToRun, AKeyThatIsReleasedWhileAModifierIsHeldStopsTheRobot_GUI_4) {
  for (const auto modifier : {Qt::ControlModifier, Qt::AltModifier, Qt::MetaModifier, Qt::ShiftModifier}) {
    QTest::keyPress(widget_.get(), Qt::Key_W);
    ASSERT_GT(widget_->setPoint().linear, 0.0);
    QTest::keyPress(widget_.get(), Qt::Key_Control, modifier);
    QTest::keyRelease(widget_.get(), Qt::Key_W, modifier);
    EXPECT_TRUE(widget_->setPoint().isZero()) << modifier;
  }
}

// [GUI-4]
TEST_F(HoldToRun, AKeyOnWhichAModifierPutsAnotherLetterStopsTheRobotWhenItIsReleased_GUI_4) {
  constexpr quint32 kScanCode = 38;
  QKeyEvent press(QEvent::KeyPress, Qt::Key_A, Qt::NoModifier, kScanCode, 'a', 0);
  QKeyEvent release(QEvent::KeyRelease, Qt::Key_AE, Qt::GroupSwitchModifier, kScanCode, 0xe6, 0);
  QTest::keyRelease(widget_.get(), Qt::Key_W);
  QApplication::sendEvent(widget_.get(), &press);
  ASSERT_GT(widget_->setPoint().angular, 0.0);
  QApplication::sendEvent(widget_.get(), &release);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4] the release is read by the field
TEST_F(HoldToRun, ANumberFieldThatGetsTheFocusStopsTheRobot_GUI_4) {
  auto* side = find<QDoubleSpinBox>("patrol_side");
  side->setFocus();
  EXPECT_TRUE(widget_->setPoint().isZero());
  QTest::keyRelease(side, Qt::Key_W);
  widget_->setFocus();
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(HoldToRun, AKeyThatIsReleasedOverANumberFieldStopsTheRobot_GUI_4) {
  QTest::keyRelease(find("patrol_side"), Qt::Key_W);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4] rviz has menus of its own
TEST_F(HoldToRun, AMenuThatOpensStopsTheRobot_GUI_4) {
  for (QWidget* parent : {static_cast<QWidget*>(widget_.get()), find("log"), static_cast<QWidget*>(nullptr)}) {
    QTest::keyPress(widget_.get(), Qt::Key_W);
    ASSERT_GT(widget_->setPoint().linear, 0.0);
    QMenu menu(parent);
    menu.addAction("Copy");
    menu.popup({0, 0});
    EXPECT_TRUE(widget_->setPoint().isZero());
    menu.close();
    EXPECT_TRUE(widget_->setPoint().isZero());
    QTest::keyRelease(widget_.get(), Qt::Key_W);
  }
}

// [GUI-4]
TEST_F(HoldToRun, AKeyThatIsReleasedInAnotherWindowStopsTheRobot_GUI_4) {
  QMenu of_the_widget(widget_.get());
  QWidget other;
  for (QWidget* reader : {static_cast<QWidget*>(&of_the_widget), &other}) {
    QTest::keyPress(widget_.get(), Qt::Key_W);
    ASSERT_GT(widget_->setPoint().linear, 0.0);
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_W, Qt::NoModifier);
    QApplication::sendEvent(reader, &release);
    EXPECT_TRUE(widget_->setPoint().isZero());
  }
}

// [GUI-4] a release that nobody has seen
TEST_F(HoldToRun, AKeyThatIsPressedTwiceIsHeldOnce_GUI_4) {
  QKeyEvent repeat(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier, QString(), true);
  QApplication::sendEvent(widget_.get(), &repeat);
  QTest::keyPress(widget_.get(), Qt::Key_W);
  EXPECT_GT(widget_->setPoint().linear, 0.0);
  QTest::keyRelease(widget_.get(), Qt::Key_W);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

// [GUI-4]
TEST_F(HoldToRun, TwoKeysOfOneDirectionHoldUntilBothAreReleased_GUI_4) {
  QTest::keyPress(widget_.get(), Qt::Key_Up);
  QTest::keyRelease(widget_.get(), Qt::Key_W);
  QTest::keyRelease(widget_.get(), Qt::Key_W, Qt::ControlModifier);
  EXPECT_GT(widget_->setPoint().linear, 0.0);
  QTest::keyRelease(widget_.get(), Qt::Key_Up);
  EXPECT_TRUE(widget_->setPoint().isZero());
}

}  // namespace
}  // namespace frontier_pilot
