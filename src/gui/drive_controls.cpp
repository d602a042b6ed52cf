#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <algorithm>

#include "gui/controls.h"

namespace frontier_pilot::gui {

BarGauge::BarGauge(const QString& name, const QString& unit, double limit, bool mirrored, QWidget* parent)
    : QWidget(parent), name_(name), unit_(unit), limit_(limit), mirrored_(mirrored) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void BarGauge::setSetPoint(double value) {
  if (value == set_point_) return;
  set_point_ = value;
  update();
}

void BarGauge::setActual(std::optional<double> value) {
  if (value == actual_) return;
  actual_ = value;
  update();
}

QSize BarGauge::sizeHint() const {
  const int em = emOf(*this);
  return {em * 11, em * 2};
}

double BarGauge::position(double value) const {
  const double share = std::clamp(value / limit_, -1.0, 1.0) * (mirrored_ ? -1.0 : 1.0);
  return width() * 0.5 * (1.0 + share);
}

void BarGauge::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::current();
  const double em = emOf(*this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme.muted);
  const QRectF caption(0.0, 0.0, width(), em * 1.15);
  painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter, name_);
  painter.setPen(set_point_ == 0.0 ? theme.muted : theme.text);
  const QString text = twoDecimals(set_point_) + " " + unit_;
  painter.drawText(caption, Qt::AlignRight | Qt::AlignVCenter, text);

  const QRectF bar(0.0, em * 1.3, width(), em * 0.5);
  QPainterPath clip;
  clip.addRoundedRect(bar, bar.height() / 2, bar.height() / 2);
  painter.setClipPath(clip);
  painter.fillRect(bar, faded(theme.idle, 0.3));
  const double from = position(0.0), to = position(set_point_);
  painter.fillRect(QRectF(std::min(from, to), bar.top(), std::abs(to - from), bar.height()), theme.accent);
  painter.setClipping(false);
  painter.fillRect(QRectF(from - 0.5, bar.top() - 2, 1, bar.height() + 4), theme.muted);
  if (actual_) {
    const double x = std::clamp(position(*actual_), 1.5, width() - 1.5);
    painter.fillRect(QRectF(x - 1.5, bar.top() - 2, 3, bar.height() + 4), theme.text);
  }
}

namespace {

/// The arrow of `motion` (up for Go), or the square of Stop, within the unit square around the origin.
QPainterPath glyph(teleop::Motion motion) {
  QPainterPath path;
  if (motion == teleop::Motion::kStop) {
    path.addRoundedRect(QRectF(-0.36, -0.36, 0.72, 0.72), 0.1, 0.1);
    return path;
  }
  path.moveTo(0.0, -0.42);
  path.lineTo(0.46, 0.34);
  path.lineTo(0.0, 0.16);
  path.lineTo(-0.46, 0.34);
  path.closeSubpath();
  static constexpr double kTurn[] = {0.0, 180.0, -90.0, 90.0};
  QTransform turn;
  turn.rotate(kTurn[static_cast<std::size_t>(motion)]);
  return turn.map(path);
}

}  // namespace

PadButton::PadButton(teleop::Motion motion, QWidget* parent) : QPushButton(toString(motion), parent), motion_(motion) {
  setObjectName(toString(motion));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  if (motion == teleop::Motion::kStop) setProperty("role", "stop");
}

QSize PadButton::sizeHint() const {
  const int em = emOf(*this);
  return {em * 9 / 2, em * 5 / 2};
}

void PadButton::paintEvent(QPaintEvent*) {
  QStyleOptionButton option;
  initStyleOption(&option);
  option.text.clear();
  QStylePainter painter(this);
  painter.drawControl(QStyle::CE_PushButton, option);
  const Theme theme = Theme::current();
  QColor color = motion_ == teleop::Motion::kStop ? theme.danger : theme.text;
  if (isDown()) color = motion_ == teleop::Motion::kStop ? QColor(Qt::white) : theme.on_accent;
  if (!isEnabled()) color = theme.idle;
  const double em = emOf(*this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.translate(width() * 0.5, height() * 0.5 - em * 0.42);
  painter.scale(em * 0.9, em * 0.9);
  painter.fillPath(glyph(motion_), color);
  painter.restore();
  painter.setPen(color);
  painter.drawText(QRectF(0, height() * 0.5 + em * 0.1, width(), em * 1.1), Qt::AlignCenter, text());
}

void PadButton::leaveEvent(QEvent* event) {
  QPushButton::leaveEvent(event);
  if (!isDown()) return;
  setDown(false);
  emit leftWhilePressed();
}

}  // namespace frontier_pilot::gui
