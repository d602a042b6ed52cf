#include "gui/pilot_controller.h"

namespace frontier_pilot::gui {
namespace {

constexpr int kBeatPeriod = 50;      // [ms]
constexpr int kRefreshPeriod = 100;  // [ms]
constexpr int kBacklog = 500;        // [ms], in which the events of a freeze are read, also on a busy computer

/// Whether the request ends a motion, and so is right however late it is.
bool endsMotion(const teleop::OperatorRequest& request) {
  using Kind = teleop::OperatorRequest::Kind;
  switch (request.kind) {
    case Kind::kEmergencyStop:
    case Kind::kStopPatrol:
    case Kind::kStopSpin:
    case Kind::kStopNavigation:
      return true;
    case Kind::kExplore:
      return !request.on;
    default:
      return false;
  }
}

}  // namespace

PilotController::PilotController(PilotWidget& widget, teleop::OperatorLink& link, Duration liveness_timeout)
    : widget_(widget), link_(link), liveness_timeout_(liveness_timeout) {
  connect(&widget_, &PilotWidget::requested, this, &PilotController::pass);
  connect(&widget_, &PilotWidget::setPointChanged, this, [this](const Twist2&) { beat(); });
  connect(&beat_timer_, &QTimer::timeout, this, &PilotController::beat);
  connect(&refresh_timer_, &QTimer::timeout, this, &PilotController::refresh);
  beat_timer_.setTimerType(Qt::PreciseTimer);
  beat_timer_.start(kBeatPeriod);
  refresh_timer_.start(kRefreshPeriod);
}

PilotController::~PilotController() { close(); }

void PilotController::close() {
  if (closed_) return;
  closed_ = true;
  beat_timer_.stop();
  refresh_timer_.stop();
  link_.close();
}

void PilotController::beat() {
  if (closed_) return;
  respond();
  link_.beat(widget_.setPoint());
}

void PilotController::pass(const teleop::OperatorRequest& request) {
  const bool up_to_date = respond();
  if (up_to_date || endsMotion(request)) return link_.request(request);
  widget_.sayNotDone(request);
}

bool PilotController::respond() {
  const SteadyTime now = link_.now();
  const bool froze = beat_at_ && now - *beat_at_ > liveness_timeout_;
  beat_at_ = now;
  if (froze) since_freeze_.start();
  if (!since_freeze_.isValid() || since_freeze_.hasExpired(kBacklog)) return true;
  // This changes the set-point, which calls `beat` and so this function again, but then with a set-point of zero.
  widget_.stopBecause("the window was frozen");
  return false;
}

void PilotController::refresh() {
  if (!link_.running()) {
    close();
    emit closeAsked();
    return;
  }
  for (const teleop::OperatorLogLine& line : link_.takeLog()) widget_.appendLog(line);
  widget_.setState(link_.state());
  if (map_is_due_) widget_.setMap(link_.takeMap());
  map_is_due_ = !map_is_due_;
}

}  // namespace frontier_pilot::gui
