#include "gui/cards/fleet_card.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QResizeEvent>
#include <algorithm>

namespace frontier_pilot::gui {
namespace {

constexpr int kColumnWidth = 40;  // the least, in line heights

}  // namespace

FleetCard::FleetCard(QWidget* parent)
    : Card("Robots", parent),
      grid_(new QGridLayout),
      stop_all_(new QPushButton("Stop all robots")),
      answer_(new ElidedLabel("muted")) {
  stop_all_->setObjectName("stop_all");
  stop_all_->setFocusPolicy(Qt::NoFocus);
  stop_all_->setProperty("role", "stop");
  answer_->setObjectName("stop_all_answer");
  const int gap = emOf(*this) / 2;
  grid_->setHorizontalSpacing(2 * gap);
  grid_->setVerticalSpacing(gap / 2);
  auto* beside = new QVBoxLayout;
  beside->addWidget(stop_all_);
  beside->addWidget(answer_);
  beside->addStretch();
  answer_->setFixedWidth(emOf(*this) * 14);
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * gap);
  line->addLayout(grid_, 1);
  line->addLayout(beside);
  content()->addLayout(line);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
  connect(stop_all_, &QPushButton::pressed, this, &FleetCard::stopAllAsked);
  setFleet({}, {});
}

void FleetCard::setFleet(const teleop::FleetView& fleet, const std::string& shown) {
  setVisible(!fleet.robots.empty());
  const auto same = [](const Row& row, const teleop::RobotView& robot) { return row.name == robot.name; };
  if (!std::equal(rows_.begin(), rows_.end(), fleet.robots.begin(), fleet.robots.end(), same)) rebuild(fleet.robots);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].dot->setSeverity(fleet.robots[i].severity);
    rows_[i].text->setFullText(QString::fromStdString(fleet.robots[i].text));
    rows_[i].choose->setChecked(rows_[i].name == shown);
    rows_[i].choose->setEnabled(fleet.connected);
  }
  stop_all_->setToolTip(fleet.stop_up ? "Stops every robot; each is cleared by itself"
                                      : "fleet/emergency_stop is down");
  answer_->setFullText(QString::fromStdString(fleet.stop_answer.text));
}

void FleetCard::rebuild(const std::vector<teleop::RobotView>& robots) {
  for (const Row& row : rows_) {
    row.widget->hide();
    row.widget->deleteLater();
  }
  rows_.clear();
  for (const teleop::RobotView& robot : robots) {
    const QString name = QString::fromStdString(robot.name);
    Row row{robot.name, new QWidget, new Dot, new QPushButton(name), new ElidedLabel};
    row.choose->setObjectName("robot_" + name);
    row.choose->setCheckable(true);
    row.choose->setFocusPolicy(Qt::NoFocus);
    row.choose->setToolTip(toolTipOf("Shows " + name + " in this window"));
    row.text->setObjectName("robot_state_" + name);
    auto* line = new QHBoxLayout(row.widget);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(row.dot);
    line->addWidget(row.choose);
    line->addWidget(row.text, 1);
    // A click changes nothing by itself: the button that is down is that of the robot which is shown.
    connect(row.choose, &QPushButton::clicked, this, [this, name = robot.name, button = row.choose] {
      button->setChecked(!button->isChecked());
      emit chosen(name);
    });
    rows_.push_back(row);
  }
  layOut(std::max(1, columns_));
}

void FleetCard::layOut(int columns) {
  columns_ = columns;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int index = static_cast<int>(i);
    grid_->addWidget(rows_[i].widget, index / columns, index % columns);
  }
  for (int column = 0; column < grid_->columnCount(); ++column)
    grid_->setColumnStretch(column, column < columns ? 1 : 0);
}

void FleetCard::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const int columns = std::max(1, event->size().width() / (emOf(*this) * kColumnWidth));
  if (columns != columns_) layOut(columns);
}

}  // namespace frontier_pilot::gui
