#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSpinBox>
#include <array>

#include "gui_fixture.h"

namespace frontier_pilot {
namespace {

using Kind = teleop::OperatorRequest::Kind;

class Showing : public test::PilotWidgetTest {};

// [GUI-2]
TEST_F(Showing, TheEmergencyStopShowsTheLatchedTopicAndNotTheClick) {
  auto* stop = find<QPushButton>("emergency_stop");
  click("Go");
  click("emergency_stop");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, Kind::kEmergencyStop);
  EXPECT_TRUE(widget_->setPoint().isZero());
  widget_->setState(state_);
  EXPECT_EQ(stop->text(), "EMERGENCY STOP") << "not confirmed by the topic yet";
  EXPECT_FALSE(find("clear_emergency_stop")->isEnabled());
  state_.emergency_stop = true;
  widget_->setState(state_);
  EXPECT_EQ(stop->text(), "STOPPED");
  click("clear_emergency_stop");
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[1].kind, Kind::kClearEmergencyStop);
  EXPECT_EQ(stop->text(), "STOPPED") << "not cleared by the click";
}

// [GUI-2]
TEST_F(Showing, TheEmergencyStopCanBePressedWhateverTheState) {
  for (const std::optional<bool> latched : {std::optional<bool>(), std::optional<bool>(true)}) {
    state_.emergency_stop = latched;
    state_.stop_service_up = false;
    widget_->setState(state_);
    EXPECT_TRUE(find("emergency_stop")->isEnabled());
  }
}

// [GUI-2]
TEST_F(Showing, SaysWhoDrivesNow) {
  EXPECT_EQ(text("driver"), "manual drives");
  state_.arbiter->active_source = "nav";
  widget_->setState(state_);
  EXPECT_EQ(text("driver"), "nav drives");
  state_.arbiter->command = {};
  widget_->setState(state_);
  EXPECT_EQ(text("driver"), "nav holds the robot still");
  state_.arbiter->active_source.clear();
  widget_->setState(state_);
  EXPECT_EQ(text("driver"), "Nobody drives");
  state_.emergency_stop = true;
  widget_->setState(state_);
  EXPECT_EQ(text("driver"), "Emergency stop");
  state_.arbiter->status_age = 10.0;
  widget_->setState(state_);
  EXPECT_EQ(text("driver"), "Arbiter silent");
}

// [GUI-2]
TEST_F(Showing, TheDetailUnderTheHeadlineDoesNotRepeatIt) {
  state_.arbiter->active_source = "nav";
  state_.arbiter->summary = "nav drives";
  state_.arbiter->command = {0.18, -0.3};
  widget_->setState(state_);
  EXPECT_EQ(text("summary"), "The wheels get 0.18 m/s, -0.30 rad/s.");
  state_.arbiter->summary = "nav drives; avoid is required but silent";
  widget_->setState(state_);
  EXPECT_EQ(text("summary"), "avoid is required but silent");
  state_.emergency_stop = true;
  state_.arbiter->summary = "emergency stop: called by /somebody";
  state_.arbiter->problems = {state_.arbiter->summary};
  widget_->setState(state_);
  EXPECT_EQ(text("summary"), "called by /somebody");
  EXPECT_EQ(text("problems"), "");
}

// [GUI-2]
TEST_F(Showing, WhatHappensIsInTheLog) {
  state_.emergency_stop = true;
  widget_->setState(state_);
  EXPECT_TRUE(find<QPlainTextEdit>("log")->toPlainText().contains("emergency stop"));
}

// [GUI-2]
TEST_F(Showing, EverySourceHasASwitchThatAsksAndShowsTheStatusAlone) {
  for (const teleop::SourceView& source : state_.arbiter->sources) {
    const std::string name = "enable_" + source.name;
    auto* toggle = find<QAbstractButton>(name.c_str());
    ASSERT_TRUE(toggle->isChecked());
    requests_.clear();
    toggle->click();
    ASSERT_EQ(requests_.size(), 1U) << name;
    EXPECT_EQ(requests_[0].kind, Kind::kEnableSource);
    EXPECT_EQ(requests_[0].name, source.name);
    EXPECT_FALSE(requests_[0].on);
    EXPECT_TRUE(toggle->isChecked()) << "only the status moves the switch";
  }
  state_.arbiter->sources[3].enabled = false;
  widget_->setState(state_);
  EXPECT_FALSE(find<QAbstractButton>("enable_nav")->isChecked());
}

