#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/theme.h"
#include "teleop/drive_model.h"

class QVBoxLayout;

namespace frontier_pilot::gui {

/// A framed group with a title. What belongs into it goes into `content()`.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(const QString& title, QWidget* parent = nullptr);
  QVBoxLayout* content() { return content_; }
  /// A remark at the right of the title, such as how old the data is.
  void setRemark(const QString& text, teleop::Severity severity);

 private:
  QVBoxLayout* content_;
  QLabel* remark_;
};

/// A label with a role of the style sheet; `wrap` lets it break lines.
QLabel* makeLabel(const QString& text, const char* role = "", bool wrap = false);

/// One line of text that gives way: what does not fit is cut and shown as the tool tip.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(const char* role = "", QWidget* parent = nullptr);
  void setFullText(const QString& text);
  QString fullText() const { return full_; }
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();
  QString full_;
};

/// A sliding switch. It shows what it was told, and a click only asks: see `asked`.
class Switch : public QAbstractButton {
  Q_OBJECT

 public:
  explicit Switch(const QString& name, QWidget* parent = nullptr);
  /// What the system says; nothing: it says nothing, and the switch is grey.
  void setShown(std::optional<bool> on, bool available, const QString& why_not);
  QSize sizeHint() const override;

 signals:
  /// The operator wants the other position.
  void asked(bool on);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void nextCheckState() override { emit asked(!isChecked()); }

 private:
  bool known_ = false;
};

/// A coloured dot.
class Dot : public QWidget {
  Q_OBJECT

 public:
  explicit Dot(QWidget* parent = nullptr);
  void setSeverity(teleop::Severity severity);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  teleop::Severity severity_ = teleop::Severity::kIdle;
};

/// A bar from minus to plus `limit` around a zero in the middle: the set-point as the filled part, what really goes to
/// the base as a mark.
class BarGauge : public QWidget {
  Q_OBJECT

 public:
  /// `mirrored`: positive grows to the left, as a turn to the left does.
  BarGauge(const QString& name, const QString& unit, double limit, bool mirrored, QWidget* parent = nullptr);
  void setSetPoint(double value);
  void setActual(std::optional<double> value);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double position(double value) const;

  QString name_, unit_;
  double limit_;
  bool mirrored_;
  double set_point_ = 0.0;
  std::optional<double> actual_;
};

/// A button of the drive pad: an arrow (or a square for Stop) over its name.
class PadButton : public QPushButton {
  Q_OBJECT

 public:
  explicit PadButton(teleop::Motion motion, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 signals:
  /// The pointer has left it while it was pressed.
  void leftWhilePressed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  teleop::Motion motion_;
};

/// With two decimals, and never `-0.00`.
QString twoDecimals(double value);

/// An age as people say it: `now`, `3.2 s`, `4 min`.
QString ageText(double seconds);

}  // namespace frontier_pilot::gui
