#include "ros/navigator/fleet_motions.h"

#include <limits>

namespace frontier_pilot {
namespace {

/// A path with an odd number of coordinates gives one with a point that is not finite, which the rule refuses.
fleet::MotionMessage fromMsg(const FleetMotion& msg) {
  fleet::MotionMessage message;
  message.version = msg.version;
  message.robot = msg.robot;
  message.position = {msg.x, msg.y};
  message.radius = msg.radius;
  for (std::size_t i = 0; i < msg.path.size(); i += 2) {
    const float y = i + 1 < msg.path.size() ? msg.path[i + 1] : std::numeric_limits<float>::quiet_NaN();
    message.path.emplace_back(msg.path[i], y);
  }
  message.yields_to = msg.yields_to;
  message.passes = msg.passes;
  message.cannot_yield = msg.cannot_yield != 0;
  message.valid_for = msg.valid_for;
  return message;
}

FleetMotion toMsg(const fleet::MotionMessage& message) {
  FleetMotion msg;
  msg.version = message.version;
  msg.robot = message.robot;
  msg.x = static_cast<float>(message.position.x());
  msg.y = static_cast<float>(message.position.y());
  msg.radius = static_cast<float>(message.radius);
  for (const Vec2& point : message.path) {
    msg.path.push_back(static_cast<float>(point.x()));
    msg.path.push_back(static_cast<float>(point.y()));
  }
  msg.yields_to = message.yields_to;
  msg.passes = message.passes;
  msg.cannot_yield = message.cannot_yield ? 1 : 0;
  msg.valid_for = static_cast<float>(message.valid_for);
  return msg;
}

}  // namespace

void FleetMotions::connect(NodeConnections& connections, ros::NodeHandle& node, NodeDiagnostics& diagnostics) {
  if (channel_.isAlone()) return;
  channel_.connect(connections, node,
                   [this](const FleetMotion& msg, Time now) { return rule_.hear(fromMsg(msg), now); });
  diagnostics.add("traffic", [this](auto& status) { report(status); });
}

navigation::NavOrder FleetMotions::order(const navigation::Navigator& navigator, const Pose2& T_map_base,
                                         const std::optional<Pose2>& goal, const OccupancyGrid& map, Time now) {
  if (channel_.isAlone() || !T_map_base.isFinite()) return {};
  fleet::TrafficInputs inputs;
  inputs.T_map_base = T_map_base;
  if (goal) inputs.goal = goal->position();
  inputs.path = navigator.wayAhead();
  inputs.aside_failed = aside_failed_;
  inputs.map = &map;
  if (const auto T_common_map = channel_.mapInCommon()) inputs.T_map_common = T_common_map->inverse();
  const fleet::TrafficOrder order = rule_.update(inputs, now);
  tell(now);
  return order.forNavigator();
}

void FleetMotions::note(const navigation::NavigatorOutput& output) {
  aside_failed_ = output.aside_failed;
  traffic_ = output.traffic;
}

void FleetMotions::tell(Time now) {
  if (!channel_.isDue(now)) return;
  if (const auto message = rule_.message()) channel_.tell(toMsg(*message), now);
}

void FleetMotions::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (!channel_.mapInCommon()) {
    status.summary(DiagnosticStatus::WARN,
                   "other robots are obstacles like any other: no transform of the last seconds from " +
                       channel_.frame() + " to " + channel_.mapFrame());
  } else if (!traffic_.empty()) {
    status.summary(DiagnosticStatus::OK, traffic_);
  } else {
    status.summaryf(DiagnosticStatus::OK, "%s, with %zu other robots", channel_.robot().c_str(), rule_.heard());
  }
  channel_.report(status);
}

}  // namespace frontier_pilot