// [GUI-2]
TEST_F(Showing, EverySourceShowsItsStateAndTheAgeOfItsLastMessage) {
  EXPECT_TRUE(text("source_age_nav").contains("0.05 s"));
  EXPECT_TRUE(text("source_age_behavior").contains("no message"));
  EXPECT_TRUE(text("source_state_nav").startsWith("drives"));
}

// [GUI-2]
TEST_F(Showing, TheAvoiderAndTheExplorerAreSwitchedAndShown) {
  find<QAbstractButton>("obstacle_avoider")->click();
  click("explore_pause");
  click("explore_reset");
  state_.explorer->running = false;
  widget_->setState(state_);
  click("explore_start");
  ASSERT_EQ(requests_.size(), 4U);
  EXPECT_EQ(requests_[0].kind, Kind::kEnableAvoider);
  EXPECT_FALSE(requests_[0].on);
  EXPECT_EQ(requests_[1].kind, Kind::kExplore);
  EXPECT_FALSE(requests_[1].on);
  EXPECT_EQ(requests_[2].kind, Kind::kResetExplorer);
  EXPECT_TRUE(requests_[3].on);
  EXPECT_EQ(text("explored_area"), "387.4 m²");
  EXPECT_TRUE(text("explorer_state").contains("NAVIGATING"));
}

// [GUI-1]
TEST_F(Showing, ThePatrolButtonsAskForTheirShapeWithSideAndLaps) {
  find<QDoubleSpinBox>("patrol_side")->setValue(1.5);
  find<QSpinBox>("patrol_laps")->setValue(3);
  click("Go");
  click("patrol(sqr)");
  EXPECT_TRUE(widget_->setPoint().isZero()) << "the hand does not drive on after the patrol";
  click("patrol(tri)");
  click("patrol(cir)");
  ASSERT_EQ(requests_.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const teleop::OperatorRequest& request = requests_[static_cast<std::size_t>(i)];
    EXPECT_EQ(request.kind, Kind::kPatrol);
    EXPECT_EQ(request.shape, i + 1);
    EXPECT_DOUBLE_EQ(request.side, 1.5);
    EXPECT_EQ(request.laps, 3);
  }
}

// [GUI-1]
TEST_F(Showing, PatrolStopCancelsAndStopsTheHand) {
  click("Go");
  click("patrol stop");
  EXPECT_TRUE(widget_->setPoint().isZero());
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, Kind::kStopPatrol);
}

TEST_F(Showing, TheSpinButtonsAskForTheAngleAndForItsEnd) {
  find<QSpinBox>("spin_angle")->setValue(-90);
  click("Go");
  click("spin");
  EXPECT_TRUE(widget_->setPoint().isZero()) << "the hand does not drive on after the turn";
  click("spin stop");
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].kind, Kind::kSpin);
  EXPECT_NEAR(requests_[0].angle, -kPi / 2.0, 1e-12);
  EXPECT_EQ(requests_[1].kind, Kind::kStopSpin);
  state_.spin.active = true;
  state_.spin.feedback = "turned -40°";
  widget_->setState(state_);
  EXPECT_EQ(text("spin_progress"), "turned -40°");
}

/// What comes and goes above a button must not push it away from the pointer.
TEST_F(Showing, ButtonsKeepTheirPlacesWhateverIsTold) {
  const std::array<const char*, 5> buttons{"patrol stop", "spin", "spin stop", "explore_start", "explore_pause"};
  const auto places = [&] {
    // A column that is higher than the window gets its full height only in a second pass.
    for (int pass = 0; pass < 3; ++pass) QApplication::processEvents();
    std::vector<QPoint> out;
    for (const char* name : buttons) out.push_back(find(name)->mapTo(widget_.get(), QPoint()));
    return out;
  };
  widget_->resize(1200, 800);
  state_.patrol.result = state_.spin.result = state_.explorer->reason_text = "";
  widget_->setState(state_);
  const std::vector<QPoint> before = places();
  state_.patrol.result =
      "aborted: blocked for 10 s: avoid holds the wheels, and more of it than one line could ever hold";
  state_.arbiter->active_source = "behavior";
  state_.explorer->reason_text =
      "nothing left to see at the goal, now to (-12.08, -14.82), 14.5 m away, 11.38 m2 to see, score -1.87";
  widget_->setState(state_);
  EXPECT_EQ(places(), before);
}

TEST_F(Showing, TheHintTellsWhetherTheSetPointWaitsOrIsDropped) {
  const auto hint = [&](const char* source, double age) {
    state_.arbiter->active_source = source, state_.arbiter->status_age = age;
    widget_->setState(state_);
    return find("drive_hint")->toolTip();
  };
  EXPECT_EQ(hint("avoid", 0.0), "avoid drives; your set-point waits.");
  EXPECT_EQ(hint("nav", 0.0), "nav drives: the arrows have no effect.");
  EXPECT_EQ(hint("nav", 60.0), "Locked: the arbiter is silent.");
}

