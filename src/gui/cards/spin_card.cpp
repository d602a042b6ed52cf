#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {

SpinCard::SpinCard(QWidget* parent)
    : ActionCard("Turn in place", "spin", "behavior_server", parent), angle_(new QSpinBox) {
  angle_->setObjectName("spin_angle");
  angle_->setRange(-720, 720);
  angle_->setSingleStep(15);
  angle_->setSuffix("°");
  angle_->setToolTip("Angle to turn by; positive is to the left");
  angle_->setValue(90);
  QPushButton* start = makeStart("spin");
  auto* line = new QHBoxLayout;
  line->setSpacing(emOf(*this) / 3);
  for (QWidget* part : std::array<QWidget*, 3>{angle_, start, stopButton()}) line->addWidget(part, 1);
  content()->addLayout(line);
  content()->addWidget(progressLabel());
  connect(start, &QPushButton::clicked, this, [this] { emit startAsked(angle_->value() * kPi / 180.0); });
}

void SpinCard::setState(const teleop::OperatorState& state) {
  showAction(state.spin, state.emergency_stop.value_or(false));
}

}  // namespace frontier_pilot::gui
