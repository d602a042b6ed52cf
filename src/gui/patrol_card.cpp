#include <QGridLayout>
#include <QVBoxLayout>

#include "cards.h"

namespace frontier_pilot {

PatrolCard::PatrolCard(const TeleopParameters& parameters, QWidget* parent)
    : Card("Patrol", parent),
      side_(new QDoubleSpinBox),
      laps_(new QSpinBox),
      start_{makeStart("patrol(sqr)", 1), makeStart("patrol(tri)", 2), makeStart("patrol(cir)", 3)},
      stop_(new QPushButton("patrol stop")),
      progress_(makeLabel("", "", true)) {
  side_->setObjectName("patrol_side");
  side_->setRange(0.05, 100.0);
  side_->setSingleStep(0.1);
  side_->setSuffix(" m");
  side_->setToolTip("Side of the square or triangle, radius of the circle");
  side_->setValue(parameters.patrol_side);
  laps_->setObjectName("patrol_laps");
  laps_->setRange(1, 1000);
  laps_->setValue(parameters.patrol_laps);
  stop_->setObjectName("patrol stop");
  stop_->setProperty("role", "stop");
  progress_->setObjectName("patrol_progress");
  auto* grid = new QGridLayout;
  grid->setSpacing(emOf(*this) / 3);
  grid->addWidget(makeLabel("Side", "muted"), 0, 0);
  grid->addWidget(side_, 0, 1);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  auto* laps = makeLabel("Laps", "muted");
  laps->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(laps, 0, 2);
  grid->addWidget(laps_, 0, 3);
  content()->addLayout(grid);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(emOf(*this) / 3);
  for (int i = 0; i < 3; ++i) buttons->addWidget(start_[static_cast<std::size_t>(i)], 0, i);
  buttons->addWidget(stop_, 1, 0, 1, 3);
  content()->addLayout(buttons);
  content()->addWidget(progress_);
  connect(stop_, &QPushButton::clicked, this, &PatrolCard::stopAsked);
}

QPushButton* PatrolCard::makeStart(const QString& text, int shape) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(text);
  connect(button, &QPushButton::clicked, this,
          [this, shape] { emit startAsked(shape, side_->value(), laps_->value()); });
  return button;
}

void PatrolCard::setState(const OperatorState& state) {
  const PatrolView& patrol = state.patrol;
  const bool stopped = state.emergency_stop.value_or(false);
  for (QPushButton* button : start_) {
    button->setEnabled(patrol.server_up && !stopped);
    button->setToolTip(!patrol.server_up ? "patrol_server is down" : (stopped ? "the emergency stop is latched" : ""));
  }
  setRemark(!patrol.server_up ? "server down" : (patrol.active ? "running" : "ready"),
            patrol.server_up ? Severity::kIdle : Severity::kWarning);
  const QString feedback = QString::fromStdString(patrol.feedback);
  if (patrol.active) {
    progress_->setText(feedback.isEmpty() ? "started" : feedback);
  } else {
    progress_->setText(QString::fromStdString(patrol.result));
  }
  progress_->setVisible(!progress_->text().isEmpty());
}

}  // namespace frontier_pilot
