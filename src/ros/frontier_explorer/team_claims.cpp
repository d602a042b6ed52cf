#include "ros/frontier_explorer/team_claims.h"

namespace frontier_pilot {
namespace {

fleet::ClaimsMessage fromMsg(const FleetClaims& msg) {
  fleet::ClaimsMessage message;
  message.version = msg.version;
  message.robot = msg.robot;
  message.position = {msg.x, msg.y};
  message.valid_for = msg.valid_for;
  for (const FleetClaim& claim : msg.claims) message.claims.push_back({{claim.x, claim.y}, claim.cost});
  return message;
}

FleetClaims toMsg(const fleet::ClaimsMessage& message) {
  FleetClaims msg;
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
  if (channel_.isAlone()) return;
  channel_.connect(connections, node,
                   [this](const FleetClaims& msg, Time now) { return book_.take(fromMsg(msg), now); });
  diagnostics.add("team", [this](auto& status) { report(status); });
}

std::vector<exploration::Teammate> TeamClaims::others(Time now) {
  std::vector<exploration::Teammate> others;
  const auto T_common_map = channel_.isAlone() ? std::nullopt : channel_.mapInCommon();
  if (T_common_map) others = book_.others(T_common_map->inverse(), now);
  heard_ = others.size();
  return others;
}

void TeamClaims::tell(const std::optional<StampedPose2>& T_map_base, const std::vector<exploration::Claim>& claims,
                      Time now) {
  if (channel_.isAlone() || !channel_.isDue(now) || !T_map_base || !T_map_base->pose.isFinite()) return;
  const auto T_common_map = channel_.mapInCommon();
  if (!T_common_map) return;
  channel_.tell(toMsg(fleet::makeClaimsMessage(channel_.robot(), T_map_base->pose, claims, *T_common_map)), now);
}

void TeamClaims::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (channel_.mapInCommon()) {
    status.summaryf(DiagnosticStatus::OK, "%s, with %zu other robots", channel_.robot().c_str(), heard_);
  } else {
    status.summary(DiagnosticStatus::WARN, "works alone: no transform of the last seconds from " + channel_.frame() +
                                               " to " + channel_.mapFrame());
  }
  channel_.report(status);
}

}  // namespace frontier_pilot
