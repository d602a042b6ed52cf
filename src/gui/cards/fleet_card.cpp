#include "gui/cards/fleet_card.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <algorithm>

namespace frontier_pilot::gui {
namespace {

constexpr int kColumnWidth = 40;  // the least, in line heights
constexpr int kMostHeight = 9;    // of the list of robots, in line heights
constexpr int kAnswerWidth = 16;  // in line heights

}  // namespace

FleetCard::FleetCard(QWidget* parent)
    : Card("Robots", parent),
      scroll_(new QScrollArea),
      grid_(new QGridLayout),
      stop_all_(new QPushButton("Stop all robots")),
      answer_(makeLabel("", "", true)) {
  stop_all_->setObjectName("stop_all");
  stop_all_->setFocusPolicy(Qt::NoFocus);
  stop_all_->setProperty("role", "stop");
  stop_all_->setToolTip("Stops every robot; each must then be cleared separately");
  answer_->setObjectName("stop_all_answer");
  const int gap = emOf(*this) / 2;
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(2 * gap);
  grid_->setVerticalSpacing(gap / 2);
  auto* body = new QWidget;
  body->setObjectName("fleetBody");
  body->setLayout(grid_);
  scroll_->setObjectName("fleetScroll");
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);  // whoever clicks at a robot's text still stops the robot by a key
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(body);
  auto* beside = new QVBoxLayout;
  beside->addWidget(stop_all_);
  beside->addWidget(answer_);
  beside->addStretch();
  answer_->setFixedWidth(emOf(*this) * kAnswerWidth);
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * gap);
  line->addWidget(scroll_, 1);
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
  answer_->setText(QString::fromStdString(fleet.stop.text));
  answer_->setVisible(!fleet.stop.text.empty());
  const Theme theme = Theme::current();
  const bool is_quiet = fleet.stop.severity == teleop::Severity::kIdle;
  answer_->setStyleSheet("color: " + (is_quiet ? theme.muted : theme.color(fleet.stop.severity)).name());
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
  // Rows that have just been added are not shown yet, and count for nothing in the size that the list asks for.
  const int lines = (static_cast<int>(rows_.size()) + columns - 1) / columns;
  const int line = rows_.empty() ? 0 : rows_.front().choose->sizeHint().height() + grid_->verticalSpacing();
  scroll_->setFixedHeight(std::min(lines * line, emOf(*this) * kMostHeight));
}

void FleetCard::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const int columns = std::max(1, event->size().width() / (emOf(*this) * kColumnWidth));
  if (columns != columns_) layOut(columns);
}

}  // namespace frontier_pilot::gui
