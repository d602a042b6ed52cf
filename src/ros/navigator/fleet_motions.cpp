#include "ros/navigator/fleet_motions.h"

#include <limits>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(500);

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

FleetMotion toMsg(const fleet::MotionMessage& message, const std::string& frame, Time now) {
  FleetMotion msg;
  msg.header.frame_id = frame;
  msg.header.stamp = toRosTime(now);
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
  if (parameters_.name.empty()) return;
  publisher_ = node.advertise<FleetMotion>(parameters_.topic, 5);
  connections.subscribe(parameters_.topic, 100, &FleetMotions::hear, this);
  diagnostics.add("traffic", [this](auto& status) { report(status); });
}

void FleetMotions::hear(const FleetMotion& msg) {
  if (msg.header.frame_id != parameters_.frame) {
    return refused_.add("in the frame '" + msg.header.frame_id + "', and not in '" + parameters_.frame + "'");
  }
  const fleet::ClaimsVerdict verdict = rule_.hear(fromMsg(msg), rosNow());
  const bool refused = verdict != fleet::ClaimsVerdict::kTaken && verdict != fleet::ClaimsVerdict::kOwn;
  if (refused) refused_.add(toString(verdict));
}

/// T_map_common by the latest transform; nothing if that is old: then the robots' maps are not merged any more.
std::optional<Pose2> FleetMotions::commonInMap() const {
  constexpr Duration kOldest = std::chrono::seconds(5);
  return tf_.latest(map_frame_, parameters_.frame, kOldest);
}

navigation::NavOrder FleetMotions::order(const navigation::Navigator& navigator,
                                         const std::optional<StampedPose2>& T_map_base,
                                         const std::optional<Pose2>& goal, const OccupancyGrid& map, Time now) {
  navigation::NavOrder asked;
  if (parameters_.name.empty() || !T_map_base || !T_map_base->pose.isFinite()) return asked;
  fleet::TrafficInputs inputs;
  inputs.T_map_base = T_map_base->pose;
  if (goal) inputs.goal = goal->position();
  inputs.path = navigator.wayAhead();
  inputs.aside_failed = aside_failed_;
  inputs.map = &map;
  inputs.T_map_common = commonInMap();
  const fleet::TrafficOrder order = rule_.update(inputs, now);
  tell(now);
  asked.hold = order.kind == fleet::TrafficOrder::Kind::kHold;
  if (order.kind == fleet::TrafficOrder::Kind::kAside) asked.aside = order.place;
  asked.why = order.text();
  for (const auto& body : order.making_way) asked.making_way.push_back({body.position, body.radius});
  for (const auto& body : order.moving) asked.moving.push_back({body.position, body.velocity, body.radius});
  return asked;
}

void FleetMotions::note(const navigation::NavigatorOutput& output) {
  aside_failed_ = output.aside_failed;
  traffic_ = output.traffic;
}

void FleetMotions::tell(Time now) {
  const bool due = !told_ || now < *told_ || now - *told_ >= kPeriod;
  const auto message = due ? rule_.message() : std::nullopt;
  if (!message) return;
  publisher_.publish(toMsg(*message, parameters_.frame, now));
  told_ = now;
}

void FleetMotions::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (!commonInMap()) {
    status.summary(DiagnosticStatus::WARN,
                   "other robots are obstacles like any other: no transform of the last seconds "
                   "from " +
                       parameters_.frame + " to " + map_frame_);
  } else if (!traffic_.empty()) {
    status.summary(DiagnosticStatus::OK, traffic_);
  } else {
    status.summaryf(DiagnosticStatus::OK, "%s, with %zu other robots", parameters_.name.c_str(), rule_.heard());
  }
  refused_.report(status);
}

}  // namespace frontier_pilot
