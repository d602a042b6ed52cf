#include <QDir>
#include <QFileDialog>
#include <QWheelEvent>

#include "gui/map/map_picture.h"
#include "gui_fixture.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

/// A map of that many cells of 10 cm whose lower left corner is the origin, all of them of one value.
teleop::MapChange mapOf(int width, int height, std::int8_t value) {
  teleop::MapChange change;
  change.geometry.resolution = 0.1;
  change.geometry.width = width;
  change.geometry.height = height;
  change.rect = change.geometry.rect();
  change.cells.assign(change.geometry.size(), value);
  return change;
}

teleop::MapView viewOf(teleop::MapChange change) {
  teleop::MapView view;
  view.change = std::move(change);
  view.scene.frame = "map";
  view.scene.T_map_base = Pose2(1.0, 1.0, 0.0);
  return view;
}

teleop::MapChange blockOf(const teleop::MapChange& map, const CellRect& rect, std::int8_t value) {
  teleop::MapChange change{map.geometry, rect, {}};
  change.cells.assign(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height), value);
  return change;
}

class MapInTheWindow : public test::PilotWidgetTest {
 protected:
  void SetUp() override {
    PilotWidgetTest::SetUp();
    state_.navigate.server_up = true;
    widget_->setState(state_);
    widget_->resize(1500, 900);
    for (int pass = 0; pass < 3; ++pass) QApplication::processEvents();
  }
  gui::MapPicture& picture() { return *find<gui::MapPicture>("map_picture"); }
  QPoint pixelOf(double x, double y) { return picture().pixelOf({x, y}).toPoint(); }
  QColor colorAt(double x, double y) { return picture().grab().toImage().pixelColor(pixelOf(x, y)); }
  void aimAt(double x, double y, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QTest::mouseClick(&picture(), Qt::LeftButton, keys, pixelOf(x, y));
  }
  QString message() { return find<gui::ElidedLabel>("map_message")->fullText(); }
};

// [GUI-2]
TEST_F(MapInTheWindow, IsDrawnWithItsWallsAndWhatChangesInIt) {
  const teleop::MapChange map = mapOf(60, 60, kFree);
  widget_->setMap(viewOf(map));
  const QColor free = colorAt(4.0, 2.0);
  widget_->setMap(viewOf(blockOf(map, {38, 18, 6, 6}, kOccupied)));
  EXPECT_LT(colorAt(4.05, 2.05).lightness(), free.lightness() - 80);
  EXPECT_EQ(colorAt(4.0, 4.0), free) << "nothing else has changed";
}

// [GUI-2]
TEST_F(MapInTheWindow, ShowsThinWallsOfAMapThatIsMuchLargerThanThePicture) {
  const teleop::MapChange map = mapOf(4000, 4000, kFree);
  widget_->setMap(viewOf(map));
  const QColor free = colorAt(200.0, 100.0);
  widget_->setMap(viewOf(blockOf(map, {0, 2000, 4000, 1}, kOccupied)));
  const QImage image = picture().grab().toImage();
  const int column = pixelOf(100.0, 200.0).x(), row = pixelOf(100.0, 200.0).y();
  int darkest = 255;
  for (int y = row - 3; y <= row + 3; ++y) darkest = std::min(darkest, image.pixelColor(column, y).lightness());
  EXPECT_LT(darkest, free.lightness() - 80);
}

// [GUI-2]
TEST_F(MapInTheWindow, MayChangeItsSizeAndShrinks) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  widget_->setMap(viewOf(mapOf(101, 33, kUnknown)));
  EXPECT_EQ(picture().image().geometry().width, 101);
  EXPECT_EQ(picture().image().at({100, 32}), kUnknown);
  widget_->setMap(viewOf(mapOf(1, 1, kOccupied)));
  EXPECT_EQ(picture().image().at({0, 0}), kOccupied);
  picture().grab();
}

// [FLT-1]
TEST_F(MapInTheWindow, LeavesOutChangesThatDoNotFit) {
  const teleop::MapChange map = mapOf(10, 10, kFree);
  teleop::MapChange beyond = blockOf(map, {5, 5, 6, 1}, kOccupied), short_of = blockOf(map, {0, 0, 3, 3}, kOccupied);
  widget_->setMap(viewOf(beyond));
  EXPECT_TRUE(picture().image().empty());
  widget_->setMap(viewOf(map));
  short_of.cells.pop_back();
  for (const teleop::MapChange& change : {beyond, short_of}) widget_->setMap(viewOf(change));
  EXPECT_EQ(picture().image().at({5, 5}), kFree);
  EXPECT_EQ(picture().image().at({0, 0}), kFree);
}

