#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "gui/pilot_widget.h"
#include "teleop/operator_link.h"

namespace frontier_pilot::gui {

/// Connects a PilotWidget to a link: passes on the set-point every 50 ms, shows the state ten times a second and the
/// map five times, and passes on the operator's requests. It runs in the GUI thread, so that its beat shows that the
/// window responds. What was clicked or pressed while the window was frozen is read afterwards, when the robot may have
/// been stopped and the stop cleared: of that only what ends a motion is done. [GUI-3] [ARB-12]
class PilotController : public QObject {
  Q_OBJECT

 public:
  /// Both must outlive it. A gap between two beats of more than `liveness_timeout` counts as a freeze.
  PilotController(PilotWidget& widget, teleop::OperatorLink& link, Duration liveness_timeout);
  /// Closes the link.
  ~PilotController() override;

  /// Sends a zero and cancels the actions that were started here. Nothing is sent after that. Idempotent.
  void close();

 signals:
  /// ROS is shutting down, so the window has to close.
  void closeAsked();

 private:
  void beat();
  void pass(const teleop::OperatorRequest& request);
  /// Notes that the window responds. If it was frozen and events of that time may still be read, drops the set-point
  /// and returns false.
  bool respond();
  void refresh();

  PilotWidget& widget_;
  teleop::OperatorLink& link_;
  Duration liveness_timeout_;
  QTimer beat_timer_, refresh_timer_;
  std::optional<SteadyTime> beat_at_;  ///< when the window showed last that it responds
  QElapsedTimer since_freeze_;         ///< the last time that it was found to have been frozen
  bool map_is_due_ = true;             ///< at every second refresh
  bool closed_ = false;
};

}  // namespace frontier_pilot::gui
