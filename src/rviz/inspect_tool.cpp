#include "rviz/inspect_tool.h"

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <rviz/display_context.h>
#include <rviz/load_resource.h>
#include <rviz/ogre_helpers/arrow.h>
#include <pluginlib/class_list_macros.hpp>

#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"

namespace frontier_pilot {

InspectTool::InspectTool() { shortcut_key_ = 'i'; }

void InspectTool::onInitialize() {
  PoseTool::onInitialize();
  setName("Inspect");
  setDescription("Have the explorer take this pose on its way: press at the place, drag to where the robot looks.");
  setIcon(rviz::loadPixmap("package://rviz/icons/classes/SetGoal.png"));
  arrow_->setColor(1.0F, 0.55F, 0.1F, 1.0F);
  publisher_ = ros::NodeHandle().advertise<geometry_msgs::PoseStamped>(names::kInspect, 1);
}

void InspectTool::onPoseSet(double x, double y, double theta) {
  geometry_msgs::PoseStamped msg;
  msg.header.frame_id = context_->getFixedFrame().toStdString();
  msg.header.stamp = ros::Time::now();
  msg.pose = toPoseMsg(Pose2(x, y, theta));
  publisher_.publish(msg);
}

}  // namespace frontier_pilot

PLUGINLIB_EXPORT_CLASS(frontier_pilot::InspectTool, rviz::Tool)
