#include "gui/cards/header_card.h"

#include <QBoxLayout>
#include <QPainter>
#include <QResizeEvent>
#include <QtMath>

namespace frontier_pilot::gui {
namespace {

/// The number of refreshes (about 2 s) for which a click is shown as not yet confirmed.
constexpr int kAskedRefreshes = 20;
constexpr int kMostProblems = 3;  // that are shown; the others are in the tooltip

QPolygonF octagon(const QPointF& center, double radius) {
  QPolygonF shape;
  for (int corner = 0; corner < 8; ++corner) {
    const double angle = qDegreesToRadians(22.5 + 45.0 * corner);
    shape << center + radius * QPointF(qCos(angle), qSin(angle));
  }
  return shape;
}

struct Headline {
  QString text;
  QString detail;
  teleop::Severity severity = teleop::Severity::kIdle;
};

/// The arbiter's summary without what the title already says; if nothing remains, the command sent to the wheels.
QString detailOf(const teleop::ArbiterView& arbiter, const QString& title) {
  QString detail = QString::fromStdString(arbiter.summary);
  if (detail.startsWith(title, Qt::CaseInsensitive)) detail.remove(0, title.size());
  while (!detail.isEmpty() && !detail[0].isLetterOrNumber()) detail.remove(0, 1);
  if (!detail.isEmpty()) return detail;
  if (arbiter.command.isZero()) return "The wheels stand still.";
  return QString("The wheels get %1 m/s, %2 rad/s.")
      .arg(twoDecimals(arbiter.command.linear), twoDecimals(arbiter.command.angular));
}

Headline headlineOf(const teleop::OperatorState& state) {
  if (!state.connected) {
    const char* detail = state.stop_service_up ? "Waiting for it to answer. The emergency stop works without it."
                                               : "Waiting for it to answer.";
    return {"No ROS master", detail, teleop::Severity::kError};
  }
  const bool stopped = state.emergency_stop.value_or(false);
  if (!state.arbiter) {
    if (stopped) return {"Emergency stop", "The arbiter gives no status.", teleop::Severity::kError};
    return {"No arbiter", "Nobody can drive: cmd_vel_arbiter is not running.", teleop::Severity::kError};
  }
  const teleop::ArbiterView& arbiter = *state.arbiter;
  if (arbiter.status_age > teleop::kStatusLifetime) {
    return {"Arbiter silent", "Last heard " + ageText(arbiter.status_age) + " ago.", teleop::Severity::kError};
  }
  const QString driver = arbiter.active_source.empty() ? "Nobody drives" : QString::fromStdString(arbiter.driver());
  const QString title = stopped ? "Emergency stop" : driver;
  return {title, detailOf(arbiter, title), stopped ? teleop::Severity::kError : arbiter.severity};
}

/// What has to end before the stop can be cleared, as the text of the button that ends it.
QString wayOutOf(const teleop::OperatorState& state) {
  if (state.explorer && state.explorer->status_age <= teleop::kStatusLifetime && state.explorer->running)
    return "Pause the explorer and clear";
  if (state.patrol.active) return "Stop the patrol and clear";
  if (state.spin.active) return "Stop the spin and clear";
  return "Stop what drives and clear";
}

}  // namespace

StopButton::StopButton(QWidget* parent) : QPushButton("EMERGENCY STOP", parent) {
  setObjectName("emergency_stop");
  setAccessibleName("Emergency stop");
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::MinimumExpanding);
  QFont bold = font();
  bold.setBold(true);
  setFont(bold);
}

void StopButton::setShown(std::optional<bool> latched, bool asked) {
  latched_ = latched;
  asked_ = asked;
  setText(latched.value_or(false) ? "STOPPED" : "EMERGENCY STOP");
  update();
}

QSize StopButton::sizeHint() const {
  const int em = emOf(*this);
  return {em * 14, em * 7 / 2};
}

QString StopButton::caption() const {
  if (asked_ && !latched_.value_or(false)) return "requested, not yet confirmed";
  if (!latched_) return "state unknown: no arbiter";
  return *latched_ ? "latched" : "not latched";
}

void StopButton::paintEvent(QPaintEvent*) {
  const double em = emOf(*this);
  const bool latched = latched_.value_or(false);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor fill = latched_ ? QColor("#c8141f") : QColor("#7d3b40");
  if (isDown()) fill = fill.darker(125);
  if (underMouse() && !isDown()) fill = fill.lighter(108);
  const double edge = latched ? em * 0.22 : 1.0;
  painter.setPen(QPen(latched ? QColor("#ffd23f") : fill.darker(130), edge));
  painter.setBrush(fill);
  const double inset = edge / 2 + 0.5;
  painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), em * 0.6, em * 0.6);

  const double text_left = em * 3.5;
  painter.setPen(QPen(Qt::white, em * 0.14));
  painter.setBrush(Qt::NoBrush);
  const QPointF center(em * 2.0, height() * 0.5);
  painter.drawPolygon(octagon(center, em * 1.05));
  painter.fillRect(QRectF(center.x() - em * 0.55, center.y() - em * 0.14, em * 1.1, em * 0.28), Qt::white);
  painter.setPen(Qt::white);
  painter.drawText(QRectF(text_left, height() * 0.5 - em * 1.15, width() - text_left, em * 1.2), Qt::AlignVCenter,
                   text());
  QFont plain = font();
  plain.setBold(false);
  plain.setPointSizeF(plain.pointSizeF() * 0.88);
  painter.setFont(plain);
  painter.drawText(QRectF(text_left, height() * 0.5 + em * 0.05, width() - text_left, em * 1.1), Qt::AlignVCenter,
                   caption());
}

