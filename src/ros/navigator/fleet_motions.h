#pragma once

#include <frontier_pilot/FleetMotion.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "frontier_pilot/fleet/traffic.h"
#include "frontier_pilot/navigation/navigator.h"
#include "ros/common/messages/fleet_channel.h"
#include "ros/common/names.h"

namespace frontier_pilot {

/// How a navigator takes part in the traffic of a fleet.
struct TrafficParameters : FleetChannelParameters {
  TrafficParameters() : FleetChannelParameters{"", names::kMapFrame, names::kFleetMotions} {}

  template <class V>
  void describe(V& v) {
    v.field("name", name, "", "name of the robot in its fleet, unique; empty: it takes no part in the traffic rule");
    v.field("frame", frame, "", "frame that the robots of the fleet have in common", FrameName::kGiven);
    v.field("topic", topic, "", "where the robots of the fleet tell each other where they are going to drive");
  }
};

/// Tells the other robots where this one is going to drive, and asks the navigator to wait or to make way. While it is
/// not known where the robot's map lies in the common frame, the others are obstacles like any other. [MUL-3]
class FleetMotions {
 public:
  /// `tf` has to outlive it; `map_frame` is the robot's, `radius` [m] that of the disc around its outline.
  FleetMotions(const TrafficParameters& parameters, const std::string& map_frame, double radius, const TfBridge& tf)
      : channel_(parameters, map_frame, tf, "motions"), rule_(parameters.name, radius) {}

  /// Does nothing for a robot without a name in a fleet, as nothing else of it does then.
  void connect(NodeConnections& connections, ros::NodeHandle& node, NodeDiagnostics& diagnostics);
  /// What the navigator has to do now; `goal` is the one that it pursues. Tells the others, if it is time again.
  /// Without a pose that it can trust the robot is an obstacle like any other for them, and they for it.
  navigation::NavOrder order(const navigation::Navigator& navigator, const Pose2& T_map_base,
                             const std::optional<Pose2>& goal, const OccupancyGrid& map, Time now);
  /// While the robot does not know where it is.
  void forget() { rule_.forget(); }
  /// Whether the navigator found a way to the place where it had to go.
  void note(const navigation::NavigatorOutput& output);

 private:
  void tell(Time now);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  FleetChannel<FleetMotion> channel_;
  fleet::TrafficRule rule_;
  bool aside_failed_ = false;
  std::string traffic_;  ///< what the robot does for another one; empty: nothing
};

}  // namespace frontier_pilot
