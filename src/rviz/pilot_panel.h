#pragma once

#include <rviz/panel.h>

#include <QVBoxLayout>
#include <memory>

#include "gui/pilot_controller.h"
#include "ros/teleop_gui/gui_bridge.h"

namespace frontier_pilot {

/// The operator's window as a panel of rviz. It uses the parameters of `teleop_gui`, so that the two agree, and
/// publishes `cmd_vel_manual` only while the operator drives with it.
class PilotPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit PilotPanel(QWidget* parent = nullptr);
  ~PilotPanel() override;

 private:
  void fill(QVBoxLayout& layout);

  std::unique_ptr<GuiBridge> bridge_;
  gui::PilotWidget* widget_ = nullptr;
  std::unique_ptr<gui::PilotController> controller_;
};

}  // namespace frontier_pilot
