#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {

namespace {

/// Enables and disables two buttons. If the one with the focus is disabled, the focus goes to the other one: Qt would
/// move it to the next widget, which Enter would then press.
void enableInTurn(QPushButton& first, bool first_on, QPushButton& second, bool second_on) {
  if (first_on) first.setEnabled(true);
  if (second_on) second.setEnabled(true);
  if (!first_on && first.hasFocus()) second.setFocus();
  if (!second_on && second.hasFocus()) first.setFocus();
  first.setEnabled(first_on);
  second.setEnabled(second_on);
}

}  // namespace

ExplorerCard::ExplorerCard(QWidget* parent)
    : Card("Explore", parent),
      dot_(new Dot),
      state_(new ElidedLabel("strong")),
      reason_(makeLabel("", "muted", true)),
      area_(makeLabel("", "figure")),
      distance_(makeLabel("", "figure")),
      frontiers_(makeLabel("", "figure")),
      share_(makeLabel("", "figure")),
      goals_(new ElidedLabel("muted")),
      start_(new QPushButton("Start")),
      pause_(new QPushButton("Pause")),
      reset_(new QPushButton("Reset")),
      bounds_(new ElidedLabel),
      inspect_(new ElidedLabel),
      end_(new ElidedLabel),
      map_(new ElidedLabel),
      clear_bounds_(new QPushButton("Clear bounds")),
      clear_inspections_(new QPushButton("Clear poses")),
      return_(new Switch("return_to_start")) {
  start_->setObjectName("explore_start");
  start_->setProperty("role", "primary");
  pause_->setObjectName("explore_pause");
  reset_->setObjectName("explore_reset");
  area_->setObjectName("explored_area");
  state_->setObjectName("explorer_state");
  goals_->setObjectName("explorer_goals");
  // Room for the longest reason, so that the buttons below keep their place.
  reason_->setMinimumHeight(emOf(*this) * 13 / 4);
  reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* line = new QHBoxLayout;
  line->addWidget(dot_);
  line->addWidget(state_, 1);
  content()->addLayout(line);
  content()->addWidget(reason_);
  content()->addLayout(makeButtons());  // above what a window of little height cuts off
  content()->addLayout(makeFigures());
  content()->addWidget(goals_);
  content()->addLayout(makeLimits());
}

QLayout* ExplorerCard::makeButtons() {
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(emOf(*this) / 3);
  for (QPushButton* button : {start_, pause_, reset_}) buttons->addWidget(button, 1);
  connect(start_, &QPushButton::clicked, this, [this] { emit runAsked(true); });
  connect(pause_, &QPushButton::clicked, this, [this] { emit runAsked(false); });
  connect(reset_, &QPushButton::clicked, this, &ExplorerCard::resetAsked);
  return buttons;
}

/// What bounds and ends the exploration, a line for each.
QLayout* ExplorerCard::makeLimits() {
  bounds_->setObjectName("explorer_bounds");
  inspect_->setObjectName("explorer_inspect");
  end_->setObjectName("explorer_end");
  map_->setObjectName("explorer_map");
  clear_bounds_->setObjectName("clear_bounds");
  clear_inspections_->setObjectName("clear_inspections");
  for (QPushButton* button : {clear_bounds_, clear_inspections_}) button->setProperty("role", "small");
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(emOf(*this) / 2);
  grid->setVerticalSpacing(emOf(*this) / 6);
  const std::array<std::pair<const char*, ElidedLabel*>, 4> lines{
      {{"Bounds", bounds_}, {"Inspect", inspect_}, {"Ends", end_}, {"Map", map_}}};
  for (int row = 0; row < 4; ++row) {
    const auto& [name, label] = lines[static_cast<std::size_t>(row)];
    grid->addWidget(makeLabel(name, "muted"), row, 0);
    grid->addWidget(label, row, 1, 1, row < 2 ? 1 : 2);
  }
  grid->addWidget(clear_bounds_, 0, 2);
  grid->addWidget(clear_inspections_, 1, 2);
  auto* back = new QHBoxLayout;
  back->setSpacing(emOf(*this) / 2);
  back->addWidget(return_);
  back->addWidget(makeLabel("Return to start"), 1);
  grid->addLayout(back, 4, 0, 1, 3);
  grid->setColumnStretch(1, 1);
  connect(clear_bounds_, &QPushButton::clicked, this, &ExplorerCard::clearBoundsAsked);
  connect(clear_inspections_, &QPushButton::clicked, this, &ExplorerCard::clearInspectionsAsked);
  connect(return_, &Switch::asked, this, &ExplorerCard::returnAsked);
  return grid;
}

