#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/this_node.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/fleet/claims.h"
#include "ros/common/clock.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/robot_speakers.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// Where a robot speaks to the others of its fleet.
struct FleetChannelParameters {
  std::string name;   ///< of the robot, unique in the fleet; empty: it is alone, and neither speaks nor hears
  std::string frame;  ///< that the robots have in common
  std::string topic;
};

/// A topic on which the robots of a fleet tell each other something twice a second, in a frame that they have in
/// common. Messages in another frame, those of a node that does not speak for the robot, and those that are not taken,
/// are counted and named in the diagnostics. [FLT-1]
template <class Msg>
class FleetChannel {
 public:
  /// `what` names the messages in the diagnostics. `tf` has to outlive it; `map_frame` is the robot's.
  FleetChannel(FleetChannelParameters parameters, std::string map_frame, const TfBridge& tf, const std::string& what)
      : parameters_(std::move(parameters)), map_frame_(std::move(map_frame)), tf_(tf), refused_(what) {}

  bool isAlone() const { return parameters_.name.empty(); }
  const std::string& robot() const { return parameters_.name; }
  const std::string& frame() const { return parameters_.frame; }
  const std::string& mapFrame() const { return map_frame_; }

  /// `take` is given each message, its own included, when it has arrived.
  void connect(NodeConnections& connections, ros::NodeHandle& node,
               std::function<fleet::ClaimsVerdict(const Msg&, Time)> take) {
    take_ = std::move(take);
    publisher_ = node.advertise<Msg>(parameters_.topic, 5);
    connections.subscribeToEvents<Msg>(parameters_.topic, 100, [this](const auto& event) { hear(event); });
  }

  /// T_common_map by the latest transform; nothing if that is old: then the robots' maps are not merged any more.
  std::optional<Pose2> mapInCommon() const {
    constexpr Duration kOldest = std::chrono::seconds(5);
    return tf_.latest(parameters_.frame, map_frame_, kOldest);
  }

  /// Whether it is time to tell the others again.
  bool isDue(Time now) const { return !told_ || now < *told_ || now - *told_ >= kPeriod; }
  /// Tells the others; sets the header.
  void tell(Msg msg, Time now) {
    msg.header.frame_id = parameters_.frame;
    msg.header.stamp = toRosTime(now);
    publisher_.publish(msg);
    told_ = now;
  }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const { refused_.report(status); }

 private:
  static constexpr Duration kPeriod = std::chrono::milliseconds(500);

  void hear(const ros::MessageEvent<const Msg>& event) {
    const Msg& msg = *event.getConstMessage();
    if (msg.header.frame_id != parameters_.frame) {
      return refused_.add("in the frame '" + msg.header.frame_id + "', and not in '" + parameters_.frame + "'");
    }
    const std::string& node = event.getPublisherName();
    const SteadyTime now = steadyNow();
    const std::string speaker = speakers_.insteadOf(node, msg.robot, now);
    if (!speaker.empty()) return refused_.add("from " + node + ": " + speaker + " speaks for '" + msg.robot + "'");
    const fleet::ClaimsVerdict verdict = take_(msg, rosNow());
    if (verdict == fleet::ClaimsVerdict::kTaken) return speakers_.heard(node, msg.robot, now);
    if (verdict != fleet::ClaimsVerdict::kOwn) return refused_.add(toString(verdict));
    if (node == ros::this_node::getName()) return;
    refused_.add("from " + node + ", another robot with this one's name, '" + robot() +
                 "': neither knows of the other");
  }

  FleetChannelParameters parameters_;
  std::string map_frame_;
  const TfBridge& tf_;
  Rejections refused_;
  RobotSpeakers speakers_;
  std::function<fleet::ClaimsVerdict(const Msg&, Time)> take_;
  std::optional<Time> told_;
  ros::Publisher publisher_;
};

}  // namespace frontier_pilot
