#pragma once

#include <ros/publisher.h>
#include <rviz/default_plugin/tools/pose_tool.h>

namespace frontier_pilot {

/// A tool of rviz that asks the explorer to inspect a pose on its way: press where the robot is to stand, drag to where
/// it is to look. [EXP-10]
class InspectTool : public rviz::PoseTool {
  Q_OBJECT

 public:
  InspectTool();
  void onInitialize() override;

 protected:
  /// In rviz' fixed frame [m, rad].
  void onPoseSet(double x, double y, double theta) override;

 private:
  ros::Publisher publisher_;
};

}  // namespace frontier_pilot
