#include "gui/pilot_widget.h"

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "gui/cards/cards.h"
#include "gui/cards/header_card.h"
#include "gui/cards/map_card.h"
#include "gui/cards/scan_card.h"
#include "gui/window_watch.h"
#include "teleop/operator_events.h"

namespace frontier_pilot::gui {
namespace {

// What drives needs a moment to end, and the arbiter half a second without motion before it clears a stop.
constexpr int kRefreshesToHalt = 10;  // about a second
constexpr int kMostClears = 3;

/// How many stops the arbiter has been asked for; 0 if that is not known.
std::uint64_t stopsIn(const teleop::OperatorState& state) { return state.arbiter ? state.arbiter->stops : 0; }

/// Whether `manual` has priority over the source that drives.
bool yieldsToManual(const teleop::OperatorState& state) {
  const teleop::SourceView* manual = state.source("manual");
  const teleop::SourceView* driver = state.source(state.arbiter->active_source);
  return manual != nullptr && driver != nullptr && manual->priority > driver->priority;
}

}  // namespace

PilotWidget::PilotWidget(const teleop::TeleopParameters& parameters, QWidget* parent)
    : QWidget(parent), parameters_(parameters), drive_(parameters) {
  setObjectName("pilot");
  setWindowTitle("frontier_pilot");
  setAttribute(Qt::WA_StyledBackground);
  setFocusPolicy(Qt::StrongFocus);
  build();
  connectCards();
  connectKeys();
  setState({});
  layOut(1);
  applyTheme(*this);
  connect(qApp, &QApplication::applicationStateChanged, this, &PilotWidget::letGo);
  connect(new WindowWatch(*this, fromSeconds(parameters.liveness_timeout)), &WindowWatch::cannotBeSeen, this,
          &PilotWidget::loseSight);
}

// What the application says while the children are destroyed, of the focus for instance, comes too late.
PilotWidget::~PilotWidget() {
  qApp->removeEventFilter(this);
  disconnect(qApp, nullptr, this, nullptr);
}

void PilotWidget::build() {
  header_ = new HeaderCard;
  drive_card_ = new DriveCard(parameters_);
  scan_card_ = new ScanCard(parameters_.robot.exactOutline());
  map_card_ = new MapCard(parameters_.robot.exactOutline());
  sources_card_ = new SourcesCard;
  patrol_card_ = new PatrolCard(parameters_);
  spin_card_ = new SpinCard;
  navigation_card_ = new NavigationCard;
  explorer_card_ = new ExplorerCard;
  log_card_ = new LogCard;

  const int gap = emOf(*this) / 2;
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(gap, gap, gap, gap);
  outer->setSpacing(gap);
  outer->addWidget(header_, 0, Qt::AlignTop);  // so that the stop stays where it is, however much is said below it
  auto* scroll = new QScrollArea;
  scroll->setObjectName("pilotScroll");
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* body = new QWidget;
  body->setObjectName("pilotBody");
  body_ = new QBoxLayout(QBoxLayout::LeftToRight, body);
  body_->setContentsMargins(0, 0, 0, 0);
  body_->setSpacing(gap);
  for (int column = 0; column < kMostColumns; ++column) {
    column_layouts_.push_back(new QVBoxLayout);
    column_layouts_.back()->setSpacing(gap);
    body_->addLayout(column_layouts_.back());
  }
  scroll->setWidget(body);
  outer->addWidget(scroll, 1);
}

void PilotWidget::connectCards() {
  using Kind = teleop::OperatorRequest::Kind;
  const auto ask = [this](Kind kind, bool on = false) { send({kind, on, {}, 0, 0.0, 0, 0.0}); };
  connect(drive_card_, &DriveCard::pressed, this, &PilotWidget::press);
  connect(drive_card_, &DriveCard::released, this, &PilotWidget::release);
  connect(drive_card_, &DriveCard::letGo, this, &PilotWidget::letGo);
  connect(drive_card_, &DriveCard::holdToRunChanged, this, [this](bool hold) {
    drive_.setHoldToRun(hold);
    showSetPoint();
  });
  connect(header_, &HeaderCard::stopAsked, this, [this, ask] {
    clears_left_ = 0;
    press(teleop::Motion::kStop);
    ask(Kind::kEmergencyStop);
  });
  connect(header_, &HeaderCard::clearAsked, this, [this, ask] {
    clears_left_ = 0;
    ask(Kind::kClearEmergencyStop);
  });
  connect(header_, &HeaderCard::haltAndClearAsked, this, &PilotWidget::haltAndClear);
  connect(sources_card_, &SourcesCard::enableAsked, this, [this](const QString& name, bool on) {
    send({Kind::kEnableSource, on, name.toStdString(), 0, 0.0, 0, 0.0});
  });
  connect(scan_card_, &ScanCard::avoiderAsked, this, [ask](bool on) { ask(Kind::kEnableAvoider, on); });
  connectMap();
  connect(patrol_card_, &PatrolCard::startAsked, this, [this](int shape, double side, int laps) {
    press(teleop::Motion::kStop);
    send({Kind::kPatrol, true, {}, shape, side, laps, 0.0});
  });
  connect(patrol_card_, &PatrolCard::stopAsked, this, [this, ask] {
    press(teleop::Motion::kStop);
    ask(Kind::kStopPatrol);
  });
  connect(spin_card_, &SpinCard::startAsked, this, [this](double angle) {
    press(teleop::Motion::kStop);
    send({Kind::kSpin, true, {}, 0, 0.0, 0, angle});
  });
  connect(spin_card_, &SpinCard::stopAsked, this, [this, ask] {
    press(teleop::Motion::kStop);
    ask(Kind::kStopSpin);
  });
  connect(navigation_card_, &NavigationCard::cancelAsked, this, [this, ask] {
    press(teleop::Motion::kStop);
    ask(Kind::kStopNavigation);
  });
  connect(explorer_card_, &ExplorerCard::runAsked, this, [ask](bool on) { ask(Kind::kExplore, on); });
  connect(explorer_card_, &ExplorerCard::resetAsked, this, [ask] { ask(Kind::kResetExplorer); });
  connect(explorer_card_, &ExplorerCard::clearBoundsAsked, this, [ask] { ask(Kind::kClearBounds); });
  connect(explorer_card_, &ExplorerCard::clearInspectionsAsked, this, [ask] { ask(Kind::kClearInspections); });
  connect(explorer_card_, &ExplorerCard::returnAsked, this, [ask](bool on) { ask(Kind::kReturnToStart, on); });
}

void PilotWidget::connectMap() {
  using Kind = teleop::OperatorRequest::Kind;
  connect(map_card_, &MapCard::goAsked, this, [this](const Pose2& goal) {
    press(teleop::Motion::kStop);
    send({Kind::kGoTo, true, {}, 0, 0.0, 0, 0.0, {goal}});
  });
  connect(map_card_, &MapCard::waypointsAsked, this, [this](const std::vector<Pose2>& poses) {
    press(teleop::Motion::kStop);
    send({Kind::kFollowWaypoints, true, {}, 0, 0.0, 0, 0.0, poses});
  });
  // An explorer that is not paused would drive off again.
  connect(map_card_, &MapCard::returnAsked, this, [this] {
    press(teleop::Motion::kStop);
    if (last_state_.explorer_service_up) send({Kind::kExplore, false, {}, 0, 0.0, 0, 0.0});
    send({Kind::kGoTo, true, {}, 0, 0.0, 0, 0.0, {Pose2()}});
  });
  connect(map_card_, &MapCard::saveAsked, this, [this](const QString& path) {
    send({Kind::kSaveMap, true, path.toStdString(), 0, 0.0, 0, 0.0});
  });
  connect(map_card_, &MapCard::loadAsked, this, [this](const QString& path) {
    send({Kind::kLoadMap, true, path.toStdString(), 0, 0.0, 0, 0.0});
  });
}

void PilotWidget::setState(const teleop::OperatorState& state) {
  const bool had_arbiter = last_state_.arbiter_changes > 0;
  if (had_arbiter && state.arbiter_changes != last_state_.arbiter_changes)
    stopBecause("the arbiter has ended or was started anew");
  const bool dropped = state.arbiter && drive_.setDriver(state.arbiter->active_source, yieldsToManual(state));
  const teleop::SourceView* manual = state.source("manual");
  const Twist2 before = drive_.setPoint();
  teleop::DriveLock lock =
      manual != nullptr && !manual->enabled ? teleop::DriveLock::kManualOff : teleop::DriveLock::kNone;
  if (state.arbiter && state.arbiter->status_age > teleop::kStatusLifetime) lock = teleop::DriveLock::kArbiterSilent;
  if (state.emergency_stop.value_or(false)) lock = teleop::DriveLock::kEmergencyStop;
  drive_.setLock(lock);
  if (dropped || before != drive_.setPoint()) {
    const std::string why =
        lock == teleop::DriveLock::kNone ? "another source took or released the wheels" : toString(lock);
    appendLog({teleop::Severity::kWarning, "set-point dropped: " + why});
  }
  const bool both_known = state.arbiter && last_state_.arbiter;
  if (both_known && stopsIn(state) != stopsIn(last_state_)) stopBecause("the robot was stopped meanwhile");
  for (const teleop::OperatorLogLine& line : teleop::eventsBetween(last_state_, state)) appendLog(line);
  last_state_ = state;
  goOnClearing(state);
  showCards(state);
  showSetPoint();
}

void PilotWidget::showCards(const teleop::OperatorState& state) {
  header_->setState(state);
  drive_card_->setState(state);
  scan_card_->setState(state);
  sources_card_->setState(state);
  patrol_card_->setState(state);
  spin_card_->setState(state);
  navigation_card_->setState(state);
  map_card_->setState(state);
  explorer_card_->setState(state);
}

void PilotWidget::setMap(const teleop::MapView& view) { map_card_->setView(view); }

void PilotWidget::appendLog(const teleop::OperatorLogLine& line) { log_card_->append(line); }

void PilotWidget::sayNotDone(const teleop::OperatorRequest& request) {
  using Kind = teleop::OperatorRequest::Kind;
  appendLog({teleop::Severity::kWarning,
             "what was clicked while the window was frozen, or just after it, is not done: click again"});
  const bool is_of_map = request.kind == Kind::kGoTo || request.kind == Kind::kFollowWaypoints ||
                         request.kind == Kind::kSaveMap || request.kind == Kind::kLoadMap;
  if (is_of_map) map_card_->sayNotDone();
}

void PilotWidget::stopBecause(const std::string& reason) {
  if (std::exchange(clears_left_, 0) > 0)
    appendLog({teleop::Severity::kWarning, "the stop is not cleared any more: " + reason});
  if (drive_.setPoint().isZero()) return drive_.stop();
  drive_.stop();
  appendLog({teleop::Severity::kWarning, "set-point dropped: " + reason});
  showSetPoint();
}

void PilotWidget::press(teleop::Motion motion) {
  drive_.press(motion);
  showSetPoint();
}

void PilotWidget::release(teleop::Motion motion) {
  drive_.release(motion);
  showSetPoint();
}

void PilotWidget::letGo() {
  drive_.releaseAll();
  showSetPoint();
}

/// Ends whatever may command motion, and has the stop cleared when that has had time to end.
void PilotWidget::haltAndClear() {
  using Kind = teleop::OperatorRequest::Kind;
  press(teleop::Motion::kStop);
  refreshes_to_clear_ = kRefreshesToHalt;
  clears_left_ = kMostClears;
  stops_to_clear_ = stopsIn(last_state_);
  if (last_state_.explorer_service_up) send({Kind::kExplore, false, {}, 0, 0.0, 0, 0.0});
  if (last_state_.patrol.active) send({Kind::kStopPatrol, false, {}, 0, 0.0, 0, 0.0});
  if (last_state_.spin.active) send({Kind::kStopSpin, false, {}, 0, 0.0, 0, 0.0});
  send({Kind::kStopNavigation, false, {}, 0, 0.0, 0, 0.0});
}

/// Asks again while the stop that was to be cleared lasts. What came after another stop is not cleared, even if the
/// robot was stopped already or that stop came between two refreshes.
void PilotWidget::goOnClearing(const teleop::OperatorState& state) {
  const bool cleared = !state.emergency_stop.value_or(false) || state.clear_refusal.empty();
  if (cleared || stopsIn(state) != stops_to_clear_) clears_left_ = 0;
  if (clears_left_ == 0 || --refreshes_to_clear_ > 0) return;
  --clears_left_;
  refreshes_to_clear_ = kRefreshesToHalt;
  send({teleop::OperatorRequest::Kind::kClearEmergencyStop, false, {}, 0, 0.0, 0, 0.0});
}

void PilotWidget::send(const teleop::OperatorRequest& request) { emit requested(request); }

void PilotWidget::showSetPoint() {
  drive_card_->showDrive(drive_);
  if (drive_.setPoint() == shown_) return;
  shown_ = drive_.setPoint();
  emit setPointChanged(shown_);
}

void PilotWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  const QEvent::Type type = event->type();
  if (type == QEvent::PaletteChange || type == QEvent::FontChange) applyTheme(*this);
}

void PilotWidget::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  loseSight();
}

void PilotWidget::loseSight() {
  letGo();
  stopBecause("its controls cannot be seen any more");
}

}  // namespace frontier_pilot::gui
