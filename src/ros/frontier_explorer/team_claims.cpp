#include "ros/frontier_explorer/team_claims.h"

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(500);

fleet::ClaimsMessage fromMsg(const FleetClaims& msg) {
  fleet::ClaimsMessage message;
  message.version = msg.version;
  message.robot = msg.robot;
  message.position = {msg.x, msg.y};
  message.valid_for = msg.valid_for;
  for (const FleetClaim& claim : msg.claims) message.claims.push_back({{claim.x, claim.y}, claim.cost});
  return message;
}

FleetClaims toMsg(const fleet::ClaimsMessage& message, const std::string& frame, Time now) {
  FleetClaims msg;
  msg.header.frame_id = frame;
  msg.header.stamp = toRosTime(now);
  msg.version = message.version;
  msg.robot = message.robot;
  msg.x = static_cast<float>(message.position.x());
  msg.y = static_cast<float>(message.position.y());
  msg.valid_for = static_cast<float>(message.valid_for);
  for (const exploration::Claim& claim : message.claims) {
    FleetClaim one;
    one.x = static_cast<float>(claim.place.x());
    one.y = static_cast<float>(claim.place.y());
    one.cost = static_cast<float>(claim.cost);
    msg.claims.push_back(one);
  }
  return msg;
}

}  // namespace

void TeamClaims::connect(NodeConnections& connections, ros::NodeHandle& node, NodeDiagnostics& diagnostics) {
  if (parameters_.name.empty()) return;
  publisher_ = node.advertise<FleetClaims>(parameters_.topic, 5);
  connections.subscribe(parameters_.topic, 100, &TeamClaims::hear, this);
  diagnostics.add("team", [this](auto& status) { report(status); });
}

void TeamClaims::hear(const FleetClaims& msg) {
  if (msg.header.frame_id != parameters_.frame) {
    return refused_.add("in the frame '" + msg.header.frame_id + "', and not in '" + parameters_.frame + "'");
  }
  const fleet::ClaimsVerdict verdict = book_.take(fromMsg(msg), rosNow());
  const bool refused = verdict != fleet::ClaimsVerdict::kTaken && verdict != fleet::ClaimsVerdict::kOwn;
  if (refused) refused_.add(toString(verdict));
}

/// T_common_map by the latest transform; nothing if that is old: then the robots' maps are not merged any more.
std::optional<Pose2> TeamClaims::mapInCommon() const {
  constexpr Duration kOldest = std::chrono::seconds(5);
  return tf_.latest(parameters_.frame, map_frame_, kOldest);
}

std::vector<exploration::Teammate> TeamClaims::others(Time now) {
  std::vector<exploration::Teammate> others;
  const auto T_common_map = parameters_.name.empty() ? std::nullopt : mapInCommon();
  if (T_common_map) others = book_.others(T_common_map->inverse(), now);
  heard_ = others.size();
  return others;
}

void TeamClaims::tell(const std::optional<StampedPose2>& T_map_base, const std::vector<exploration::Claim>& claims,
                      Time now) {
  const bool due = !told_ || now < *told_ || now - *told_ >= kPeriod;
  if (parameters_.name.empty() || !due || !T_map_base || !T_map_base->pose.isFinite()) return;
  const auto T_common_map = mapInCommon();
  if (!T_common_map) return;
  publisher_.publish(toMsg(fleet::makeClaimsMessage(parameters_.name, T_map_base->pose, claims, *T_common_map),
                           parameters_.frame, now));
  told_ = now;
}

void TeamClaims::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const bool located = mapInCommon().has_value();
  if (located) {
    status.summaryf(DiagnosticStatus::OK, "%s, with %zu other robots", parameters_.name.c_str(), heard_);
  } else {
    status.summary(DiagnosticStatus::WARN,
                   "works alone: no transform of the last seconds from " + parameters_.frame + " to " + map_frame_);
  }
  refused_.report(status);
}

}  // namespace frontier_pilot
