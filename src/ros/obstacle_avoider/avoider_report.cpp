#include <cmath>
#include <limits>

#include "ros/obstacle_avoider/avoider_report.h"

namespace frontier_pilot {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

const char* directionOf(int turn) {
  if (turn == 0) return "";
  return turn > 0 ? "left" : "right";
}

unsigned char levelOf(avoid::AvoiderState state) {
  switch (state) {
    case avoid::AvoiderState::kFault:
    case avoid::AvoiderState::kStuck:
      return Level::ERROR;
    case avoid::AvoiderState::kWaiting:
      return Level::WARN;
    default:
      return Level::OK;  // switched off as well: somebody wants it so
  }
}

}  // namespace

std::string summarize(const avoid::AvoiderSnapshot& snapshot) {
  return std::string(toString(snapshot.state)) + ": " + snapshot.reason;
}

AvoiderStatus toStatusMsg(const avoid::AvoiderSnapshot& snapshot) {
  const bool known = snapshot.scan_age && snapshot.around.fault.empty();
  const auto orUnknown = [known](double v) { return known ? v : std::numeric_limits<double>::quiet_NaN(); };
  AvoiderStatus msg;
  msg.stamp = ros::Time::now();
  msg.summary = summarize(snapshot);
  msg.state = static_cast<std::uint8_t>(snapshot.state);
  msg.reason = snapshot.reason;
  msg.obstacle_distance = orUnknown(snapshot.around.obstacleDistance());
  msg.front_left = orUnknown(snapshot.around.front_left);
  msg.front_right = orUnknown(snapshot.around.front_right);
  const bool sees_rear = snapshot.around.sees_rear || std::isfinite(snapshot.around.rear);
  msg.rear = sees_rear ? orUnknown(snapshot.around.rear) : std::numeric_limits<double>::quiet_NaN();
  msg.direction = directionOf(snapshot.turn);
  msg.cycle = static_cast<std::uint32_t>(snapshot.cycle);
  msg.episodes = snapshot.episodes;
  msg.scan_age = snapshot.scan_age.value_or(-1.0);
  msg.faults = snapshot.faults;
  return msg;
}

void fillDiagnostics(const avoid::AvoiderSnapshot& snapshot, diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  diagnostics.summary(levelOf(snapshot.state), summarize(snapshot));
  diagnostics.add("obstacle distance [m]", snapshot.around.obstacleDistance());
  diagnostics.add("scan age [s]", snapshot.scan_age.value_or(-1.0));
  diagnostics.add("episodes", snapshot.episodes);
}

}  // namespace frontier_pilot
