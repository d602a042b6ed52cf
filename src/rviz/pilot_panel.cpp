#include "rviz/pilot_panel.h"

#include <ros/console.h>
#include <ros/init.h>
#include <pluginlib/class_list_macros.hpp>

#include <QLabel>
#include <QVBoxLayout>
#include <exception>

#include "gui/controls.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"

namespace frontier_pilot {
namespace {

/// The parameters of teleop_gui, or the defaults if those are invalid: rviz has to start in any case.
teleop::TeleopParameters panelParameters(const ros::NodeHandle& node) {
  try {
    teleop::TeleopParameters parameters;
    const Problems problems = loadParameters(readParameters(ros::NodeHandle(node, names::kTeleopGuiNode)), parameters);
    for (const std::string& problem : problems) ROS_WARN_STREAM("PilotPanel: " << problem);
    if (problems.empty()) return parameters;
  } catch (const std::exception& error) {
    ROS_WARN_STREAM("PilotPanel: " << error.what());
  }
  return teleop::TeleopParameters{};
}

}  // namespace

PilotPanel::PilotPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  // rviz does not catch exceptions of a panel.
  try {
    fill(*layout);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("PilotPanel: " << error.what());
    layout->addWidget(gui::makeLabel(QString("This panel could not be built: ") + error.what()));
  }
}

void PilotPanel::fill(QVBoxLayout& layout) {
  const ros::NodeHandle node;
  const teleop::TeleopParameters parameters = panelParameters(node);
  bridge_ = std::make_unique<GuiBridge>(node, parameters, GuiBridge::Manual::kOnDemand, [] { return ros::ok(); });
  widget_ = new gui::PilotWidget(parameters);
  layout.addWidget(widget_);
  controller_ = std::make_unique<gui::PilotController>(*widget_, *bridge_, fromSeconds(parameters.liveness_timeout));
}

PilotPanel::~PilotPanel() = default;

}  // namespace frontier_pilot

PLUGINLIB_EXPORT_CLASS(frontier_pilot::PilotPanel, rviz::Panel)
