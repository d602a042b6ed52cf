#include "gui/controls.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QTextDocument>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

namespace frontier_pilot::gui {

Card::Card(const QString& title, QWidget* parent)
    : QFrame(parent), content_(new QVBoxLayout), remark_(makeLabel("", "muted")) {
  setObjectName("card");
  const int em = emOf(*this);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(em * 3 / 4, em / 2, em * 3 / 4, em * 2 / 3);
  outer->setSpacing(em * 2 / 5);
  if (!title.isEmpty()) {
    auto* line = new QHBoxLayout;
    line->addWidget(makeLabel(title, "title"));
    line->addStretch();
    line->addWidget(remark_);
    outer->addLayout(line);
  } else {
    remark_->hide();
    remark_->setParent(this);
  }
  content_->setSpacing(em * 2 / 5);
  outer->addLayout(content_);
}

void Card::setRemark(const QString& text, teleop::Severity severity) {
  remark_->setText(text);
  const Theme theme = Theme::current();
  const bool loud = severity == teleop::Severity::kWarning || severity == teleop::Severity::kError;
  remark_->setStyleSheet("color: " + (loud ? theme.color(severity) : theme.muted).name());
}

QLabel* makeLabel(const QString& text, const char* role, bool wrap) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setProperty("role", QString(role));
  label->setWordWrap(wrap);
  return label;
}

QString toolTipOf(const QString& text) { return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text) : text; }

ElidedLabel::ElidedLabel(const char* role, QWidget* parent) : QLabel(parent) {
  setProperty("role", QString(role));
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setFullText(const QString& text) {
  if (text == full_) return;
  full_ = text;
  setToolTip(toolTipOf(text));
  elide();
}

void ElidedLabel::elide() { setText(fontMetrics().elidedText(full_, Qt::ElideRight, width())); }

QSize ElidedLabel::minimumSizeHint() const { return {fontMetrics().height() * 2, fontMetrics().height()}; }
QSize ElidedLabel::sizeHint() const { return {fontMetrics().horizontalAdvance(full_), fontMetrics().height()}; }

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  elide();
}

Switch::Switch(const QString& name, QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setObjectName(name);
  setAccessibleName(name);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Switch::setShown(std::optional<bool> on, bool available, const QString& why_not) {
  known_ = on.has_value();
  setChecked(on.value_or(false));
  setEnabled(available);
  setToolTip(toolTipOf(available ? objectName() : why_not));
  update();
}

QSize Switch::sizeHint() const {
  const int em = emOf(*this);
  return {em * 19 / 10, em * 21 / 20};
}

void Switch::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::current();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF track = QRectF(rect()).adjusted(1, 1, -1, -1);
  const bool lit = isEnabled() && known_;
  QColor fill = isChecked() ? theme.accent : theme.idle;
  if (!lit) fill = faded(fill, 0.35);
  painter.setPen(hasFocus() ? QPen(theme.text, 1.5) : QPen(Qt::NoPen));
  painter.setBrush(isDown() ? fill.darker(120) : fill);
  painter.drawRoundedRect(track, track.height() / 2, track.height() / 2);
  const double radius = track.height() / 2 - 2.0;
  const double x = isChecked() ? track.right() - track.height() / 2 : track.left() + track.height() / 2;
  painter.setPen(Qt::NoPen);
  painter.setBrush(lit ? QColor(Qt::white) : theme.card);
  painter.drawEllipse(QPointF(known_ ? x : track.center().x(), track.center().y()), radius, radius);
}

Dot::Dot(QWidget* parent) : QWidget(parent) { setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed); }

void Dot::setSeverity(teleop::Severity severity) {
  severity_ = severity;
  update();
}

QSize Dot::sizeHint() const {
  const int em = emOf(*this);
  return {em * 3 / 4, em * 3 / 4};
}

void Dot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Theme::current().color(severity_));
  painter.drawEllipse(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5));
}

QString twoDecimals(double value) {
  // Adding 0.0 turns -0.0 into 0.0.
  return QString::number(std::round(value * 100.0) / 100.0 + 0.0, 'f', 2);
}

QString ageText(double seconds) {
  if (seconds < 0.95) return QString::number(seconds, 'f', 2) + " s";
  if (seconds < 60.0) return QString::number(seconds, 'f', 1) + " s";
  if (seconds < 3600.0) return QString::number(static_cast<int>(seconds / 60.0)) + " min";
  return QString::number(static_cast<int>(seconds / 3600.0)) + " h";
}

}  // namespace frontier_pilot::gui