HeaderCard::HeaderCard(QWidget* parent)
    : Card("", parent),
      line_(new QBoxLayout(QBoxLayout::LeftToRight)),
      dot_(new Dot),
      driver_(makeLabel("", "headline")),
      summary_(makeLabel("", "muted", true)),
      problems_(makeLabel("", "", true)),
      stop_(new StopButton),
      clear_(new QPushButton("Clear")),
      refusal_(new QWidget),
      why_refused_(makeLabel("", "", true)),
      halt_and_clear_(new QPushButton) {
  driver_->setObjectName("driver");
  summary_->setObjectName("summary");
  problems_->setObjectName("problems");
  clear_->setObjectName("clear_emergency_stop");
  auto* text = new QVBoxLayout;
  auto* first = new QHBoxLayout;
  first->addWidget(dot_);
  first->addWidget(driver_, 1);
  text->addLayout(first);
  text->addWidget(summary_);
  text->addWidget(problems_);
  text->addStretch();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(stop_, 1);
  clear_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  buttons->addWidget(clear_);
  line_->addLayout(text, 1);
  line_->addLayout(buttons);
  content()->addLayout(line_);
  why_refused_->setObjectName("clear_refusal");
  halt_and_clear_->setObjectName("halt_and_clear");
  auto* refused = new QHBoxLayout(refusal_);
  refused->setContentsMargins(0, 0, 0, 0);
  refused->addWidget(why_refused_, 1);
  refused->addWidget(halt_and_clear_);
  content()->addWidget(refusal_);
  // Adapts to any width, and stacks its parts when it is narrow: see resizeEvent.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
  setMinimumWidth(emOf(*this) * 15);
  connect(stop_, &QPushButton::pressed, this, [this] {
    asked_refreshes_ = kAskedRefreshes;
    emit stopAsked();
  });
  connect(clear_, &QPushButton::clicked, this, &HeaderCard::clearAsked);
  connect(halt_and_clear_, &QPushButton::clicked, this, &HeaderCard::haltAndClearAsked);
  setState({});
}

void HeaderCard::setState(const teleop::OperatorState& state) {
  showDriver(state);
  const bool latched = state.emergency_stop.value_or(false);
  asked_refreshes_ = latched ? 0 : qMax(0, asked_refreshes_ - 1);
  stop_->setShown(state.emergency_stop, asked_refreshes_ > 0);
  stop_->setToolTip(state.stop_service_up ? "Stops the robot until it is cleared"
                                          : "The arbiter's stop service is down: this only zeroes the set-point");
  clear_->setEnabled(latched && state.clear_service_up);
  clear_->setToolTip(!latched ? "Nothing to clear"
                              : (state.clear_service_up ? "Clears the stop; this does not move the robot"
                                                        : "set_emergency_stop is down"));
  showRefusal(state, latched);
}

void HeaderCard::showRefusal(const teleop::OperatorState& state, bool latched) {
  refusal_->setVisible(latched && !state.clear_refusal.empty());
  why_refused_->setText("Not cleared: " + QString::fromStdString(state.clear_refusal) + ".");
  why_refused_->setStyleSheet("color: " + Theme::current().warning.name());
  halt_and_clear_->setText(wayOutOf(state));
  halt_and_clear_->setEnabled(state.clear_service_up);
}

void HeaderCard::showDriver(const teleop::OperatorState& state) {
  const Headline headline = headlineOf(state);
  dot_->setSeverity(headline.severity);
  driver_->setText(headline.text);
  summary_->setText(headline.detail);
  QStringList lines;
  if (state.contact.value_or(false)) lines << "The robot touches something: drive away from it.";
  if (state.arbiter) {
    for (const std::string& problem : state.arbiter->problems) {
      // Some problems are part of the summary already.
      if (state.arbiter->summary.find(problem) == std::string::npos) lines << QString::fromStdString(problem);
    }
  }
  problems_->setToolTip(lines.join("\n"));
  if (const int more = lines.size() - kMostProblems; more > 0)
    lines = lines.mid(0, kMostProblems) << QString("and %1 more").arg(more);
  problems_->setVisible(!lines.isEmpty());
  problems_->setText(lines.join("\n"));
  problems_->setStyleSheet("color: " + Theme::current().warning.name());
}

void HeaderCard::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const bool narrow = event->size().width() < emOf(*this) * 34;
  line_->setDirection(narrow ? QBoxLayout::BottomToTop : QBoxLayout::LeftToRight);
}

}  // namespace frontier_pilot::gui
