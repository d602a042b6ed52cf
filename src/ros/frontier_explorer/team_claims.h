#pragma once

#include <frontier_pilot/FleetClaims.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/fleet/claims.h"
#include "ros/common/messages/fleet_channel.h"
#include "ros/common/names.h"

namespace frontier_pilot {

/// How an explorer takes part in a team.
struct FleetParameters : FleetChannelParameters {
  FleetParameters() : FleetChannelParameters{"", names::kMapFrame, names::kFleetClaims} {}

  template <class V>
  void describe(V& v) {
    v.field("name", name, "", "name of the robot in its team, unique; empty: it explores alone");
    v.field("frame", frame, "", "frame that the robots of the team have in common", FrameName::kGiven);
    v.field("topic", topic, "", "where the robots of the team tell each other what they claim");
  }
};

/// Tells the other robots of the team what this one claims, and hears what they do. While it is not known where the
/// robot's map lies in the common frame, the robot works alone: it neither tells nor hears anything. [MUL-2]
class TeamClaims {
 public:
  /// `tf` has to outlive it; `map_frame` is the robot's.
  TeamClaims(const FleetParameters& parameters, const std::string& map_frame, const TfBridge& tf)
      : channel_(parameters, map_frame, tf, "claims"), book_(parameters.name) {}

  /// Does nothing for a robot without a name in a team, as nothing else of it does then.
  void connect(NodeConnections& connections, ros::NodeHandle& node, NodeDiagnostics& diagnostics);
  /// The others, in the robot's map frame.
  std::vector<exploration::Teammate> others(Time now);
  /// Tells the others, if it is time again.
  void tell(const std::optional<StampedPose2>& T_map_base, const std::vector<exploration::Claim>& claims, Time now);

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  FleetChannel<FleetClaims> channel_;
  fleet::ClaimBook book_;
  std::size_t heard_ = 0;  ///< robots at the last tick
};

}  // namespace frontier_pilot
