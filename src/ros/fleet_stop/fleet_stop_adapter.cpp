#include "ros/fleet_stop/fleet_stop_adapter.h"

#include <frontier_pilot/FleetStopStatus.h>
#include <ros/console.h>

#include <algorithm>
#include <iterator>

#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/common/throttled_log.h"
#include "ros/fleet_stop/stop_answer.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPublished = std::chrono::seconds(1);
/// Each line has a thread. There are fewer robots in any fleet, but anybody can publish topics that look like theirs.
constexpr std::size_t kMostLines = 200;

}  // namespace

FleetStopAdapter::FleetStopAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadFleetStopParameters(node, private_node)),
      node_(node),
      status_(node.advertise<FleetStopStatus>(names::kFleetStopStatus, 1, true)),
      diagnostics_(node, private_node),
      connections_(node) {
  for (const fleet::FleetRobot& robot : parameters_.robots) {
    const std::string service = stopOf(robot, node);
    known_.list(service);
    addRobot(service);
  }
  ros::AdvertiseServiceOptions stop;
  stop.initBySpecType<Call>(names::kFleetEmergencyStop, [this](Call& call) { return handleStop(call); });
  connections_.serve(stop);
  diagnostics_.add("robots", [this](auto& status) { report(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  connections_.everySteady(ros::WallDuration(0.2), [this] { tick(); });
}

/// A thread may be connecting to a computer that is switched off. Nothing is lost with this process.
FleetStopAdapter::~FleetStopAdapter() {
  limitTheEndAnyway();
  for (const auto& line : lines_) line->end();  // all, before one of them is waited for
}

bool FleetStopAdapter::addRobot(const std::string& service) {
  const auto is_it = [&](const auto& line) { return line->service() == service; };
  if (std::any_of(lines_.begin(), lines_.end(), is_it)) return true;
  if (lines_.size() >= kMostLines) {
    THROTTLED_ERROR("more than " << kMostLines << " arbiters: " << robotOf(service)
                                 << " is not stopped with the others");
    return false;
  }
  lines_.push_back(std::make_unique<StopLine>(node_, service));
  return true;
}

/// Those whose lines exist are asked first, whatever the master knows.
bool FleetStopAdapter::handleStop(Call& call) {
  for (const auto& line : lines_) line->ask();
  const std::size_t asked = lines_.size();
  takeMasterReport();
  for (std::size_t i = asked; i < lines_.size(); ++i) lines_[i]->ask();
  const SteadyTime deadline = steadyNow() + fromSeconds(parameters_.patience);
  std::vector<RobotAnswer> answers;
  for (const auto& line : lines_) answers.push_back({line->service(), line->answerUntil(deadline)});
  const FleetAnswer answer = summarize(answers);
  call.getResponse().success = answer.success ? 1 : 0;
  call.getResponse().message = last_stop_ = answer.message;
  THROTTLED_WARN(names::kFleetEmergencyStop << " called by " << call.getCallerName() << ": " << answer.message);
  return true;
}

void FleetStopAdapter::takeMasterReport() {
  const auto seen = connections_.master().take();
  if (!seen) return;
  has_rival_ = seen->rivals.count(node_.resolveName(names::kFleetEmergencyStop)) != 0;
  for (const auto& [topic, nodes] : seen->publishers) {
    const std::string service = serviceBeside(topic);
    if (service.empty() || service == node_.resolveName(names::kFleetEmergencyStop)) continue;  // not this node itself
    if (addRobot(service)) known_.see(service, steadyNow());
  }
  for (const std::string& service : regained_.take(seen->publishers, seen->providers)) {
    for (const auto& line : lines_)
      if (line->service() == service) line->connectAnew();
  }
}

void FleetStopAdapter::forgetRobots() {
  const SteadyTime now = steadyNow();
  for (const auto& line : lines_) {
    if (line->connected()) known_.see(line->service(), now);
  }
  for (const std::string& service : known_.forget(now)) {
    ROS_INFO_STREAM(robotOf(service) << " has been gone for an hour, and is not stopped with the others any more");
    const auto gone = std::stable_partition(lines_.begin(), lines_.end(),
                                            [&](const auto& line) { return line->service() != service; });
    std::for_each(gone, lines_.end(), [](const auto& line) { line->end(); });
    std::move(gone, lines_.end(), std::back_inserter(forgotten_));
    lines_.erase(gone, lines_.end());
  }
  const auto has_ended = [](const auto& line) { return line->ended(); };
  forgotten_.erase(std::remove_if(forgotten_.begin(), forgotten_.end(), has_ended), forgotten_.end());
}

void FleetStopAdapter::tick() {
  takeMasterReport();
  forgetRobots();
  FleetStopStatus msg;
  msg.stamp = ros::Time::now();
  for (const auto& line : lines_) (canStop(*line) ? msg.reached : msg.not_reached).push_back(line->service());
  if (steadyNow() - published_ < kPublished && msg.not_reached == not_reached_) return;
  published_ = steadyNow();
  not_reached_ = msg.not_reached;
  status_.publish(msg);
}

void FleetStopAdapter::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string why = has_rival_ ? "; the calls go to another node, not to " : "; no connection to ";
  std::string missing;
  for (const std::string& service : not_reached_) missing += (missing.empty() ? why : ", ") + robotOf(service);
  const std::string reached = std::to_string(lines_.size() - not_reached_.size()) + " of " +
                              std::to_string(lines_.size()) + " robots can be stopped together";
  status.summary(lines_.empty() || !missing.empty() ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 lines_.empty() ? "no robot is listed or known" : reached + missing);
  if (!last_stop_.empty()) status.add("last stop", last_stop_);
}

}  // namespace frontier_pilot