// [GUI-2]
TEST_F(Showing, PatrolFeedbackAndResultAreShown) {
  state_.patrol.active = true;
  state_.patrol.feedback = "line 3";
  widget_->setState(state_);
  EXPECT_EQ(text("patrol_progress"), "line 3");
  state_.patrol.active = false;
  widget_->setState(state_);
  EXPECT_EQ(text("patrol_progress"), "square patrol complete!!");
}

// [GUI-2]
TEST_F(Showing, TheLogIsBoundedAndTakesNoMarkupFromOutside) {
  for (int i = 0; i < 1000; ++i) widget_->appendLog({teleop::Severity::kIdle, "line " + std::to_string(i)});
  widget_->appendLog({teleop::Severity::kError, "<b>not bold</b>"});
  auto* log = find<QPlainTextEdit>("log");
  EXPECT_LE(log->document()->blockCount(), 300);
  EXPECT_TRUE(log->toPlainText().contains("<b>not bold</b>"));
}

// [FLT-1]
TEST_F(Showing, NoLabelAndNoToolTipTakesMarkupFromOutside) {
  const std::string name = "<img src='/tmp/file'>";
  state_.arbiter->sources[0].name = name;
  state_.arbiter->sources[0].service_up = true;
  widget_->setState(state_);
  for (const QLabel* label : widget_->findChildren<QLabel*>()) {
    EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
  }
  const QString tip = find(("enable_" + name).c_str())->toolTip();
  EXPECT_TRUE(tip.contains("&lt;img")) << tip.toStdString();
}

// [GUI-3]
TEST_F(Showing, ServicesThatAreDownGreyTheirButtonsAndSaySo) {
  state_.clear_service_up = state_.avoider_service_up = state_.explorer_service_up = state_.explorer_reset_up = false;
  state_.explorer_bounds_up = state_.explorer_inspections_up = state_.explorer_return_up = false;
  state_.patrol.server_up = state_.spin.server_up = false;
  state_.emergency_stop = true;
  for (teleop::SourceView& source : state_.arbiter->sources) source.service_up = false;
  widget_->setState(state_);
  for (const char* name : {"clear_emergency_stop", "enable_nav", "enable_avoid", "obstacle_avoider", "explore_start",
                           "explore_pause", "explore_reset", "clear_bounds", "clear_inspections", "return_to_start",
                           "patrol(sqr)", "patrol(tri)", "patrol(cir)", "spin"}) {
    EXPECT_FALSE(find(name)->isEnabled()) << name;
    EXPECT_TRUE(find(name)->toolTip().contains("down")) << name;
  }
  EXPECT_TRUE(text("source_state_nav").contains("down"));
  widget_->setState(test::exampleState());
  EXPECT_TRUE(find("patrol(sqr)")->isEnabled());
  EXPECT_TRUE(find("enable_nav")->isEnabled());
}

TEST_F(Showing, NothingIsInventedForWhatWasNeverHeardOf) {
  widget_->setState({});
  EXPECT_EQ(text("driver"), "No ROS master");
  EXPECT_EQ(text("explorer_state"), "not heard of");
  EXPECT_EQ(text("explored_area"), "–");
  EXPECT_FALSE(find("clear_emergency_stop")->isEnabled());
}

/// From a narrow dock of rviz to a wide screen.
TEST_F(Showing, NoCardIsCutOffAtAnyWidth) {
  auto* scroll = find<QScrollArea>("pilotScroll");
  const int em = widget_->fontMetrics().height();
  for (int width = em * 20; width < em * 110; width += em * 3) {
    widget_->resize(width, 800);
    QApplication::processEvents();
    EXPECT_EQ(widget_->width(), width);
    EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()) << "at " << width / em << " em";
  }
}

TEST_F(Showing, FollowsThePaletteOfTheApplication) {
  const QPalette before = QApplication::palette();
  const QColor light = widget_->grab().toImage().pixelColor(2, 2);
  QApplication::setPalette(QPalette(QColor("#222830"), QColor("#14181f")));
  QApplication::processEvents();
  const QColor dark = widget_->grab().toImage().pixelColor(2, 2);
  QApplication::setPalette(before);
  EXPECT_GT(light.lightnessF(), 0.7);
  EXPECT_LT(dark.lightnessF(), 0.3);
}

}  // namespace
}  // namespace frontier_pilot
