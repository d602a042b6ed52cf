#include "rviz/pose_tools.h"

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <rviz/display_context.h>
#include <rviz/load_resource.h>
#include <rviz/ogre_helpers/arrow.h>
#include <pluginlib/class_list_macros.hpp>

#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"

namespace frontier_pilot {

PublishedPoseTool::PublishedPoseTool(const Kind& kind) : kind_(kind) { shortcut_key_ = kind_.key; }

void PublishedPoseTool::onInitialize() {
  PoseTool::onInitialize();
  setName(kind_.name);
  setDescription(kind_.description);
  setIcon(rviz::loadPixmap("package://rviz/icons/classes/SetGoal.png"));
  arrow_->setColor(kind_.r, kind_.g, kind_.b, 1.0F);
  publisher_ = ros::NodeHandle().advertise<geometry_msgs::PoseStamped>(kind_.topic, 1);
}

void PublishedPoseTool::onPoseSet(double x, double y, double theta) {
  geometry_msgs::PoseStamped msg;
  msg.header.frame_id = context_->getFixedFrame().toStdString();
  msg.header.stamp = ros::Time::now();
  msg.pose = toPoseMsg(Pose2(x, y, theta));
  publisher_.publish(msg);
}

InspectTool::InspectTool()
    : PublishedPoseTool(
          {"Inspect", "Have the explorer take this pose on its way: press at the place, drag to where the robot looks.",
           names::kInspect, 'i', 1.0F, 0.55F, 0.1F}) {}

WaypointTool::WaypointTool()
    : PublishedPoseTool({"Waypoint",
                         "Add a waypoint: press at the place, drag to where the robot looks. waypoint_follower/start "
                         "sends the robot to all of them.",
                         names::kAddWaypoint, 'w', 0.82F, 0.12F, 0.16F}) {}

}  // namespace frontier_pilot

PLUGINLIB_EXPORT_CLASS(frontier_pilot::InspectTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(frontier_pilot::WaypointTool, rviz::Tool)
