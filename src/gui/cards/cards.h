#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <array>
#include <vector>

#include "gui/controls.h"
#include "teleop/operator_link.h"

namespace frontier_pilot::gui {

/// Manual driving: the pad, the set-point, and the command that the arbiter sends to the base. [GUI-1] [GUI-4]
class DriveCard : public Card {
  Q_OBJECT

 public:
  explicit DriveCard(const teleop::TeleopParameters& parameters, QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);
  void showDrive(const teleop::DriveModel& drive);

 signals:
  void pressed(frontier_pilot::teleop::Motion motion);
  void released(frontier_pilot::teleop::Motion motion);
  void letGo();
  void holdToRunChanged(bool hold);

 private:
  QLayout* makePad();
  QString hint(const teleop::DriveModel& drive) const;

  std::vector<PadButton*> buttons_;
  BarGauge* linear_;
  BarGauge* angular_;
  QCheckBox* hold_;
  ElidedLabel* hint_;
  QString driver_;  ///< the source that drives; empty: nobody, or not known
};

/// All sources of velocity commands, each with its switch, its state and the age of its last message. [GUI-2]
class SourcesCard : public Card {
  Q_OBJECT

 public:
  explicit SourcesCard(QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void enableAsked(const QString& source, bool on);

 private:
  struct Row {
    QString name;
    QWidget* widget;
    Switch* toggle;
    Dot* dot;
    ElidedLabel* text;
    QLabel* figures;
  };
  void rebuild(const std::vector<teleop::SourceView>& sources);
  void fill(const Row& row, const teleop::SourceView& source, bool silent) const;

  std::vector<Row> rows_;
  QLabel* empty_;
};

/// The common part of the cards of actions: buttons that start the action, one that stops it, and its progress.
class ActionCard : public Card {
  Q_OBJECT

 signals:
  void stopAsked();

 protected:
  /// `name` is the action's name on the stop button, `server` the node that serves it.
  ActionCard(const QString& title, const QString& name, const QString& server, QWidget* parent);
  QPushButton* makeStart(const QString& text);
  QPushButton* stopButton() { return stop_; }
  ElidedLabel* progressLabel() { return progress_; }
  void showAction(const teleop::ActionView& action, bool emergency_stop);

 private:
  QString server_;
  std::vector<QPushButton*> start_;
  QPushButton* stop_;
  ElidedLabel* progress_;
};

/// Patrols: shape, side or radius, and laps.
class PatrolCard : public ActionCard {
  Q_OBJECT

 public:
  explicit PatrolCard(const teleop::TeleopParameters& parameters, QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void startAsked(int shape, double side, int laps);

 private:
  QLayout* makeButtons();

  QDoubleSpinBox* side_;
  QSpinBox* laps_;
};

/// A turn in place by an angle.
class SpinCard : public ActionCard {
  Q_OBJECT

 public:
  explicit SpinCard(QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  /// `angle` [rad]
  void startAsked(double angle);

 private:
  QSpinBox* angle_;
};

/// The goal of the navigation, how far it is, and what hinders the robot on its way. [GUI-2]
class NavigationCard : public Card {
  Q_OBJECT

 public:
  explicit NavigationCard(QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void cancelAsked();

 private:
  QLabel* goal_;
  QLabel* distance_;
  QLabel* time_;
  Dot* dot_;
  ElidedLabel* status_;
  QPushButton* cancel_;
};

/// The explorer: its state with the reason, and the figures of the exploration.
class ExplorerCard : public Card {
  Q_OBJECT

 public:
  explicit ExplorerCard(QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void runAsked(bool on);
  void resetAsked();
  void clearBoundsAsked();
  void clearInspectionsAsked();
  void returnAsked(bool on);

 private:
  QLayout* makeFigures();
  QLayout* makeLimits();
  QLayout* makeButtons();
  void showFigures(const teleop::ExplorerView& explorer);
  void showLimits(const teleop::OperatorState& state, bool heard);

  Dot* dot_;
  ElidedLabel* state_;
  QLabel* reason_;
  QLabel* area_;
  QLabel* distance_;
  QLabel* frontiers_;
  QLabel* share_;
  ElidedLabel* goals_;
  QPushButton* start_;
  QPushButton* pause_;
  QPushButton* reset_;
  ElidedLabel* bounds_;
  ElidedLabel* inspect_;
  ElidedLabel* end_;
  ElidedLabel* map_;
  QPushButton* clear_bounds_;
  QPushButton* clear_inspections_;
  Switch* return_;
};

/// The operator's log: the last few hundred lines.
class LogCard : public Card {
  Q_OBJECT

 public:
  explicit LogCard(QWidget* parent = nullptr);
  void append(const teleop::OperatorLogLine& line);

 private:
  QPlainTextEdit* text_;
};

}  // namespace frontier_pilot::gui
