#include "gui_fixture.h"

namespace frontier_pilot {
namespace {

using Kind = teleop::OperatorRequest::Kind;

class ExplorerCard : public test::PilotWidgetTest {};

TEST_F(ExplorerCard, EnterAfterStartPausesAndDoesNotReset) {
  state_.explorer->running = false;
  widget_->setState(state_);
  find("explore_start")->setFocus();
  state_.explorer->running = true;
  widget_->setState(state_);
  EXPECT_TRUE(find("explore_pause")->hasFocus());
}

// [GUI-2] Whoever presses Enter twice asks once.
TEST_F(ExplorerCard, EnterAfterAButtonThatIsDisabledPressesNoOtherOne_GUI_2) {
  find("clear_bounds")->setFocus();
  QTest::keyClick(find("clear_bounds"), Qt::Key_Return);
  ASSERT_EQ(requests_.size(), 1U);
  state_.explorer->bounded = false;
  widget_->setState(state_);
  EXPECT_TRUE(widget_->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(requests_.size(), 1U);
}

// [GUI-2] [EXP-10]
TEST_F(ExplorerCard, BoundsAreShownAndCleared) {
  EXPECT_EQ(find("explorer_bounds")->toolTip().isEmpty() ? text("explorer_bounds") : find("explorer_bounds")->toolTip(),
            "within 640 m², 1 area left out");
  click("clear_bounds");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, Kind::kClearBounds);
  state_.explorer->bounded = false;
  widget_->setState(state_);
  EXPECT_FALSE(find("clear_bounds")->isEnabled()) << "there is nothing to clear";
}

// [GUI-2] [EXP-10]
TEST_F(ExplorerCard, PosesToInspectAreCountedAndTakenBack) {
  EXPECT_EQ(text("explorer_inspect"), "2 to go, 1 done");
  click("clear_inspections");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, Kind::kClearInspections);
  state_.explorer->inspections_wait = false;
  widget_->setState(state_);
  EXPECT_FALSE(find("clear_inspections")->isEnabled()) << "nothing waits";
}

// [GUI-2] [EXP-10]
TEST_F(ExplorerCard, TheReturnToTheStartIsASwitchThatShowsTheStatusAlone) {
  auto* toggle = find<QAbstractButton>("return_to_start");
  EXPECT_FALSE(toggle->isChecked());
  toggle->click();
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].kind, Kind::kReturnToStart);
  EXPECT_TRUE(requests_[0].on);
  EXPECT_FALSE(toggle->isChecked());
  state_.explorer->return_to_start = true;
  widget_->setState(state_);
  EXPECT_TRUE(toggle->isChecked());
}

// [GUI-2] [EXP-10]
TEST_F(ExplorerCard, WhenItEndsAndWhatBecomesOfTheMapIsShown) {
  state_.explorer->end_text = "when 9 m2 are known";
  state_.explorer->map_text = "saved: hall";
  widget_->setState(state_);
  EXPECT_EQ(text("explorer_end"), "when 9 m2 are known");
  EXPECT_EQ(text("explorer_map"), "saved: hall");
  state_.explorer->status_age = 60.0;
  widget_->setState(state_);
  EXPECT_EQ(text("explorer_map"), "–") << "a silent explorer may have changed its mind";
}

}  // namespace
}  // namespace frontier_pilot