// [GUI-2]
TEST_F(MapInTheWindow, SaysInWordsWhatIsMissing) {
  teleop::MapView view;
  view.scene.problem = "No map: nobody publishes /map.";
  const QImage before = picture().grab().toImage();
  widget_->setMap(view);
  EXPECT_NE(picture().grab().toImage(), before);
  EXPECT_FALSE(picture().scene().problem.empty());
}

// [GUI-2]
TEST_F(MapInTheWindow, SendsTheRobotWhereItIsPressedInTheDirectionOfTheDrag) {
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
TEST_F(MapInTheWindow, WithoutADragTheRobotArrivesInTheDirectionOfItsWay) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  click("map_go");
  aimAt(1.0, 4.0);
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_NEAR(requests_[0].poses[0].yaw, kPi / 2.0, 0.05) << "it stands at (1, 1)";
}

// [GUI-2]
TEST_F(MapInTheWindow, RefusesPlacesThatAreNotFreeAndSaysWhy) {
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
TEST_F(MapInTheWindow, EscapeEndsTheChoice) {
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
TEST_F(MapInTheWindow, IsZoomedByTheWheelMovedByADragAndFittedByADoubleClick) {
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
TEST_F(MapInTheWindow, NoGoalIsChosenWhileTheNavigationIsDown) {
  EXPECT_TRUE(find("map_go")->isEnabled());
  click("map_go");
  state_.navigate.server_up = false;
  widget_->setState(state_);
  EXPECT_FALSE(find("map_go")->isEnabled());
  EXPECT_FALSE(find<QPushButton>("map_go")->isChecked());
}

// [NAV-5]
TEST_F(MapInTheWindow, CollectsWaypointsWithTheShiftKeyAndSendsThemInTheirOrder) {
  state_.waypoints.server_up = true;
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  widget_->setState(state_);
  EXPECT_FALSE(find("waypoints_follow")->isEnabled()) << "there are none yet";
  aimAt(3.0, 1.0, Qt::ShiftModifier);
  aimAt(3.0, 4.0, Qt::ShiftModifier);
  aimAt(3.0, 6.5, Qt::ShiftModifier);
  EXPECT_EQ(message(), "Not sent: that is outside of the map.");
  widget_->setState(state_);
  EXPECT_EQ(find<QPushButton>("waypoints_follow")->text(), "Follow 2");
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
TEST_F(MapInTheWindow, ReturningToTheStartPausesTheExplorerAndGoesToTheOrigin) {
  click("map_return");
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kExplore);
  EXPECT_FALSE(requests_[0].on);
  EXPECT_EQ(requests_[1].kind, teleop::OperatorRequest::Kind::kGoTo);
  EXPECT_EQ(requests_[1].poses.at(0), Pose2());
}

// [GUI-2]
TEST_F(MapInTheWindow, IsSavedAndLoadedByFileAndTheAnswerIsShown) {
  EXPECT_FALSE(find("map_save")->isEnabled()) << "the service is down";
  state_.save_map_up = state_.load_map_up = true;
  widget_->setState(state_);
  const test::TemporaryFolder folder;
  const QString before = QDir::currentPath();
  QDir::setCurrent(QString::fromStdString(folder.path().string()));
  click("map_save");
  auto* dialog = find<QFileDialog>("map_file");
  EXPECT_FALSE(dialog->isModal()) << "the emergency stop can be pressed meanwhile";
  EXPECT_EQ(dialog->directory().dirName(), "maps");
  emit dialog->fileSelected(dialog->directory().filePath("floor.yaml"));
  dialog->close();
  QDir::setCurrent(before);
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kSaveMap);
  EXPECT_EQ(requests_[0].name, (folder.path() / "maps/floor").string());
  state_.map_answer = {1, false, "the disk is full"};
  widget_->setState(state_);
  EXPECT_EQ(message(), "the disk is full");
}

}  // namespace
}  // namespace frontier_pilot
