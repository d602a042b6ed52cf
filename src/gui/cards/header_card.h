#pragma once

#include "gui/controls.h"

class QBoxLayout;

namespace frontier_pilot::gui {

/// The emergency stop. It always accepts a click, and it shows only the state of the latched topic. [GUI-2]
class StopButton : public QPushButton {
  Q_OBJECT

 public:
  explicit StopButton(QWidget* parent = nullptr);
  /// `latched`: the state on the topic, nothing while it is not known; `asked`: a click has not been confirmed yet.
  void setShown(std::optional<bool> latched, bool asked);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString caption() const;

  std::optional<bool> latched_;
  bool asked_ = false;
};

/// Which source drives and why, and the emergency stop; always visible.
class HeaderCard : public Card {
  Q_OBJECT

 public:
  explicit HeaderCard(QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void stopAsked();
  void clearAsked();
  /// The operator wants everything that drives to be halted, and then the stop to be cleared.
  void haltAndClearAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showDriver(const teleop::OperatorState& state);
  void showRefusal(const teleop::OperatorState& state, bool latched);

  QBoxLayout* line_;
  Dot* dot_;
  QLabel* driver_;
  QLabel* summary_;
  QLabel* problems_;
  StopButton* stop_;
  QPushButton* clear_;
  QWidget* refusal_;  ///< why the stop was not cleared, and the way out
  QLabel* why_refused_;
  QPushButton* halt_and_clear_;
  int asked_refreshes_ = 0;  ///< for how many more refreshes a click is shown as not yet confirmed
};

}  // namespace frontier_pilot::gui
