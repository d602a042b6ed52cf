#include "gui/fleet_window.h"

#include <QEvent>
#include <QVBoxLayout>

#include "gui/cards/fleet_card.h"
#include "gui/theme.h"

namespace frontier_pilot::gui {
namespace {

constexpr int kRefreshPeriod = 200;  // [ms]
// A link that is closed is kept for so long: a stop that was pressed is asked for again and again for ten seconds.
constexpr int kRetirement = 12000;  // [ms]

}  // namespace

FleetWindow::FleetWindow(teleop::FleetLink& link, const teleop::TeleopParameters& parameters)
    : fleet_link_(link), layout_(new QVBoxLayout(this)), card_(new FleetCard) {
  setObjectName("fleet_window");
  setAttribute(Qt::WA_StyledBackground);
  setWindowTitle("frontier_pilot");
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(0);
  auto* margins = new QVBoxLayout;
  const int gap = emOf(*this) / 2;
  margins->setContentsMargins(gap, gap, gap, 0);
  margins->addWidget(card_);
  layout_->addLayout(margins);
  connect(card_, &FleetCard::chosen, this, &FleetWindow::choose);
  connect(card_, &FleetCard::stopAllAsked, this, [this] {
    if (widget_ != nullptr) widget_->stopBecause("all robots are to stop");
    fleet_link_.stopAll();
  });
  connect(&refresh_timer_, &QTimer::timeout, this, &FleetWindow::refresh);
  applyTheme();
  open({}, parameters);
  refresh_timer_.start(kRefreshPeriod);
}

FleetWindow::~FleetWindow() { release(); }

void FleetWindow::release() {
  closed_ = true;
  refresh_timer_.stop();
  if (controller_) controller_->close();
}

void FleetWindow::choose(const std::string& robot) {
  if (closed_ || robot == shown_) return;
  open(robot, fleet_link_.parametersOf(robot));
}

void FleetWindow::open(const std::string& robot, const teleop::TeleopParameters& parameters) {
  controller_.reset();  // closes the link
  delete widget_;
  if (link_) QTimer::singleShot(kRetirement, this, [retired = link_]() mutable { retired.reset(); });
  link_ = fleet_link_.open(robot, parameters);
  shown_ = robot;
  widget_ = new PilotWidget(parameters);
  layout_->addWidget(widget_, 1);
  controller_ = std::make_unique<PilotController>(*widget_, *link_, fromSeconds(parameters.liveness_timeout));
  connect(controller_.get(), &PilotController::closeAsked, this, &FleetWindow::closeAsked);
  setWindowTitle(robot.empty() ? QString("frontier_pilot") : QString::fromStdString(robot) + " – frontier_pilot");
  widget_->setFocus();
}

/// A fleet is shown beginning with its first robot.
void FleetWindow::refresh() {
  const teleop::FleetView fleet = fleet_link_.fleet();
  if (shown_.empty() && !fleet.robots.empty() && fleet.connected) choose(fleet.robots.front().name);
  card_->setFleet(fleet, shown_);
}

void FleetWindow::applyTheme() {
  if (applying_theme_) return;
  applying_theme_ = true;  // setting the style sheet causes another change event
  setStyleSheet(Theme::current().styleSheet(emOf(*this)));
  applying_theme_ = false;
}

void FleetWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) applyTheme();
}

}  // namespace frontier_pilot::gui
