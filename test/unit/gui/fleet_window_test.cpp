#include "gui/fleet_window.h"

#include <QLabel>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "gui/controls.h"
#include "gui_fixture.h"
#include "recording_link.h"

namespace frontier_pilot {
namespace {

/// Robots whose links write down what they are told; the recordings live as long as the fleet.
class RecordingFleet : public teleop::FleetLink {
 public:
  /// What the window gets.
  class Forwarding : public teleop::OperatorLink {
   public:
    explicit Forwarding(test::RecordingLink& to) : to_(to) {}
    /// Time stands still: a window on a busy computer is not taken for one that was frozen.
    SteadyTime now() const override { return SteadyTime(std::chrono::hours(1)); }
    teleop::OperatorState state() override { return to_.state(); }
    void beat(const Twist2& set_point) override { to_.beat(set_point); }
    void request(const teleop::OperatorRequest& request) override { to_.request(request); }
    teleop::MapView takeMap() override { return to_.takeMap(); }
    std::vector<teleop::OperatorLogLine> takeLog() override { return to_.takeLog(); }
    bool running() const override { return to_.running(); }
    void close() override { to_.close(); }

   private:
    test::RecordingLink& to_;
  };

  teleop::FleetView fleet() override { return view; }
  teleop::OpenedRobot openOwn() override { return {"", {}, std::make_unique<Forwarding>(links[""])}; }
  void open(const std::string& robot) override {
    asked.push_back(robot);
    opened_ = robot;
  }
  std::optional<teleop::OpenedRobot> takeOpened() override {
    if (!opens || opened_.empty()) return std::nullopt;
    const std::string name = std::exchange(opened_, {});
    if (broken) return teleop::OpenedRobot{name, {}, nullptr};
    return teleop::OpenedRobot{name, {}, std::make_unique<Forwarding>(links[name]), described};
  }
  void retire(std::unique_ptr<teleop::OperatorLink> link) override { retired.push_back(std::move(link)); }
  void stopAll() override { ++stops; }
  void stop(const std::string& robot) override { stopped.push_back(robot); }

  teleop::FleetView view;
  std::map<std::string, test::RecordingLink> links;
  std::vector<std::string> asked, stopped;
  std::vector<std::unique_ptr<teleop::OperatorLink>> retired;
  bool opens = true, broken = false, described = true;
  int stops = 0;

 private:
  std::string opened_;
};

teleop::FleetView twoRobots() {
  teleop::FleetView view;
  view.connected = true;
  view.robots = {{"robot1", teleop::Severity::kActive, "explores, 63 % seen: goal sent"},
                 {"robot2", teleop::Severity::kWarning, "waiting: waits for robot1"}};
  return view;
}

class FleetWindowTest : public ::testing::Test {
 protected:
  void open(const teleop::FleetView& view) {
    fleet_.view = view;
    window_ = std::make_unique<gui::FleetWindow>(fleet_);
    window_->resize(1300, 900);
    window_->show();
  }
  /// Nobody is in the window's own namespace.
  void openOnRobots() {
    fleet_.links[""].shown.arbiter.reset();
    open(twoRobots());
    ASSERT_TRUE(QTest::qWaitFor([this] { return window_->shown() == "robot1"; }));
  }
  QWidget* find(const char* name) { return window_->findChild<QWidget*>(name); }
  QPushButton* button(const char* name) { return window_->findChild<QPushButton*>(name); }
  void click(const char* name) { QTest::mouseClick(find(name), Qt::LeftButton); }

  RecordingFleet fleet_;
  std::unique_ptr<gui::FleetWindow> window_;
};

// [GUI-1]
TEST_F(FleetWindowTest, WithoutAFleetItIsTheWindowOfOneRobot_GUI_1) {
  open({});
  EXPECT_FALSE(QTest::qWaitFor([this] { return find("stop_all")->isVisible(); }, 500));
  EXPECT_TRUE(fleet_.asked.empty());
}

// [GUI-2]
TEST_F(FleetWindowTest, ShowsTheFirstRobotAndWhatEachDoes_GUI_2) {
  openOnRobots();
  EXPECT_TRUE(find("stop_all")->isVisible());
  for (const char* name : {"robot_robot1", "robot_robot2", "robot_state_robot2"})
    EXPECT_TRUE(QTest::qWaitFor([&] { return find(name)->visibleRegion().boundingRect().height() >= 10; })) << name;
  const auto text = [this](const char* name) { return window_->findChild<gui::ElidedLabel*>(name)->fullText(); };
  EXPECT_EQ(text("robot_state_robot1"), "explores, 63 % seen: goal sent");
  EXPECT_EQ(text("robot_state_robot2"), "waiting: waits for robot1");
  EXPECT_TRUE(button("robot_robot1")->isChecked());
  EXPECT_FALSE(button("robot_robot2")->isChecked());
  EXPECT_TRUE(window_->windowTitle().startsWith("robot1"));
}

// [GUI-1] [GUI-3] the robot that is left is told to stand, and hears nothing any more but a stop that was pressed
TEST_F(FleetWindowTest, AnotherRobotIsChosenByAClickAndTheFirstOneIsLetGo_GUI_1) {
  openOnRobots();
  click("Go");
  ASSERT_FALSE(fleet_.links["robot1"].beats.back().isZero());
  fleet_.retired.clear();
  click("robot_robot2");
  EXPECT_TRUE(fleet_.links["robot1"].beats.back().isZero()) << "at once";
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_->shown() == "robot2"; }));
  EXPECT_EQ(fleet_.links["robot1"].closed, 1);
  EXPECT_EQ(fleet_.retired.size(), 1U) << "the link is kept";
  const std::size_t heard = fleet_.links["robot1"].beats.size();
  EXPECT_TRUE(QTest::qWaitFor([this] { return find("patrol(sqr)")->isEnabled(); }));
  click("patrol(sqr)");
  EXPECT_TRUE(QTest::qWaitFor([this] { return fleet_.links["robot2"].beats.size() > 3; }));
  for (const Twist2& beat : fleet_.links["robot2"].beats) EXPECT_TRUE(beat.isZero());
  EXPECT_EQ(fleet_.links["robot1"].beats.size(), heard);
  EXPECT_TRUE(fleet_.links["robot1"].requests.empty());
  ASSERT_EQ(fleet_.links["robot2"].requests.size(), 1U);
  EXPECT_TRUE(QTest::qWaitFor([this] { return button("robot_robot2")->isChecked(); }));
  EXPECT_FALSE(button("robot_robot1")->isChecked());
}

