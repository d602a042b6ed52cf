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

/// What is shown where a value is not known.
inline const QString kNoValue = QString::fromUtf8("\u2013");

/// A framed group with a title. Its widgets go into `content()`.
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

/// A label of plain text with a role of the style sheet; `wrap` allows line breaks. Texts may come from messages, and a
/// rich one could have files read. [FLT-1]
QLabel* makeLabel(const QString& text, const char* role = "", bool wrap = false);

/// A tool tip that shows `text` as it is, whatever markup it holds. [FLT-1]
QString toolTipOf(const QString& text);

/// A single line of text that can shrink: text that does not fit is elided, and the tool tip shows all of it.
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

/// A sliding switch. It shows the state set by setShown; a click does not change it but emits `asked`.
class Switch : public QAbstractButton {
  Q_OBJECT

 public:
  explicit Switch(const QString& name, QWidget* parent = nullptr);
  /// `on` is the state that the system reports; nothing if it is unknown, which is drawn in grey. If the switch is not
  /// `available`, it is disabled, with `why_not` as its tool tip.
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

/// A bar from -`limit` to +`limit` with zero in the middle: the filled part is the set-point, the mark is the command
/// that is sent to the base.
class BarGauge : public QWidget {
  Q_OBJECT

 public:
  /// `mirrored`: positive values are drawn to the left, as for a turn to the left.
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
  /// The pointer has left the button while it was pressed.
  void leftWhilePressed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  teleop::Motion motion_;
};

/// With two decimals, and never `-0.00`.
QString twoDecimals(double value);

/// An age in a readable unit: `0.12 s`, `3.2 s`, `4 min`, `2 h`.
QString ageText(double seconds);

}  // namespace frontier_pilot::gui
