#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {
namespace {

QString inMetres(const std::optional<double>& value) {
  return value ? QString::number(*value, 'f', 1) + " m" : kNoValue;
}

QString inSeconds(const std::optional<double>& value) {
  if (!value) return kNoValue;
  const int seconds = static_cast<int>(std::lround(std::min(*value, 1e6)));
  return seconds < 60 ? QString("%1 s").arg(seconds)
                      : QString("%1 min %2 s").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
}

}  // namespace

NavigationCard::NavigationCard(QWidget* parent)
    : Card("Navigate", parent),
      goal_(makeLabel("", "figure")),
      distance_(makeLabel("", "figure")),
      time_(makeLabel("", "figure")),
      dot_(new Dot),
      status_(new ElidedLabel),
      cancel_(new QPushButton("Cancel the goal")) {
  goal_->setObjectName("navigation_goal");
  distance_->setObjectName("navigation_distance");
  time_->setObjectName("navigation_time");
  status_->setObjectName("navigation_status");
  cancel_->setObjectName("navigation_cancel");
  cancel_->setProperty("role", "stop");
  auto* figures = new QGridLayout;
  figures->setHorizontalSpacing(emOf(*this));
  figures->setVerticalSpacing(0);
  const std::array<std::pair<const char*, QLabel*>, 3> columns{
      {{"goal", goal_}, {"left", distance_}, {"about", time_}}};
  for (int i = 0; i < 3; ++i) {
    const auto& [name, label] = columns[static_cast<std::size_t>(i)];
    figures->addWidget(label, 0, i);
    figures->addWidget(makeLabel(name, "muted"), 1, i);
    figures->setColumnStretch(i, 1);
  }
  auto* line = new QHBoxLayout;
  line->addWidget(dot_);
  line->addWidget(status_, 1);
  content()->addLayout(figures);
  content()->addLayout(line);
  content()->addWidget(cancel_);
  connect(cancel_, &QPushButton::clicked, this, &NavigationCard::cancelAsked);
}

void NavigationCard::setState(const teleop::OperatorState& state) {
  const bool heard = state.navigation.has_value();
  const bool responds = heard && state.navigate.server_up;
  const teleop::NavigationView view = responds ? *state.navigation : teleop::NavigationView();
  setRemark(!heard      ? "server down"
            : !responds ? "silent"
                        : (view.has_goal ? "driving to a goal" : "ready"),
            responds ? teleop::Severity::kIdle : teleop::Severity::kWarning);
  goal_->setText(view.has_goal ? QString("%1, %2").arg(view.goal.x(), 0, 'f', 1).arg(view.goal.y(), 0, 'f', 1)
                               : kNoValue);
  distance_->setText(inMetres(view.distance_left));
  time_->setText(inSeconds(view.time_left));
  dot_->setSeverity(view.severity);
  const QString nothing = heard && !responds ? "it does not respond" : "no goal yet";
  status_->setFullText(view.status.empty() ? nothing : QString::fromStdString(view.status));
  cancel_->setEnabled(heard && state.navigation->has_goal);  // a server that hangs may go on with it
}

}  // namespace frontier_pilot::gui