// [GUI-1]
TEST_F(FleetWindowTest, SpaceStopsTheRobotAfterAClickAnywhereInTheListOfRobots_GUI_1) {
  openOnRobots();
  QApplication::setActiveWindow(window_.get());
  for (const char* where : {"robot_state_robot2", "robot_robot1", "fleetBody", "fleetScroll"}) {
    click("Go");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !fleet_.links["robot1"].beats.back().isZero(); })) << where;
    click(where);
    ASSERT_NE(QApplication::focusWidget(), nullptr) << where;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor([this] { return fleet_.links["robot1"].beats.back().isZero(); })) << where;
  }
}

// [GUI-1] [MUL-4] whoever presses it just after the click on a name means the robot that was chosen
TEST_F(FleetWindowTest, AStopThatIsPressedBeforeTheChosenRobotIsOpenStopsBoth_GUI_1) {
  openOnRobots();
  fleet_.opens = false;
  click("robot_robot2");
  click("emergency_stop");
  ASSERT_EQ(fleet_.links["robot1"].requests.size(), 1U);
  EXPECT_EQ(fleet_.stopped, std::vector<std::string>{"robot2"}) << "whatever becomes of its opening";
  click("stop_all");
  EXPECT_EQ(fleet_.stopped, (std::vector<std::string>{"robot2", "robot2"}));
  fleet_.opens = true;
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_->shown() == "robot2"; }));
  click("emergency_stop");
  EXPECT_EQ(fleet_.stopped.size(), 2U) << "it has a link of its own now";
  EXPECT_EQ(fleet_.links["robot2"].requests.size(), 1U);
}

// [GUI-2] [MUL-1] a window that is opened before the robot knows neither its map nor its outline
TEST_F(FleetWindowTest, ARobotThatWasOpenedBeforeItRanIsOpenedAgainWhenItRuns_GUI_2_MUL_1) {
  fleet_.described = false;
  fleet_.links["robot1"].shown.arbiter.reset();
  openOnRobots();
  EXPECT_FALSE(QTest::qWaitFor([this] { return fleet_.asked.size() > 1; }, 500)) << "it does not run yet";
  fleet_.links["robot1"].shown.arbiter.emplace();
  EXPECT_TRUE(QTest::qWaitFor([this] { return fleet_.asked.size() == 2; }));
  EXPECT_FALSE(QTest::qWaitFor([this] { return fleet_.asked.size() > 2; }, 500)) << "once, if it still says nothing";
  fleet_.described = true;
  fleet_.links["robot1"].shown.spin.own = true;
  click("robot_robot1");
  EXPECT_EQ(fleet_.asked.size(), 2U) << "what was begun here would end";
  fleet_.links["robot1"].shown.spin.own = false;
  fleet_.links["robot1"].shown.navigate.active = true;  // the goal of an explorer
  EXPECT_TRUE(QTest::qWaitFor([this] {
    click("robot_robot1");
    return fleet_.asked.size() == 3;
  })) << "a click asks for it";
  EXPECT_FALSE(QTest::qWaitFor([this] { return fleet_.asked.size() > 3; }, 500));
}

// [GUI-2] [GUI-3]
TEST_F(FleetWindowTest, ARobotThatCannotBeOpenedAgainIsNotTriedForEver_GUI_2_GUI_3) {
  fleet_.described = false;
  fleet_.links["robot1"].shown.arbiter.reset();
  openOnRobots();
  fleet_.broken = true;
  fleet_.links["robot1"].shown.arbiter.emplace();
  EXPECT_TRUE(QTest::qWaitFor([this] { return fleet_.asked.size() == 2; }));
  EXPECT_FALSE(QTest::qWaitFor([this] { return fleet_.asked.size() > 2; }, 1000));
  EXPECT_EQ(window_->shown(), "robot1");
}

