#include <QGridLayout>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {

DriveCard::DriveCard(const teleop::TeleopParameters& parameters, QWidget* parent)
    : Card("Drive", parent),
      linear_(new BarGauge("Forward", "m/s", parameters.robot.limits.max_linear, false)),
      angular_(new BarGauge("Turn left", "rad/s", parameters.robot.limits.max_angular, true)),
      hold_(new QCheckBox("Hold to run")),
      hint_(new ElidedLabel("muted")) {
  content()->addLayout(makePad());
  content()->addWidget(linear_);
  content()->addWidget(angular_);
  content()->addWidget(hold_);
  content()->addWidget(hint_);
  hint_->setObjectName("drive_hint");
  hold_->setObjectName("hold_to_run");
  hold_->setChecked(parameters.hold_to_run);
  hold_->setToolTip("The robot moves only while a button or key is pressed");
  const QString marks = "Filled: your set-point. Dark mark: what the arbiter sends to the wheels.";
  linear_->setToolTip(marks);
  angular_->setToolTip(marks);
  connect(hold_, &QCheckBox::toggled, this, &DriveCard::holdToRunChanged);
}

QLayout* DriveCard::makePad() {
  struct Place {
    teleop::Motion motion;
    int row, column;
  };
  auto* grid = new QGridLayout;
  grid->setSpacing(emOf(*this) / 3);
  for (const Place& place :
       {Place{teleop::Motion::kGo, 0, 1}, Place{teleop::Motion::kLeft, 1, 0}, Place{teleop::Motion::kStop, 1, 1},
        Place{teleop::Motion::kRight, 1, 2}, Place{teleop::Motion::kBack, 2, 1}}) {
    auto* button = new PadButton(place.motion, this);
    grid->addWidget(button, place.row, place.column);
    connect(button, &QPushButton::pressed, this, [this, place] { emit pressed(place.motion); });
    connect(button, &QPushButton::released, this, [this, place] { emit released(place.motion); });
    connect(button, &PadButton::leftWhilePressed, this, &DriveCard::letGo);
    buttons_.push_back(button);
  }
  return grid;
}

void DriveCard::setState(const teleop::OperatorState& state) {
  const bool live = state.arbiter && state.arbiter->status_age <= teleop::kStatusLifetime;
  driver_ = live ? QString::fromStdString(state.arbiter->active_source) : QString();
  linear_->setActual(live ? std::optional<double>(state.arbiter->command.linear) : std::nullopt);
  angular_->setActual(live ? std::optional<double>(state.arbiter->command.angular) : std::nullopt);
}

void DriveCard::showDrive(const teleop::DriveModel& drive) {
  linear_->setSetPoint(drive.setPoint().linear);
  angular_->setSetPoint(drive.setPoint().angular);
  for (PadButton* button : buttons_) {
    button->setEnabled(drive.lock() == teleop::DriveLock::kNone ||
                       button->objectName() == toString(teleop::Motion::kStop));
    button->setToolTip(toString(drive.lock()));
  }
  hint_->setFullText(hint(drive));
}

QString DriveCard::hint(const teleop::DriveModel& drive) const {
  if (drive.lock() != teleop::DriveLock::kNone) return QString("Locked: ") + toString(drive.lock()) + ".";
  if (driver_ == "avoid") return "avoid drives; your set-point waits.";
  if (drive.machineDrives()) return driver_ + " drives: the arrows have no effect.";
  return drive.holdToRun() ? "Hold arrows or WASD. Release stops." : "Arrows or WASD step, space stops.";
}

}  // namespace frontier_pilot::gui
