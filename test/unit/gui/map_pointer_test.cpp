#include <QWheelEvent>

#include "map_fixture.h"

namespace frontier_pilot {
namespace {

using test::blockOf;
using test::mapOf;
using test::viewOf;

using MapPointer = test::MapInTheWindow;

// [GUI-2]
TEST_F(MapPointer, SendsTheRobotWhereItIsPressedInTheDirectionOfTheDrag) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  aimAt(3.0, 2.0);
  EXPECT_TRUE(requests_.empty()) << "a press alone moves the map";
  click("Go");
  click("map_go");
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  QTest::mouseMove(&picture(), pixelOf(3.0, 3.5));
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 3.5));
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kGoTo);
  ASSERT_EQ(requests_[0].poses.size(), 1U);
  EXPECT_NEAR(requests_[0].poses[0].x, 3.0, 0.05);
  EXPECT_NEAR(requests_[0].poses[0].y, 2.0, 0.05);
  EXPECT_NEAR(requests_[0].poses[0].yaw, kPi / 2.0, 0.05);
  EXPECT_TRUE(widget_->setPoint().isZero()) << "the hand does not drive on";
  EXPECT_FALSE(find<QPushButton>("map_go")->isChecked()) << "one goal for each click on the button";
}

// [GUI-2]
TEST_F(MapPointer, WithoutADragTheRobotArrivesInTheDirectionOfItsWay) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  click("map_go");
  aimAt(1.0, 4.0);
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_NEAR(requests_[0].poses[0].yaw, kPi / 2.0, 0.05) << "it stands at (1, 1)";
}

// [GUI-2]
TEST_F(MapPointer, RefusesPlacesThatAreNotFreeAndSaysWhy) {
  click("map_go");
  aimAt(1.0, 1.0);
  EXPECT_EQ(message(), "Not sent: there is no map yet.");
  const teleop::MapChange map = mapOf(60, 60, kFree);
  widget_->setMap(viewOf(map));
  widget_->setMap(viewOf(blockOf(map, {0, 0, 20, 60}, kUnknown)));
  widget_->setMap(viewOf(blockOf(map, {40, 0, 20, 60}, kOccupied)));
  aimAt(1.0, 3.0);
  EXPECT_EQ(message(), "Not sent: nothing is known of that place yet.");
  aimAt(5.0, 3.0);
  EXPECT_EQ(message(), "Not sent: there is an obstacle.");
  aimAt(3.0, 6.05);
  EXPECT_EQ(message(), "Not sent: that is outside of the map.");
  EXPECT_TRUE(requests_.empty());
  aimAt(3.0, 3.0);
  EXPECT_EQ(requests_.size(), 1U) << "the next press may be better";
}

// [GUI-2]
TEST_F(MapPointer, EscapeEndsTheChoice) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  click("map_go");
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  QTest::keyClick(&picture(), Qt::Key_Escape);
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  EXPECT_FALSE(find<QPushButton>("map_go")->isChecked());
  aimAt(3.0, 2.0);
  EXPECT_TRUE(requests_.empty());
}

// [GUI-2]
TEST_F(MapPointer, IsZoomedByTheWheelMovedByADragAndFittedByADoubleClick) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  const QPoint corner = pixelOf(0.0, 0.0), place = pixelOf(4.0, 4.0);
  QWheelEvent wheel(place, picture().mapToGlobal(place), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&picture(), &wheel);
  EXPECT_LE((pixelOf(4.0, 4.0) - place).manhattanLength(), 2) << "the place under the pointer stays";
  EXPECT_GT((pixelOf(0.0, 0.0) - corner).manhattanLength(), 20);
  const QPoint zoomed = pixelOf(4.0, 4.0);
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, zoomed);
  QTest::mouseMove(&picture(), zoomed + QPoint(30, -20));
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, zoomed + QPoint(30, -20));
  EXPECT_LE((pixelOf(4.0, 4.0) - zoomed - QPoint(30, -20)).manhattanLength(), 2);
  widget_->setMap(viewOf(mapOf(80, 60, kFree)));
  EXPECT_LE((pixelOf(4.0, 4.0) - zoomed - QPoint(30, -20)).manhattanLength(), 2) << "what grows does not move it";
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  QTest::mouseDClick(&picture(), Qt::LeftButton, Qt::NoModifier, place);
  EXPECT_LE((pixelOf(0.0, 0.0) - corner).manhattanLength(), 2);
}

// [GUI-2]
TEST_F(MapPointer, NoGoalIsChosenWhileTheNavigationIsDown) {
  EXPECT_TRUE(find("map_go")->isEnabled());
  click("map_go");
  state_.navigate.server_up = false;
  widget_->setState(state_);
  EXPECT_FALSE(find("map_go")->isEnabled());
  EXPECT_FALSE(find<QPushButton>("map_go")->isChecked());
}

