#pragma once

#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "frontier_pilot/behavior/surroundings.h"
#include "frontier_pilot/ros/diagnostics.h"
#include "frontier_pilot/ros/names.h"
#include "frontier_pilot/ros/node_connections.h"
#include "frontier_pilot/ros/tf_bridge.h"

namespace frontier_pilot {

/// The frames that behaviours are driven in.
struct BehaviorFrames {
  std::string odom_frame = names::kOdomFrame;
  std::string base_frame = names::kBaseFootprintFrame;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("odom_frame", odom_frame, "", "frame of odometry");
    v.field("base_frame", base_frame, "", "frame of the robot");
  }
};

/// Keeps a behaviour's surroundings from `scan` and TF, and its inputs.
class BehaviorSurroundings {
 public:
  BehaviorSurroundings(const SurroundingsParameters& parameters, const BehaviorFrames& frames, const TfBridge& tf);

  /// Begins to listen.
  void subscribe(NodeConnections& connections);

  /// Pose and look-ahead at `now`, with a costmap at most `max_age` [s] old.
  BehaviorInputs inputs(double max_age, Time now);
  /// Forgets what was seen, after the clock has jumped back.
  void clear();
  const Rejections& rejections() const { return rejections_; }

 private:
  void handleScan(const sensor_msgs::LaserScan& msg);
  void takeIn();

  Surroundings surroundings_;
  BehaviorFrames frames_;
  const TfBridge& tf_;
  std::optional<LaserScan2> waiting_;  ///< until TF knows where the robot was
  Rejections rejections_{"scan"};
};

}  // namespace frontier_pilot
