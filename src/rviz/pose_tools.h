#pragma once

#include <ros/publisher.h>
#include <rviz/default_plugin/tools/pose_tool.h>

namespace frontier_pilot {

/// A tool of rviz that publishes a pose: press at the place, drag to where the robot is to look.
class PublishedPoseTool : public rviz::PoseTool {
 protected:
  /// What distinguishes the tools.
  struct Kind {
    const char* name;
    const char* description;
    const char* topic;
    char key;  ///< shortcut
    float r, g, b;
  };
  explicit PublishedPoseTool(const Kind& kind);
  void onInitialize() override;
  /// In rviz' fixed frame [m, rad].
  void onPoseSet(double x, double y, double theta) override;

 private:
  Kind kind_;
  ros::Publisher publisher_;
};

/// Asks the explorer to inspect a pose on its way. [EXP-10]
class InspectTool : public PublishedPoseTool {
  Q_OBJECT

 public:
  InspectTool();
};

/// Adds a waypoint to those that the waypoint follower collects. [NAV-5]
class WaypointTool : public PublishedPoseTool {
  Q_OBJECT

 public:
  WaypointTool();
};

}  // namespace frontier_pilot
