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

/// The desktop window: one robot whole, and above it the fleet, if there is one. Another robot gets a new PilotWidget
/// and a new link, so that nothing of the one before it stays; the link to that one is closed first, which sends a zero
/// and cancels what was started here. [GUI-1] [GUI-3]
class FleetWindow : public QWidget {
  Q_OBJECT

 public:
  /// `link` must outlive it.
  FleetWindow(teleop::FleetLink& link, const teleop::TeleopParameters& parameters);
  ~FleetWindow() override;

  /// Sends a zero, cancels the actions that were started here, and sends nothing any more. Idempotent.
  void release();
  const std::string& shown() const { return shown_; }

 signals:
  /// ROS is shutting down, so the window has to close.
  void closeAsked();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void choose(const std::string& robot);
  void open(const std::string& robot, const teleop::TeleopParameters& parameters);
  void applyTheme();

  teleop::FleetLink& fleet_link_;
  std::string shown_;  ///< empty: the robot in the window's own namespace
  bool closed_ = false;
  bool applying_theme_ = false;
  QVBoxLayout* layout_;
  FleetCard* card_;
  std::shared_ptr<teleop::OperatorLink> link_;
  PilotWidget* widget_ = nullptr;
  std::unique_ptr<PilotController> controller_;
  QTimer refresh_timer_;
};

}  // namespace frontier_pilot::gui
