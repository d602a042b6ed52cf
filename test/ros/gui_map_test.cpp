// The map in the operator's window, against a live mapper and navigation of a simulated robot.

#include <gtest/gtest.h>
#include <ros/node_handle.h>
#include <std_msgs/Bool.h>

#include <QApplication>
#include <QFileDialog>
#include <QPushButton>
#include <cstdlib>
#include <filesystem>

#include "gui/controls.h"
#include "gui/map/map_picture.h"
#include "ros/gui_window.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

using test::waitFor;
using test::Window;

class MapOnTheWire : public ::testing::Test {
 protected:
  void SetUp() override {
    window_.widget.resize(1500, 900);
    ASSERT_TRUE(waitFor([&] { return !picture().image().empty() && robot().has_value(); }));
    ASSERT_TRUE(waitFor([&] { return window_.find("map_go")->isEnabled(); }));
    for (int pass = 0; pass < 3; ++pass) QApplication::processEvents();  // so that the cards have their sizes
  }
  gui::MapPicture& picture() { return *window_.widget.findChild<gui::MapPicture*>("map_picture"); }
  const std::optional<Pose2>& robot() { return picture().scene().T_map_base; }
  QString message() { return window_.widget.findChild<gui::ElidedLabel*>("map_message")->fullText(); }
  bool isKnownToBeFree(const Vec2& place) {
    return isFree(picture().image().at(picture().image().geometry().cellAt(place)));
  }
  /// Waits until the robot may be sent there.
  void press(const Vec2& place, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    EXPECT_TRUE(waitFor([&] { return isKnownToBeFree(place); })) << place.x() << ", " << place.y();
    QTest::mouseClick(&picture(), Qt::LeftButton, keys, picture().pixelOf(place).toPoint());
  }
  /// The operator chooses the file in the dialog that is open.
  void choose(const std::string& file) {
    auto* dialog = window_.widget.findChild<QFileDialog*>("map_file");
    ASSERT_NE(dialog, nullptr);
    emit dialog->fileSelected(QString::fromStdString(file));
    delete dialog;
  }
  bool comesTo(const Vec2& place) {
    return QTest::qWaitFor([&] { return robot() && (robot()->position() - place).norm() < 0.3; }, 40000);
  }

  Window window_;
};

// [GUI-2]
TEST_F(MapOnTheWire, ShowsTheMapAndSendsTheRobotWhereItIsPressed) {
  const Vec2 start = robot()->position(), there = start + Vec2(1.0, 0.0);
  window_.click("map_go");
  press(there);
  EXPECT_TRUE(waitFor([&] { return picture().scene().goal && !picture().scene().plan.empty(); })) << "both are shown";
  EXPECT_TRUE(comesTo(there)) << message().toStdString();
  window_.click("map_go");
  press(start);
  EXPECT_TRUE(comesTo(start));
}

// [GUI-2]
TEST_F(MapOnTheWire, TheGoalIsCancelledByTheButtonOfTheNavigation) {
  const Vec2 start = robot()->position();
  window_.click("map_go");
  press(start + Vec2(1.2, 0.0));
  ASSERT_TRUE(waitFor([&] { return (robot()->position() - start).norm() > 0.1; }));
  window_.click("navigation_cancel");
  EXPECT_TRUE(waitFor([&] { return !picture().scene().goal; }));
  EXPECT_TRUE(waitFor([&] { return window_.log().contains("navigation: canceled"); })) << window_.log().toStdString();
}

// [NAV-5]
TEST_F(MapOnTheWire, TheRobotFollowsTheWaypointsThatWereClicked) {
  const Vec2 start = robot()->position(), there = start + Vec2(0.8, 0.0);
  press(there, Qt::ShiftModifier);
  press(start, Qt::ShiftModifier);
  ASSERT_TRUE(waitFor([&] { return window_.find("waypoints_follow")->isEnabled(); }));
  window_.click("waypoints_follow");
  EXPECT_TRUE(comesTo(there));
  EXPECT_TRUE(comesTo(start));
  EXPECT_TRUE(waitFor([&] { return message() == "Waypoints: 2 of 2 waypoints reached"; })) << message().toStdString();
}

// [NAV-5]
TEST_F(MapOnTheWire, CancellingTheGoalEndsTheWaypoints) {
  const Vec2 start = robot()->position();
  press(start + Vec2(1.0, 0.0), Qt::ShiftModifier);
  press(start, Qt::ShiftModifier);
  ASSERT_TRUE(waitFor([&] { return window_.find("waypoints_follow")->isEnabled(); }));
  window_.click("waypoints_follow");
  ASSERT_TRUE(waitFor([&] { return (robot()->position() - start).norm() > 0.1; }));
  window_.click("navigation_cancel");
  // The waypoints' own cancel and the end of the goal on the way arrive in either order.
  const auto ended = [&] {
    return message().startsWith("Waypoints: canceled") || message().startsWith("Waypoints: aborted: the goal of ");
  };
  EXPECT_TRUE(waitFor(ended)) << message().toStdString();
  EXPECT_TRUE(waitFor([&] { return !picture().scene().goal; }));
}

// [GUI-2]
TEST_F(MapOnTheWire, ReturnsToTheOriginAndSavesAndLoadsTheMap) {
  const Vec2 away(1.0, 0.0);
  window_.click("map_go");
  press(away);
  ASSERT_TRUE(comesTo(away)) << message().toStdString();
  window_.click("map_return");
  EXPECT_TRUE(comesTo(Vec2::Zero()));
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "floor").string();
  ASSERT_TRUE(waitFor([&] { return window_.find("map_save")->isEnabled(); }));
  window_.click("map_save");
  choose(path + ".yaml");
  EXPECT_TRUE(waitFor([&] { return message().contains(QString::fromStdString(path)); })) << message().toStdString();
  EXPECT_TRUE(std::filesystem::exists(path + ".pgm"));
  window_.click("map_load");
  choose((folder.path() / "nothing.yaml").string());
  EXPECT_TRUE(waitFor([&] { return message().contains("nothing"); })) << message().toStdString();
}

// [MAP-5] Somebody says so for the mapper, which says once a second that it is not so.
TEST_F(MapOnTheWire, SaysThatTheRobotIsNotFoundOnTheMap_MAP_5) {
  ros::NodeHandle node;
  const ros::Publisher localized = node.advertise<std_msgs::Bool>("mapper/localized", 1);
  const auto says = [&](const char* words) { return picture().scene().problem.find(words) != std::string::npos; };
  EXPECT_TRUE(waitFor([&] {
    localized.publish(std_msgs::Bool());
    return says("The robot is not found on the map: give a pose in rviz, or call /mapper/localize.");
  }));
  EXPECT_TRUE(waitFor([&] { return !says("not found on the map"); }));
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::test::WindowProgram program(argc, argv, "gui_map_test");
  return program.runTests();
}
