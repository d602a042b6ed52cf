// What the operator is told in words: a stop that cannot be cleared, contacts, and what became of the goals. [GUI-2]

#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>

#include "gui/controls.h"
#include "gui_fixture.h"

namespace frontier_pilot {
namespace {

class Attention : public test::PilotWidgetTest {
 protected:
  using Kind = teleop::OperatorRequest::Kind;

  long asked(Kind kind) const {
    return std::count_if(requests_.begin(), requests_.end(), [kind](const auto& one) { return one.kind == kind; });
  }

  /// A stop whose clearing was refused, and the operator's click on the way out.
  void takeTheWayOut() {
    state_.emergency_stop = true;
    state_.clear_refusal = "nav asked to move 40 ms ago";
    widget_->setState(state_);
    click("halt_and_clear");
  }

  void refresh(int times) {
    for (int i = 0; i < times; ++i) widget_->setState(state_);
  }
};

// [GUI-2]
TEST_F(Attention, ARefusedClearSaysWhyAndOffersTheWayOut) {
  state_.emergency_stop = true;
  widget_->setState(state_);
  EXPECT_FALSE(find("halt_and_clear")->isVisible());
  state_.clear_refusal = "nav asked to move 40 ms ago";
  widget_->setState(state_);
  EXPECT_TRUE(find("halt_and_clear")->isVisible());
  EXPECT_EQ(text("clear_refusal"), "Not cleared: nav asked to move 40 ms ago.");
  EXPECT_EQ(find<QPushButton>("halt_and_clear")->text(), "Pause the explorer and clear");
  state_.explorer->running = false;
  state_.patrol.active = true;
  widget_->setState(state_);
  EXPECT_EQ(find<QPushButton>("halt_and_clear")->text(), "Stop the patrol and clear");
  state_.emergency_stop = false;
  widget_->setState(state_);
  EXPECT_FALSE(find("halt_and_clear")->isVisible());
}

// [GUI-2] The arbiter clears only when nothing has commanded motion for half a second.
TEST_F(Attention, TheWayOutHaltsWhatDrivesAndClearsWhenThatHasEnded) {
  state_.patrol.active = true;
  takeTheWayOut();
  EXPECT_EQ(asked(Kind::kExplore), 1);
  EXPECT_FALSE(requests_.front().on);
  EXPECT_EQ(asked(Kind::kStopPatrol), 1);
  EXPECT_EQ(asked(Kind::kStopSpin), 0);
  EXPECT_EQ(asked(Kind::kStopNavigation), 1);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 0) << "they have to end first";
  refresh(10);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 1);
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 3) << "it does not ask for ever";
  state_.emergency_stop = false;
  widget_->setState(state_);
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 3);
}

// [GUI-2] Only the stop that the operator wanted cleared is cleared.
TEST_F(Attention, AStopAfterTheWayOutIsNotCleared) {
  takeTheWayOut();
  QTest::mousePress(find("emergency_stop"), Qt::LeftButton);
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 0);
}

// [GUI-2]
TEST_F(Attention, AStopFromElsewhereAfterTheWayOutIsNotCleared) {
  takeTheWayOut();
  ++state_.arbiter->stops;
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 0);
}

// [GUI-2] A clear and the next stop can come between two refreshes.
TEST_F(Attention, NothingIsClearedOnceAClearHasSucceeded) {
  takeTheWayOut();
  refresh(10);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 1);
  state_.clear_refusal.clear();
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 1);
}

// [GUI-2]
TEST_F(Attention, AnOperatorWhoClearsTakesOverFromTheWayOut) {
  takeTheWayOut();
  click("clear_emergency_stop");
  refresh(100);
  EXPECT_EQ(asked(Kind::kClearEmergencyStop), 1);
}

// [GUI-1] [ARB-8] A stop and its clear can come between two refreshes: only their count tells of them.
TEST_F(Attention, AStopThatWasClearedUnseenDropsTheSetPoint_ARB_8) {
  click("Go");
  refresh(2);
  EXPECT_FALSE(widget_->setPoint().isZero());
  ++state_.arbiter->stops;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_TRUE(
      find<QPlainTextEdit>("log")->toPlainText().contains("set-point dropped: the robot was stopped meanwhile"));
  click("Go");
  refresh(2);
  EXPECT_FALSE(widget_->setPoint().isZero()) << "a new press drives";
}

// [GUI-2]
TEST_F(Attention, AContactIsShown) {
  EXPECT_FALSE(text("problems").contains("touches"));
  state_.contact = true;
  widget_->setState(state_);
  EXPECT_TRUE(text("problems").contains("The robot touches something"));
}

// [GUI-2] [ARB-7]
TEST_F(Attention, TheEmergencyStopStaysWhereItIsHoweverManyProblemsThereAre_GUI_2_ARB_7) {
  widget_->resize(240, 1400);  // as a panel of rviz
  QTest::qWait(50);
  const auto place = [this] { return find<QPushButton>("emergency_stop")->mapTo(widget_.get(), QPoint()); };
  const QPoint before = place();
  for (int i = 0; i < 12; ++i)
    state_.arbiter->problems.push_back("the master had forgotten this node as publisher of /cmd_vel_arbiter/topic" +
                                       std::to_string(i) + ": registered again");
  widget_->setState(state_);
  QTest::qWait(50);
  EXPECT_EQ(place(), before);
  EXPECT_TRUE(text("problems").contains("and 9 more")) << text("problems").toStdString();
}

// [GUI-2]
TEST_F(Attention, GoalsAreCountedAsDroppedReachedAndFailed) {
  state_.explorer->goals_dropped = 24;
  state_.explorer->goals_reached = 3;
  state_.explorer->goals_failed = 1;
  widget_->setState(state_);
  EXPECT_EQ(find<gui::ElidedLabel>("explorer_goals")->fullText(), "Goals: 24 dropped, 3 reached, 1 failed");
}

// [GUI-2]
TEST_F(Attention, TheGoalOfTheNavigationIsShownAndCanBeCancelled) {
  EXPECT_FALSE(find("navigation_cancel")->isEnabled()) << "there is nothing to cancel";
  state_.navigation = teleop::NavigationView{0.0,  teleop::Severity::kWarning,        true, Vec2(3.0, -1.26), 12.34,
                                             75.4, "recovering (backing up): blocked"};
  widget_->setState(state_);
  EXPECT_EQ(text("navigation_goal"), "3.0, -1.3");
  EXPECT_EQ(text("navigation_distance"), "12.3 m");
  EXPECT_EQ(text("navigation_time"), "1 min 15 s");
  EXPECT_EQ(find<gui::ElidedLabel>("navigation_status")->fullText(), "recovering (backing up): blocked");
  click("navigation_cancel");
  EXPECT_EQ(asked(Kind::kStopNavigation), 1);
  state_.navigation = teleop::NavigationView();
  state_.navigation->status = "idle: canceled";
  widget_->setState(state_);
  EXPECT_FALSE(find("navigation_cancel")->isEnabled());
  EXPECT_EQ(find<gui::ElidedLabel>("navigation_status")->fullText(), "idle: canceled");
}

TEST_F(Attention, AMasterThatIsGoneDoesNotHideThatTheStopWorks_GUI_2) {
  state_.connected = false;
  state_.stop_service_up = true;
  widget_->setState(state_);
  EXPECT_EQ(text("summary"), "Waiting for it to answer. The emergency stop works without it.");
  state_.stop_service_up = false;
  widget_->setState(state_);
  EXPECT_EQ(text("summary"), "Waiting for it to answer.");
}

}  // namespace
}  // namespace frontier_pilot
