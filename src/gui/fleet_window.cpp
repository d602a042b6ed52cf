#include "gui/fleet_window.h"

#include <QEvent>
#include <QVBoxLayout>
#include <utility>

#include "gui/cards/fleet_card.h"
#include "gui/theme.h"

namespace frontier_pilot::gui {
namespace {

constexpr int kFleetRefreshPeriod = 200;  // [ms]

teleop::OperatorRequest stopRequest() {
  teleop::OperatorRequest stop;
  stop.kind = teleop::OperatorRequest::Kind::kEmergencyStop;
  return stop;
}

}  // namespace

FleetWindow::FleetWindow(teleop::FleetLink& link)
    : fleet_link_(link), layout_(new QVBoxLayout(this)), card_(new FleetCard) {
  setObjectName("fleet_window");
  setAttribute(Qt::WA_StyledBackground);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(0);
  auto* margins = new QVBoxLayout;
  const int gap = emOf(*this) / 2;
  margins->setContentsMargins(gap, gap, gap, 0);
  margins->addWidget(card_);
  layout_->addLayout(margins);
  connect(card_, &FleetCard::chosen, this, &FleetWindow::choose);
  connect(card_, &FleetCard::stopAllAsked, this, &FleetWindow::stopAll);
  connect(&refresh_timer_, &QTimer::timeout, this, &FleetWindow::refresh);
  applyTheme(*this);
  showRobot(fleet_link_.openOwn());
  refresh_timer_.start(kFleetRefreshPeriod);
}

FleetWindow::~FleetWindow() { release(); }

void FleetWindow::release() {
  released_ = true;
  refresh_timer_.stop();
  if (controller_) controller_->close();
}

void FleetWindow::choose(const std::string& robot) {
  if (released_) return;
  if (robot == chosen_) {
    if (mayOpenAgain()) fleet_link_.open(robot);
    return;
  }
  chosen_ = robot;
  widget_->stopBecause("another robot was chosen");
  fleet_link_.open(robot);
}

void FleetWindow::showRobot(teleop::OpenedRobot robot) {
  controller_.reset();  // closes the link
  widget_.reset();
  if (link_) fleet_link_.retire(std::move(link_));
  link_ = std::move(robot.link);
  shown_ = chosen_ = robot.name;
  is_described_ = robot.is_described;
  widget_ = std::make_unique<PilotWidget>(robot.parameters);
  layout_->addWidget(widget_.get(), 1);
  controller_ = std::make_unique<PilotController>(*widget_, *link_, fromSeconds(robot.parameters.liveness_timeout));
  connect(widget_.get(), &PilotWidget::requested, this, &FleetWindow::noteStop);
  connect(controller_.get(), &PilotController::closeAsked, this, &FleetWindow::closeAsked);
  setWindowTitle(shown_.empty() ? QString("frontier_pilot") : QString::fromStdString(shown_) + " – frontier_pilot");
  widget_->setFocus();
}

/// Whether nobody is in the window's own namespace: then a fleet is shown beginning with its first robot.
bool FleetWindow::ownRobotIsMissing() const {
  return chosen_.empty() && widget_->setPoint().isZero() && !link_->state().arbiter;
}

/// Whether the robot that is shown was opened before it ran, so that its map and its outline may be those of another
/// one, and nothing that was begun here would end with its link.
bool FleetWindow::mayOpenAgain() const {
  if (is_described_ || chosen_ != shown_ || !widget_->setPoint().isZero()) return false;
  const teleop::OperatorState state = link_->state();
  return !state.patrol.own && !state.spin.own && !state.navigate.own && !state.waypoints.own;
}

/// Meanwhile another robot may have been chosen.
void FleetWindow::receive(teleop::OpenedRobot robot) {
  const bool is_wanted = robot.name == chosen_;
  const bool is_shown = robot.name == shown_;
  if (is_wanted && robot.link && (!is_shown || mayOpenAgain())) {
    showRobot(std::move(robot));
    return;
  }
  if (is_shown && robot.link) reopened_.clear();  // something was begun here meanwhile: later
  if (is_wanted) chosen_ = shown_;                // it could not be opened, and may be chosen again
  if (!robot.link) return;
  robot.link->close();
  fleet_link_.retire(std::move(robot.link));
}

void FleetWindow::refresh() {
  const teleop::FleetView fleet = fleet_link_.fleet();
  if (auto opened = fleet_link_.takeOpened()) receive(std::move(*opened));
  if (!fleet.robots.empty() && fleet.connected && ownRobotIsMissing()) choose(fleet.robots.front().name);
  if (reopened_ != shown_ && mayOpenAgain() && link_->state().arbiter) {
    reopened_ = shown_;
    fleet_link_.open(shown_);
  }
  card_->setFleet(fleet, shown_);
}

/// Whoever presses it just after the click on a name means the robot that was chosen, which is not open yet. The one
/// that is still shown is stopped as well.
void FleetWindow::noteStop(const teleop::OperatorRequest& request) {
  if (request.kind == teleop::OperatorRequest::Kind::kEmergencyStop) stopChosen();
}

/// A robot that is not open yet: it may never be, if another one is chosen meanwhile.
void FleetWindow::stopChosen() {
  if (chosen_ != shown_) fleet_link_.stop(chosen_);
}

/// The robot that is shown is stopped by itself, too, and so is the chosen one: their arbiters may be there when the
/// node that stops all is not.
void FleetWindow::stopAll() {
  widget_->stopBecause("all robots are to stop");
  link_->request(stopRequest());
  stopChosen();
  fleet_link_.stopAll();
}

void FleetWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) applyTheme(*this);
}

}  // namespace frontier_pilot::gui
