#pragma once

#include <frontier_pilot/NavigatorProgress.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/common/inputs/localization_input.h"
#include "ros/common/messages/map_mirror.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "teleop/map_view.h"

namespace frontier_pilot {

/// The same node, with its callbacks on a queue of their own.
inline ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

/// Hears the map and what is shown on it, on a thread of its own: a large map must not delay `cmd_vel_manual`. All
/// places are given in the frame of the map, whatever that is called. [GUI-2] [GUI-3]
class MapLink {
 public:
  /// `tf` must outlive it. `base_frame` is that of the robot.
  MapLink(const ros::NodeHandle& node, const TfBridge& tf, std::string base_frame);
  ~MapLink();

  /// What has changed since the last call. May be called from any thread, and does not wait for a message.
  teleop::MapView take();
  /// The frame of the map; empty before the first one. For any thread.
  std::string frame() const;

 private:
  /// Places in a frame that need not be that of the map.
  struct Places {
    std::string frame;
    std::vector<Vec2> points;
  };

  void handlePlan(const nav_msgs::Path& msg);
  void handleProgress(const NavigatorProgress& msg);
  void handleMarkers(const visualization_msgs::MarkerArray& msg);
  void handleReplaced(const std_msgs::String&) { ++replaced_; }
  /// Prepares the next view.
  void collect();
  /// A navigator or an explorer that has ended leaves nothing on the map.
  void forgetGone();
  std::optional<teleop::MapChange> takeChange();
  teleop::MapScene scene() const;
  std::optional<Pose2> toMap(const std::string& frame, const char* what, std::string& problem) const;
  std::vector<Vec2> inMap(const Places& places, const char* what, std::string& problem) const;

  const TfBridge& tf_;
  const std::string base_frame_;
  ros::CallbackQueue queue_;  ///< before all subscriptions, which are taken from it when they end
  ros::NodeHandle node_;
  MapMirror map_;               ///< this and what follows up to the mutex are used by the thread of the topics alone
  std::uint32_t replaced_ = 0;  ///< how often another map has come in place of the one of before
  LocalizationInput localization_;
  Places plan_, frontiers_;
  std::optional<Pose2> goal_;
  std::string goal_frame_;
  Rejections bad_plans_{"plan"};
  ros::Subscriber plan_subscriber_, goal_subscriber_, frontiers_subscriber_;
  mutable std::mutex mutex_;  ///< guards the view
  teleop::MapView view_;
  NodeConnections connections_;
  ros::AsyncSpinner spinner_;
};

}  // namespace frontier_pilot