// [NAV-5]
TEST_F(MapPointer, CollectsWaypointsWithTheShiftKeyAndSendsThemInTheirOrder) {
  state_.waypoints.server_up = true;
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  widget_->setState(state_);
  EXPECT_FALSE(find("waypoints_follow")->isEnabled()) << "there are none yet";
  aimAt(3.0, 1.0, Qt::ShiftModifier);
  aimAt(3.0, 4.0, Qt::ShiftModifier);
  aimAt(3.0, 6.5, Qt::ShiftModifier);
  EXPECT_EQ(message(), "Not sent: that is outside of the map.");
  widget_->setState(state_);
  EXPECT_EQ(find<QPushButton>("waypoints_follow")->text(), "Follow 2 points");
  EXPECT_TRUE(requests_.empty()) << "nothing moves before that";
  click("waypoints_follow");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kFollowWaypoints);
  ASSERT_EQ(requests_[0].poses.size(), 2U);
  EXPECT_NEAR(requests_[0].poses[1].y, 4.0, 0.05);
  EXPECT_NEAR(requests_[0].poses[1].yaw, kPi / 2.0, 0.05) << "in the direction of the way from the one before";
  state_.waypoints.active = true;
  state_.waypoints.feedback = "on the way to waypoint 2";
  widget_->setState(state_);
  EXPECT_EQ(message(), "Waypoints: on the way to waypoint 2");
  click("waypoints_forget");
  EXPECT_TRUE(picture().waypoints().empty());
}

// [GUI-2]
TEST_F(MapPointer, ReturningToTheOriginPausesTheExplorerFirst) {
  click("map_return");
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kExplore);
  EXPECT_FALSE(requests_[0].on);
  EXPECT_EQ(requests_[1].kind, teleop::OperatorRequest::Kind::kGoTo);
  EXPECT_EQ(requests_[1].poses.at(0), Pose2());
}

// [GUI-2]
TEST_F(MapPointer, WaypointsAndAPressInProgressEndWithTheFrameTheyWereChosenIn) {
  state_.waypoints.server_up = true;
  widget_->setState(state_);
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  aimAt(3.0, 1.0, Qt::ShiftModifier);
  EXPECT_TRUE(find("waypoints_follow")->isEnabled());
  click("map_go");
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  teleop::MapView other = viewOf(mapOf(60, 60, kFree));
  other.scene.frame = "other_map";
  widget_->setMap(other);
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  EXPECT_TRUE(requests_.empty());
  EXPECT_TRUE(picture().waypoints().empty());
  EXPECT_FALSE(find("waypoints_follow")->isEnabled());
}

// [GUI-2] [NAV-5]
TEST_F(MapPointer, WaypointsAndTheChoiceOfAGoalEndWithTheMapTheyWereMadeOnAlsoInTheSameFrame) {
  state_.waypoints.server_up = true;
  widget_->setState(state_);
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  aimAt(3.0, 1.0, Qt::ShiftModifier);
  aimAt(3.0, 4.0, Qt::ShiftModifier);
  widget_->setMap(viewOf(mapOf(80, 60, kFree)));
  EXPECT_EQ(picture().waypoints().size(), 2U) << "that map has only grown";
  click("map_go");
  teleop::MapView other = viewOf(mapOf(80, 60, kFree));
  other.scene.replaced = 1;
  widget_->setMap(other);
  EXPECT_TRUE(picture().waypoints().empty());
  EXPECT_FALSE(find("waypoints_follow")->isEnabled());
  EXPECT_FALSE(find<QPushButton>("map_go")->isChecked());
  aimAt(3.0, 2.0, Qt::ShiftModifier);
  widget_->setMap(other);
  EXPECT_EQ(picture().waypoints().size(), 1U) << "it is replaced once, not with each view";
  EXPECT_TRUE(requests_.empty());
}

// [GUI-2]
TEST_F(MapPointer, APressBecomesNoGoalIfTheNavigationGoesDownMeanwhile) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  click("map_go");
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  state_.navigate.server_up = false;
  widget_->setState(state_);
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  EXPECT_TRUE(requests_.empty());
}

// [GUI-2]
TEST_F(MapPointer, StaysWhereItIsWhileAGoalIsChosen) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  const QPoint place = pixelOf(4.0, 4.0);
  click("map_go");
  widget_->setMap(viewOf(mapOf(120, 60, kFree)));
  EXPECT_EQ(pixelOf(4.0, 4.0), place);
  QTest::keyClick(&picture(), Qt::Key_Escape);
  widget_->setMap(viewOf(mapOf(120, 60, kFree)));
  EXPECT_NE(pixelOf(4.0, 4.0), place) << "afterwards it is fitted again";
}

// [GUI-2]
TEST_F(MapPointer, OnlyTheButtonThatWasPressedChoosesTheGoal) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  click("map_go");
  QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  QTest::mousePress(&picture(), Qt::RightButton, Qt::NoModifier, pixelOf(3.0, 3.0));
  QTest::mouseRelease(&picture(), Qt::RightButton, Qt::NoModifier, pixelOf(3.0, 3.0));
  EXPECT_TRUE(requests_.empty());
  QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, pixelOf(3.0, 2.0));
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_NEAR(requests_[0].poses.at(0).y, 2.0, 0.05);
}

// [FLT-1]
TEST_F(MapPointer, RefusesPlacesSoFarAwayThatTheyHaveNoCell) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  const QPoint left(5, 10), right(205, 10);
  QWheelEvent wheel(left, picture().mapToGlobal(left), {}, {0, -12000}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&picture(), &wheel);  // to the smallest scale: 200 pixels are 200 km
  for (int drag = 0; drag < 2000; ++drag) {
    QTest::mousePress(&picture(), Qt::LeftButton, Qt::NoModifier, left);
    QTest::mouseRelease(&picture(), Qt::LeftButton, Qt::NoModifier, right);
  }
  click("map_go");
  QTest::mouseClick(&picture(), Qt::LeftButton, Qt::NoModifier, left);
  EXPECT_EQ(message(), "Not sent: that is outside of the map.");
  EXPECT_TRUE(requests_.empty());
}

}  // namespace
}  // namespace frontier_pilot
