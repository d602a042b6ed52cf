#pragma once

#include <rviz/panel.h>

#include <QVBoxLayout>
#include <memory>

#include "frontier_pilot/gui/pilot_controller.h"
#include "frontier_pilot/ros/gui_bridge.h"

namespace frontier_pilot {

/// The operator's window as a dock of rviz. Its parameters are those of `teleop_gui`, so that the two agree; it speaks
/// on `cmd_vel_manual` only while somebody drives with it.
class PilotPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit PilotPanel(QWidget* parent = nullptr);
  ~PilotPanel() override;

 private:
  void fill(QVBoxLayout& layout);

  std::unique_ptr<GuiBridge> bridge_;
  PilotWidget* widget_ = nullptr;
  std::unique_ptr<PilotController> controller_;
};

}  // namespace frontier_pilot
