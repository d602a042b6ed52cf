#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <string>

#include "gui/pilot_controller.h"
#include "gui/pilot_widget.h"
#include "teleop/fleet_link.h"

class QVBoxLayout;

namespace frontier_pilot::gui {

class FleetCard;

/// The desktop window: one robot in full, and above it the fleet, if there is one. Another robot gets a new PilotWidget
/// and a new link. The link to the one before it is closed, which sends a zero and cancels what was started here, and
/// retires. [GUI-1] [GUI-3]
class FleetWindow : public QWidget {
  Q_OBJECT

 public:
  /// `link` must outlive it. May wait for the master.
  explicit FleetWindow(teleop::FleetLink& link);
  ~FleetWindow() override;

  /// Sends a zero, cancels the actions that were started here, and sends nothing any more. Idempotent.
  void release();
  /// The robot that is shown; empty: the one in the window's own namespace.
  const std::string& shown() const { return shown_; }

 signals:
  /// ROS is shutting down, so the window has to close.
  void closeAsked();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void choose(const std::string& robot);
  void receive(teleop::OpenedRobot robot);
  void showRobot(teleop::OpenedRobot robot);
  bool ownRobotIsMissing() const;
  bool mayOpenAgain() const;
  void noteStop(const teleop::OperatorRequest& request);
  void stopChosen();
  void stopAll();

  teleop::FleetLink& fleet_link_;
  std::string shown_, chosen_;  ///< the chosen robot may not be open yet
  std::string reopened_;        ///< was opened once more, because it had not said what robot it is
  bool is_described_ = true;
  bool released_ = false;
  QVBoxLayout* layout_;
  FleetCard* card_;
  std::unique_ptr<teleop::OperatorLink> link_;
  std::unique_ptr<PilotWidget> widget_;
  std::unique_ptr<PilotController> controller_;
  QTimer refresh_timer_;
};

}  // namespace frontier_pilot::gui
