#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QtTest>
#include <cstdlib>
#include <memory>
#include <vector>

#include "example_state.h"
#include "gui/pilot_widget.h"

namespace frontier_pilot::test {

/// One QApplication without a screen for all tests of the program.
class Application : public ::testing::Environment {
 public:
  void SetUp() override {
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    application_ = std::make_unique<QApplication>(argc_, argv_);
    QApplication::setStyle("Fusion");
  }
  void TearDown() override { application_.reset(); }

 private:
  char name_[10] = "gui_tests";
  char* argv_[2] = {name_, nullptr};
  int argc_ = 1;
  std::unique_ptr<QApplication> application_;
};

/// The widget on screen, with what it asked for.
class PilotWidgetTest : public ::testing::Test {
 protected:
  void SetUp() override { open(teleop::TeleopParameters{}); }
  void TearDown() override { widget_.reset(); }

  void open(const teleop::TeleopParameters& parameters) {
    requests_.clear();
    widget_ = std::make_unique<gui::PilotWidget>(parameters);
    QObject::connect(widget_.get(), &gui::PilotWidget::requested,
                     [this](const teleop::OperatorRequest& request) { requests_.push_back(request); });
    widget_->resize(1200, 800);
    widget_->show();
    QApplication::setActiveWindow(widget_.get());
    widget_->setFocus();
    state_ = exampleState();
    state_.arbiter->active_source = "manual";
    widget_->setState(state_);
  }
  void openHoldToRun() {
    teleop::TeleopParameters parameters;
    parameters.hold_to_run = true;
    open(parameters);
  }

  template <class Widget = QWidget>
  Widget* find(const char* name) {
    auto* found = widget_->findChild<Widget*>(name);
    if (found == nullptr) ADD_FAILURE() << "no widget " << name;
    return found;
  }
  void click(const char* name) { QTest::mouseClick(find(name), Qt::LeftButton); }
  QString text(const char* name) { return find<QLabel>(name)->text(); }

  std::unique_ptr<gui::PilotWidget> widget_;
  teleop::OperatorState state_;
  std::vector<teleop::OperatorRequest> requests_;
};

}  // namespace frontier_pilot::test
