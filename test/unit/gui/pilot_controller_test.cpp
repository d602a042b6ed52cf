#include "gui/pilot_controller.h"

#include <QPlainTextEdit>
#include <QPushButton>

#include "gui_fixture.h"
#include "recording_link.h"

namespace frontier_pilot {
namespace {

using test::RecordingLink;

class PilotControllerTest : public ::testing::Test {
 protected:
  void clickGo() { QTest::mouseClick(widget_.findChild<QWidget*>("Go"), Qt::LeftButton); }
  QString logText() { return widget_.findChild<QPlainTextEdit*>("log")->toPlainText(); }

  gui::PilotWidget widget_{teleop::TeleopParameters{}};
  RecordingLink link_;
};

// [GUI-3]
TEST_F(PilotControllerTest, BeatsByItselfForAsLongAsTheWindowLives) {
  gui::PilotController controller(widget_, link_, std::chrono::hours(1));
  EXPECT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
}

TEST_F(PilotControllerTest, ASetPointDoesNotWaitForTheNextBeat) {
  gui::PilotController controller(widget_, link_, std::chrono::hours(1));
  clickGo();
  ASSERT_FALSE(link_.beats.empty());
  EXPECT_EQ(link_.beats.back(), (Twist2{0.05, 0.0}));
}

// [GUI-3]
TEST_F(PilotControllerTest, AWindowThatWasFrozenDropsItsSetPoint) {
  gui::PilotController controller(widget_, link_, Duration::zero());  // so that any two beats are too far apart
  clickGo();
  clickGo();
  EXPECT_TRUE(widget_.setPoint().isZero());
  EXPECT_TRUE(link_.beats.back().isZero());
  EXPECT_TRUE(logText().contains("frozen"));
}

// [GUI-3]
TEST_F(PilotControllerTest, AWindowWhoseComputerWasSuspendedDropsItsSetPoint) {
  gui::PilotController controller(widget_, link_, std::chrono::minutes(1));
  clickGo();
  ASSERT_FALSE(widget_.setPoint().isZero());
  link_.suspended = std::chrono::minutes(2);
  EXPECT_TRUE(QTest::qWaitFor([this] { return widget_.setPoint().isZero(); }));
  EXPECT_TRUE(link_.beats.back().isZero());
}

TEST_F(PilotControllerTest, AWindowThatWasFrozenWithoutASetPointHasNothingToTell) {
  gui::PilotController controller(widget_, link_, Duration::zero());
  EXPECT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
  EXPECT_FALSE(logText().contains("frozen"));
}

// [GUI-3] [ARB-12]
TEST_F(PilotControllerTest, WhatWasClickedWhileTheWindowWasFrozenIsNotDone) {
  gui::PilotController controller(widget_, link_, Duration::zero());  // so that any two beats are too far apart
  ASSERT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
  QTest::mouseClick(widget_.findChild<QWidget*>("patrol(sqr)"), Qt::LeftButton);
  EXPECT_TRUE(link_.requests.empty());
  EXPECT_TRUE(logText().contains("click again"));
  teleop::OperatorRequest save;
  save.kind = teleop::OperatorRequest::Kind::kSaveMap;
  widget_.requested(save);
  EXPECT_TRUE(link_.requests.empty());
  EXPECT_TRUE(widget_.findChild<gui::ElidedLabel*>("map_message")->fullText().startsWith("Not done"));
}

// [GUI-3] [ARB-12]
TEST_F(PilotControllerTest, WhatIsStillReadAfterTheWindowWasFrozenIsNotDoneEither) {
  gui::PilotController controller(widget_, link_, std::chrono::milliseconds(300));
  ASSERT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
  QTest::qSleep(400);  // the event loop does not run meanwhile
  ASSERT_TRUE(QTest::qWaitFor([this, beats = link_.beats.size()] { return link_.beats.size() > beats; }));
  clickGo();
  QTest::mouseClick(widget_.findChild<QWidget*>("patrol(sqr)"), Qt::LeftButton);
  EXPECT_TRUE(widget_.setPoint().isZero());
  EXPECT_TRUE(link_.beats.back().isZero());
  EXPECT_TRUE(link_.requests.empty());
}

// [GUI-3] [ARB-12]
TEST_F(PilotControllerTest, AStopThatWasClickedWhileTheWindowWasFrozenIsAsked) {
  gui::PilotController controller(widget_, link_, Duration::zero());  // so that any two beats are too far apart
  ASSERT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
  QTest::mouseClick(widget_.findChild<QWidget*>("emergency_stop"), Qt::LeftButton);
  ASSERT_EQ(link_.requests.size(), 1U);
  EXPECT_EQ(link_.requests[0].kind, teleop::OperatorRequest::Kind::kEmergencyStop);
}

// [GUI-3] [ARB-12]
TEST_F(PilotControllerTest, APauseThatWasClickedWhileTheWindowWasFrozenIsNotFollowedByAClear) {
  teleop::OperatorState refused;
  refused.clear_service_up = true;
  refused.emergency_stop = true;
  refused.clear_refusal = "nav asked to move";
  link_.shown = refused;
  gui::PilotController controller(widget_, link_, std::chrono::milliseconds(300));
  auto* halt = widget_.findChild<QPushButton*>("halt_and_clear");
  ASSERT_TRUE(QTest::qWaitFor([halt] { return halt->isEnabled() && !halt->text().isEmpty(); }));
  QTest::qSleep(400);  // the event loop does not run meanwhile
  halt->click();
  QTest::qWait(2000);
  for (const teleop::OperatorRequest& request : link_.requests) {
    EXPECT_NE(request.kind, teleop::OperatorRequest::Kind::kClearEmergencyStop);
  }
  EXPECT_FALSE(link_.requests.empty());
}

// [GUI-3]
TEST_F(PilotControllerTest, AWindowThatAnswersAgainTakesClicksAfterAMoment) {
  gui::PilotController controller(widget_, link_, std::chrono::milliseconds(300));
  ASSERT_TRUE(QTest::qWaitFor([this] { return link_.beats.size() >= 3; }));
  QTest::qSleep(400);  // the event loop does not run meanwhile
  EXPECT_TRUE(QTest::qWaitFor([this] {
    QTest::mouseClick(widget_.findChild<QWidget*>("patrol(sqr)"), Qt::LeftButton);
    return !link_.requests.empty();
  }));
}

TEST_F(PilotControllerTest, HandsWishesOnAndShowsTheStateAndTheLog) {
  gui::PilotController controller(widget_, link_, std::chrono::hours(1));
  EXPECT_TRUE(QTest::qWaitFor([this] { return logText().contains("hello from the system"); }));
  QTest::mouseClick(widget_.findChild<QWidget*>("patrol(sqr)"), Qt::LeftButton);
  ASSERT_EQ(link_.requests.size(), 1U);
  EXPECT_EQ(link_.requests[0].kind, teleop::OperatorRequest::Kind::kPatrol);
}

// [GUI-3]
TEST_F(PilotControllerTest, ClosesTheLinkOnceAndSaysNothingAfterIt) {
  {
    gui::PilotController controller(widget_, link_, std::chrono::hours(1));
    controller.close();
    const std::size_t beats = link_.beats.size();
    clickGo();
    EXPECT_EQ(link_.beats.size(), beats);
    EXPECT_EQ(link_.closed, 1);
  }
  EXPECT_EQ(link_.closed, 1);
}

// [GUI-3]
TEST_F(PilotControllerTest, GoingAwayClosesTheLink) {
  { gui::PilotController controller(widget_, link_, std::chrono::hours(1)); }
  EXPECT_EQ(link_.closed, 1);
}

TEST_F(PilotControllerTest, AsksForTheWindowToCloseWhenTheSystemEnds) {
  gui::PilotController controller(widget_, link_, std::chrono::hours(1));
  bool asked = false;
  QObject::connect(&controller, &gui::PilotController::closeAsked, [&asked] { asked = true; });
  link_.is_running = false;
  EXPECT_TRUE(QTest::qWaitFor([&asked] { return asked; }));
  EXPECT_EQ(link_.closed, 1);
}

}  // namespace
}  // namespace frontier_pilot
