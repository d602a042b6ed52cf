#include <QGridLayout>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {

PatrolCard::PatrolCard(const teleop::TeleopParameters& parameters, QWidget* parent)
    : ActionCard("Patrol", "patrol", "patrol_server", parent), side_(new QDoubleSpinBox), laps_(new QSpinBox) {
  side_->setObjectName("patrol_side");
  side_->setRange(0.05, 100.0);
  side_->setSingleStep(0.1);
  side_->setSuffix(" m");
  side_->setToolTip("Side of the square or triangle, radius of the circle");
  side_->setValue(parameters.patrol_side);
  laps_->setObjectName("patrol_laps");
  laps_->setRange(1, 1000);
  laps_->setValue(parameters.patrol_laps);
  auto* grid = new QGridLayout;
  grid->setSpacing(emOf(*this) / 3);
  grid->addWidget(makeLabel("Size", "muted"), 0, 0);
  grid->addWidget(side_, 0, 1);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  auto* laps = makeLabel("Laps", "muted");
  laps->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(laps, 0, 2);
  grid->addWidget(laps_, 0, 3);
  content()->addLayout(grid);
  content()->addLayout(makeButtons());
  content()->addWidget(progressLabel());
}

QLayout* PatrolCard::makeButtons() {
  constexpr std::array<const char*, 3> kShapes{"patrol(sqr)", "patrol(tri)", "patrol(cir)"};
  auto* buttons = new QGridLayout;
  buttons->setSpacing(emOf(*this) / 3);
  for (int i = 0; i < 3; ++i) {
    QPushButton* button = makeStart(kShapes[static_cast<std::size_t>(i)]);
    buttons->addWidget(button, 0, i);
    connect(button, &QPushButton::clicked, this, [this, i] { emit startAsked(i + 1, side_->value(), laps_->value()); });
  }
  buttons->addWidget(stopButton(), 1, 0, 1, 3);
  return buttons;
}

void PatrolCard::setState(const teleop::OperatorState& state) {
  showAction(state.patrol, state.emergency_stop.value_or(false));
}

}  // namespace frontier_pilot::gui
