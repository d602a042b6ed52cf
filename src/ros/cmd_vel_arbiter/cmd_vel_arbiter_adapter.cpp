#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"

#include <ros/console.h>

#include "ros/cmd_vel_arbiter/free_descriptors.h"
#include "ros/cmd_vel_arbiter/source_topics.h"
#include "ros/common/memory/disk.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr double kTick = 0.05;                                      // [s]
constexpr Duration kMasterPeriod = std::chrono::milliseconds(500);  // a lost stop service is back within 2 s [ARB-12]
constexpr Duration kMasterPatience = std::chrono::seconds(5);

/// Whether the message is a deliberate zero: one with a non-zero value on an axis that the base does not have.
bool isHold(const geometry_msgs::Twist& msg) {
  return msg.linear.y != 0.0 || msg.linear.z != 0.0 || msg.angular.x != 0.0 || msg.angular.y != 0.0;
}

}  // namespace

CmdVelArbiterAdapter::CmdVelArbiterAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      arbiter_(loadArbiterParameters(node, private_node)),
      memory_(rosHome(), rosSessions(), "stopped", node.resolveName(names::kEmergencyStop),
              SessionMemory::Owner::kService, spareFolder()),
      status_(takeItsPlace(node_)),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVel, 1)),
      stop_state_(advertiseStopState()),
      diagnostics_(node, private_node),
      connections_(node, kMasterPeriod) {
  hold_ups_.isCatchingUp(steadyNow());  // a start that takes long is a hold-up: what came meanwhile is old
  around_.own_name = ros::this_node::getName();
  around_.cmd_vel = cmd_vel_.getTopic();
  around_.status = status_.getTopic();
  around_.emergency_stop_state = stop_state_.getTopic();
  restoreStop();
  restoreCount();
  for (std::size_t i = 0; i < arbiter_.parameters().sources.size(); ++i) addSource(i);
  addServices();
  connections_.subscribeToEvents<std_msgs::Bool>(
      names::kEmergencyStopState, 10, [this](const auto& event) { handleStopState(event); },
      ros::TransportHints().tcpNoDelay());
  connections_.master().claimTopics({around_.status, around_.cmd_vel});  // a node that publishes both is an arbiter
  // A new master means a new session, in which a restarted arbiter has to find the stop again.
  connections_.master().onSession([this](const auto& sessions) { session_.put(sessions); });
  diagnostics_.add("velocity commands", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    fillDiagnostics(arbiter_.status(instantNow()), around_, status);
  });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  diagnostics_.add("memory", [this](auto& status) { connections_.memory().report(status); });
  connections_.everySteady(ros::WallDuration(kTick), [this] { tick(); });
  connections_.everySteady(ros::WallDuration(0.5), [this] {
    looks_at_others_ = !looks_at_others_;  // by turns, because each may wait for a slow disk [ARB-10]
    if (looks_at_others_) return takeOverStop();
    keepStop();
    publishStatus(true);
  });
  // In ROS time as well, so that commands also expire on time in a fast simulation.
  connections_.every(ros::Duration(kTick), [this] { publish(arbiter_.update(instantNow())); });
  tick();
}

void CmdVelArbiterAdapter::sayLastWords() {
  publish(Twist2{});
  memory_.endInOrder();
  stops_->end(false);
  for (SafeSwitch& source : switches_) source.end();
}

void CmdVelArbiterAdapter::addSource(std::size_t source) {
  const arbiter::SourceParameters& settings = arbiter_.parameters().sources[source];
  rejections_.emplace_back(settings.topic);
  const ros::Subscriber commands = connections_.subscribeToCommands<geometry_msgs::Twist>(
      settings.topic, 1, [this, source](const geometry_msgs::Twist& msg) { handleCommand(source, msg); },
      ros::TransportHints().tcpNoDelay(), kSettling);
  around_.source_topics[settings.name] = commands.getTopic();
  restoreSwitch(source);
  connections_.serve<std_srvs::SetBool::Request, std_srvs::SetBool::Response>(
      names::setEnabled(settings.name),
      [this, source](auto& request, auto& response) { return handleEnable(source, request, response); });
}

void CmdVelArbiterAdapter::handleCommand(std::size_t source, const geometry_msgs::Twist& msg) {
  std::string why;
  const std::optional<Twist2> twist = toTwist(msg, &why);
  // What came while this process was held up may be of before a stop, and of its clear; but a zero may be the last one.
  if (hold_ups_.isCatchingUp(steadyNow()) && twist && !twist->isZero()) return;
  if (!twist) rejections_[source].add(why);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  publish(arbiter_.onCommand(source, twist.value_or(Twist2{nan, nan}), instantNow(), isHold(msg)));
}

void CmdVelArbiterAdapter::tick() {
  listenBeforeClears();
  endListening();
  publish(arbiter_.setUnreachable(whyNoCallerCanConnect(), instantNow()));
  publish(arbiter_.tick(instantNow()));
  takeMasterReport();
  publishStatus(false);
}

void CmdVelArbiterAdapter::takeMasterReport() {
  if (auto report = connections_.master().take()) {
    around_.publishers = std::move(report->publishers);
    if (report->listeners) listListeners(std::move(*report->listeners));
    around_.rivals.swap(report->rivals);
    if (!around_.rivals.empty() || !report->rivals.empty()) takeOverStop();  // before it drives after a rival's end
    publish(arbiter_.contest(around_.rivals.empty() ? "" : around_.rivals.begin()->second, instantNow()));
  }
  around_.fleet_problem = fleet_.problem(steadyNow());
  around_.registration_problems = connections_.master().problems();
  around_.master_answers = steadyNow() - connections_.master().lastAnswer() < kMasterPatience;
  const auto session = session_.take();
  if (session && memory_.enter(*session)) keepStop();
}

void CmdVelArbiterAdapter::handleStopState(const ros::MessageEvent<const std_msgs::Bool>& event) {
  const std::string& node = event.getPublisherName();
  if (node == around_.own_name || event.getConstMessage()->data == 0) return;
  if (!arbiter_.stopped()) stop("reported by " + node + " on " + around_.emergency_stop_state);
}

void CmdVelArbiterAdapter::publish(const std::optional<Twist2>& twist) {
  if (twist) cmd_vel_.publish(toTwistMsg(*twist));
}

void CmdVelArbiterAdapter::publishStatus(bool always) {
  const ArbiterStatus status = toStatusMsg(arbiter_.status(instantNow()), around_);
  const std::string now = contentOf(status);
  const bool changed = now != last_content_;
  last_content_ = now;
  if (changed || always) status_.publish(status);
  if (changed) diagnostics_.publish();
  if (status.summary != last_summary_) THROTTLED_INFO(status.summary);
  last_summary_ = status.summary;
}

}  // namespace frontier_pilot
