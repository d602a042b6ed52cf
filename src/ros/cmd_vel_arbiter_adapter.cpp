#include "frontier_pilot/ros/cmd_vel_arbiter_adapter.h"

#include <ros/console.h>
#include <ros/this_node.h>
#include <std_msgs/Bool.h>

#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/names.h"
#include "frontier_pilot/ros/parameters.h"

namespace frontier_pilot {
namespace {

constexpr double kTick = 0.05;  // [s]
constexpr Duration kWatchPeriod = std::chrono::milliseconds(700);
constexpr Duration kMasterPatience = std::chrono::seconds(5);

/// A zero on purpose says so on an axis that the base does not have: the message is not all zero.
bool isHold(const geometry_msgs::Twist& msg) {
  return msg.linear.y != 0.0 || msg.linear.z != 0.0 || msg.angular.x != 0.0 || msg.angular.y != 0.0;
}

}  // namespace

CmdVelArbiterNode::CmdVelArbiterNode(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      arbiter_(loadNodeParameters<ArbiterParameters>(private_node)),
      memory_(rosHome(), rosSession(), ros::this_node::getName()),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVel, 1)),
      status_(node_.advertise<ArbiterStatus>(names::kArbiterStatus, 1, true)),
      stop_state_(node_.advertise<std_msgs::Bool>(names::kEmergencyStopState, 1, true)),
      clock_(node_),
      diagnostics_(node, private_node) {
  around_.own_name = ros::this_node::getName();
  around_.cmd_vel = cmd_vel_.getTopic();
  restoreStop();
  const auto& sources = arbiter_.parameters().sources;
  std::vector<std::string> topics = {around_.cmd_vel};
  for (std::size_t i = 0; i < sources.size(); ++i) {
    addSource(i);
    topics.push_back(around_.source_topics[sources[i].name]);
  }
  addStopServices();
  watch_.emplace(topics, kWatchPeriod);
  last_found_ = steadyNow();
  diagnostics_.add("velocity commands", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    fillDiagnostics(arbiter_.status(instantNow()), around_, status);
    clock_.report(status);
  });
  tick_ = node_.createSteadyTimer(ros::WallDuration(kTick), [this](const ros::SteadyTimerEvent&) { tick(); });
  status_tick_ = node_.createSteadyTimer(ros::WallDuration(1.0), [this](const auto&) { publishStatus(true); });
  expiry_ = node_.createTimer(ros::Duration(kTick), [this](const auto&) { publish(arbiter_.update(instantNow())); });
  clock_.restart(expiry_);
  tick();
}

CmdVelArbiterNode::~CmdVelArbiterNode() {
  // Destroying the publisher drops what it has not sent yet: leave the zeros time to reach the wire.
  for (int i = 0; i < 3; ++i) {
    publish(Twist2{});
    ros::WallDuration(0.02).sleep();
  }
}

void CmdVelArbiterNode::restoreStop() {
  if (const auto cause = memory_.recall()) {
    arbiter_.stop("from before a restart: " + *cause, instantNow());
    ROS_WARN_STREAM("comes up stopped, as it died: " << *cause);
  }
  publishStopState();
}

void CmdVelArbiterNode::addSource(std::size_t source) {
  const SourceParameters& settings = arbiter_.parameters().sources[source];
  rejections_.emplace_back(settings.topic);
  subscribers_.push_back(node_.subscribe<geometry_msgs::Twist>(
      settings.topic, 1, [this, source](const geometry_msgs::Twist::ConstPtr& msg) { handleCommand(source, *msg); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  around_.source_topics[settings.name] = subscribers_.back().getTopic();
  const boost::function<bool(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&)> enable =
      [this, source](auto& request, auto& response) { return handleEnable(source, request, response); };
  services_.push_back(node_.advertiseService(names::setEnabled(settings.name), enable));
}

void CmdVelArbiterNode::handleCommand(std::size_t source, const geometry_msgs::Twist& msg) {
  std::string why;
  const std::optional<Twist2> twist = toTwist(msg, &why);
  if (!twist) rejections_[source].add(why);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  publish(arbiter_.onCommand(source, twist.value_or(Twist2{nan, nan}), instantNow(), isHold(msg)));
}

void CmdVelArbiterNode::tick() {
  publish(arbiter_.tick(instantNow()));
  takePublishers();
  publishStatus(false);
}

void CmdVelArbiterNode::takePublishers() {
  if (auto found = watch_->take()) {
    around_.publishers = std::move(*found);
    last_found_ = steadyNow();
  }
  around_.master_answers = steadyNow() - last_found_ < kMasterPatience;
}

void CmdVelArbiterNode::publish(const std::optional<Twist2>& twist) {
  if (twist) cmd_vel_.publish(toTwistMsg(*twist));
}

void CmdVelArbiterNode::publishStopState() {
  std_msgs::Bool state;
  state.data = static_cast<std::uint8_t>(arbiter_.stopped());
  stop_state_.publish(state);
}

void CmdVelArbiterNode::publishStatus(bool anyway) {
  const ArbiterStatus status = toStatusMsg(arbiter_.status(instantNow()), around_);
  const std::string now = essence(status);
  const bool changed = now != last_essence_;
  last_essence_ = now;
  if (changed || anyway) status_.publish(status);
  if (changed) diagnostics_.publish();
  if (status.summary != last_summary_) ROS_INFO_STREAM(status.summary);
  last_summary_ = status.summary;
}

}  // namespace frontier_pilot