// [GUI-3] until the next robot is there, the window goes on with the one that it shows
TEST_F(FleetWindowTest, ARobotThatDoesNotOpenLeavesTheOneThatIsShown_GUI_3) {
  openOnRobots();
  fleet_.opens = false;
  click("robot_robot2");
  const std::size_t beats = fleet_.links["robot1"].beats.size();
  EXPECT_TRUE(QTest::qWaitFor([&] { return fleet_.links["robot1"].beats.size() > beats + 3; }));
  fleet_.opens = fleet_.broken = true;
  QTest::qWait(500);
  EXPECT_EQ(window_->shown(), "robot1");
  EXPECT_TRUE(button("robot_robot1")->isChecked());
  fleet_.broken = false;
  click("robot_robot2");
  EXPECT_TRUE(QTest::qWaitFor([this] { return window_->shown() == "robot2"; })) << "it may be chosen again";
}

// [GUI-1]
TEST_F(FleetWindowTest, TheRobotInTheWindowsOwnNamespaceIsNotLeftByItself_GUI_1) {
  open(twoRobots());
  EXPECT_FALSE(QTest::qWaitFor([this] { return !fleet_.asked.empty(); }, 600));
  EXPECT_TRUE(find("stop_all")->isVisible());
}

TEST_F(FleetWindowTest, ARobotThatIsShownIsNotOpenedAgain) {
  openOnRobots();
  click("robot_robot1");
  EXPECT_EQ(fleet_.asked, std::vector<std::string>{"robot1"});
}

// [GUI-2] [MUL-4]
TEST_F(FleetWindowTest, StopsAllRobotsAndShowsTheAnswer_MUL_4) {
  openOnRobots();
  click("Go");
  click("stop_all");
  EXPECT_EQ(fleet_.stops, 1);
  ASSERT_EQ(fleet_.links["robot1"].requests.size(), 1U) << "and the robot that is shown, by itself";
  EXPECT_EQ(fleet_.links["robot1"].requests[0].kind, teleop::OperatorRequest::Kind::kEmergencyStop);
  EXPECT_TRUE(fleet_.links["robot1"].beats.back().isZero());
  fleet_.view.stop = {teleop::Severity::kGood, "2 of 2 robots stopped"};
  const auto* answer = window_->findChild<QLabel*>("stop_all_answer");
  EXPECT_TRUE(QTest::qWaitFor([&] { return answer->text() == "2 of 2 robots stopped"; }));
}

// [GUI-3] opening a link asks the master, which would hold up the window
TEST_F(FleetWindowTest, NoRobotIsChosenWithoutAMaster_GUI_3) {
  openOnRobots();
  fleet_.view.connected = false;
  EXPECT_TRUE(QTest::qWaitFor([this] { return !button("robot_robot2")->isEnabled(); }));
}

// [GUI-3]
TEST_F(FleetWindowTest, AFleetThatAppearsWithoutAMasterIsNotOpened_GUI_3) {
  fleet_.links[""].shown.arbiter.reset();
  teleop::FleetView view = twoRobots();
  view.connected = false;
  open(view);
  EXPECT_FALSE(QTest::qWaitFor([this] { return !fleet_.asked.empty(); }, 600));
}

// [GUI-2] many robots leave room for the emergency stop below them
TEST_F(FleetWindowTest, ManyRobotsDoNotPushTheEmergencyStopOffTheScreen_GUI_2) {
  fleet_.links[""].shown.arbiter.reset();
  teleop::FleetView view = twoRobots();
  for (int i = 3; i <= 40; ++i) view.robots.push_back({"robot" + std::to_string(i), teleop::Severity::kGood, "stands"});
  open(view);
  ASSERT_TRUE(QTest::qWaitFor([this] { return find("robot_robot40") != nullptr; }));
  EXPECT_TRUE(QTest::qWaitFor([this] {
    const QWidget* stop = find("emergency_stop");
    return stop->mapTo(window_.get(), QPoint(0, stop->height())).y() < window_->height() / 2;
  }));
}

// [GUI-2] robots come and go
TEST_F(FleetWindowTest, ShowsRobotsThatComeLater_GUI_2) {
  openOnRobots();
  fleet_.view.robots.push_back({"robot3", teleop::Severity::kError, "silent for 5 s"});
  EXPECT_TRUE(QTest::qWaitFor([this] { return find("robot_robot3") != nullptr; }));
  EXPECT_EQ(window_->shown(), "robot1");
}

// [GUI-3]
TEST_F(FleetWindowTest, ClosesTheRobotThatIsShownWhenItCloses_GUI_3) {
  openOnRobots();
  window_->release();
  EXPECT_EQ(fleet_.links["robot1"].closed, 1);
  window_.reset();
  EXPECT_EQ(fleet_.links["robot1"].closed, 1);
}

}  // namespace
}  // namespace frontier_pilot
