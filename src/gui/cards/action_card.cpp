#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {

ActionCard::ActionCard(const QString& title, const QString& name, const QString& server, QWidget* parent)
    : Card(title, parent), server_(server), stop_(new QPushButton(name + " stop")), progress_(new ElidedLabel) {
  stop_->setObjectName(name + " stop");
  stop_->setProperty("role", "stop");
  progress_->setObjectName(name + "_progress");
  connect(stop_, &QPushButton::clicked, this, &ActionCard::stopAsked);
}

QPushButton* ActionCard::makeStart(const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(text);
  start_.push_back(button);
  return button;
}

void ActionCard::showAction(const teleop::ActionView& action, bool emergency_stop) {
  for (QPushButton* button : start_) {
    button->setEnabled(action.server_up && !emergency_stop);
    button->setToolTip(!action.server_up ? server_ + " is down, or does not respond"
                                         : (emergency_stop ? toString(teleop::DriveLock::kEmergencyStop) : ""));
  }
  setRemark(!action.server_up ? "server down" : (action.active ? "running" : "ready"),
            action.server_up ? teleop::Severity::kIdle : teleop::Severity::kWarning);
  const QString feedback = QString::fromStdString(action.feedback);
  const QString result = QString::fromStdString(action.result);
  // Always one line: a card that grew would move the buttons below it away from the pointer.
  progress_->setFullText(action.active ? (feedback.isEmpty() ? "started" : feedback)
                                       : (result.isEmpty() ? "not started yet" : result));
}

}  // namespace frontier_pilot::gui