QLayout* ExplorerCard::makeFigures() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(emOf(*this));
  grid->setVerticalSpacing(0);
  const std::array<std::pair<const char*, QLabel*>, 4> figures{
      {{"explored", area_}, {"driven", distance_}, {"frontiers left", frontiers_}, {"of the whole", share_}}};
  for (int i = 0; i < 4; ++i) {
    const auto& [name, label] = figures[static_cast<std::size_t>(i)];
    grid->addWidget(label, i / 2 * 2, i % 2);
    grid->addWidget(makeLabel(name, "muted"), i / 2 * 2 + 1, i % 2);
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return grid;
}

void ExplorerCard::setState(const teleop::OperatorState& state) {
  const bool heard = state.explorer.has_value() && state.explorer->status_age <= teleop::kStatusLifetime;
  const bool up = state.explorer_service_up;
  setRemark(!up ? "explorer down" : (heard ? "" : "silent"), teleop::Severity::kWarning);
  const bool running = heard && state.explorer->running;
  const bool stopped = state.emergency_stop.value_or(false);
  enableInTurn(*start_, up && !running && !stopped, *pause_, up && (!heard || running));
  for (QPushButton* button : {start_, pause_}) button->setToolTip(up ? "" : "set_exploration_enabled is down");
  if (up && stopped) start_->setToolTip(toString(teleop::DriveLock::kEmergencyStop));
  reset_->setEnabled(state.explorer_reset_up);
  reset_->setToolTip(state.explorer_reset_up ? "Forgets the blacklist, the visits and the phase"
                                             : "frontier_explorer/reset is down");
  showLimits(state, heard);
  dot_->setSeverity(heard ? state.explorer->severity : teleop::Severity::kIdle);
  if (!state.explorer) {
    state_->setFullText("not heard of");
    for (QLabel* label : {area_, distance_, frontiers_, share_}) label->setText(kNoValue);
    goals_->setFullText("");
    return;
  }
  const teleop::ExplorerView& explorer = *state.explorer;
  const QString phase = QString::fromStdString(explorer.phase_text);
  const QString now = QString::fromStdString(explorer.state_text) + (phase.isEmpty() ? "" : "  ·  " + phase);
  state_->setFullText(heard ? now : "silent for " + ageText(explorer.status_age));
  reason_->setText(heard ? QString::fromStdString(explorer.reason_text) : QString());
  showFigures(explorer);
}

void ExplorerCard::showFigures(const teleop::ExplorerView& explorer) {
  area_->setText(QString("%1 m²").arg(explorer.explored_area, 0, 'f', 1));
  distance_->setText(QString("%1 m").arg(explorer.distance_travelled, 0, 'f', 1));
  frontiers_->setText(explorer.not_started
                          ? kNoValue
                          : QString("%1 of %2").arg(explorer.frontiers_selectable).arg(explorer.frontiers_found));
  share_->setText(explorer.share_explored ? QString("≈ %1 %").arg(100.0 * *explorer.share_explored, 0, 'f', 0)
                                          : kNoValue);
  goals_->setFullText(QString("Goals: %1 dropped, %2 reached, %3 failed")
                          .arg(explorer.goals_dropped)
                          .arg(explorer.goals_reached)
                          .arg(explorer.goals_failed));
}

void ExplorerCard::showLimits(const teleop::OperatorState& state, bool heard) {
  const bool bounded = heard && state.explorer->bounded;
  clear_bounds_->setEnabled(state.explorer_bounds_up && bounded);
  clear_bounds_->setToolTip(!state.explorer_bounds_up ? "frontier_explorer/clear_bounds is down"
                            : bounded ? "Explore everywhere; also takes back what is being drawn in rviz"
                                      : "Draw bounds in rviz with Publish Point");
  const bool inspects = heard && state.explorer->inspections_wait;
  clear_inspections_->setEnabled(state.explorer_inspections_up && inspects);
  clear_inspections_->setToolTip(!state.explorer_inspections_up ? "frontier_explorer/clear_inspections is down"
                                 : inspects                     ? "Take back the poses that wait to be inspected"
                                                                : "Ask for poses in rviz with the tool Inspect");
  return_->setShown(heard ? std::optional<bool>(state.explorer->return_to_start) : std::nullopt,
                    state.explorer_return_up, "frontier_explorer/set_return_to_start is down");
  const auto text = [heard](const std::string& known) { return heard ? QString::fromStdString(known) : kNoValue; };
  const teleop::ExplorerView explorer = state.explorer.value_or(teleop::ExplorerView{});
  bounds_->setFullText(text(explorer.bounds_text));
  inspect_->setFullText(text(explorer.inspect_text));
  end_->setFullText(text(explorer.end_text));
  map_->setFullText(text(explorer.map_text));
}

}  // namespace frontier_pilot::gui
