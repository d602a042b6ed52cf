#include "frontier_pilot/ros/behavior_server_adapter.h"

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Twist.h>

#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/parameters.h"
#include "frontier_pilot/ros/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr double kFootprintPeriod = 0.2;  // [s]

}  // namespace

BehaviorServerNode::BehaviorServerNode(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      parameters_(loadNodeParameters<BehaviorServerParameters>(private_node)),
      behavior_(parameters_.behavior),
      around_(parameters_.surroundings, parameters_.behavior.robot, parameters_.frames, tf_),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVelBehavior, 10)),
      footprint_(node_.advertise<geometry_msgs::PolygonStamped>(names::kFootprint, 1, true)),
      diagnostics_(node, private_node),
      connections_(node) {
  around_.subscribe(connections_);
  connections_.subscribe(names::kEmergencyStopState, 1, &BehaviorServerNode::handleStop, this,
                         ros::TransportHints().tcpNoDelay());
  diagnostics_.add("behaviours", [this](auto& status) { fillDiagnostics(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  addPort<SpinAction, SpinResult, SpinFeedback>(names::kSpin);
  addPort<BackUpAction, BackUpResult, BackUpFeedback>(names::kBackUp);
  addPort<DriveOnHeadingAction, DriveOnHeadingResult, DriveOnHeadingFeedback>(names::kDriveOnHeading);
  addPort<WaitAction, WaitResult, WaitFeedback>(names::kWait);
  connections_.every(ros::Duration(1.0 / parameters_.behavior.frequency), [this] { tick(); });
  // Again and again, although it is latched: rviz draws it where the robot was at its stamp.
  connections_.every(ros::Duration(kFootprintPeriod), [this] {
    if (footprint_.getNumSubscribers() > 0) publishFootprint();
  });
  publishFootprint();
  connections_.clock().onJump([this] {
    around_.clear();
    put(behavior_.abortByClockJump());
  });
}

void BehaviorServerNode::sayLastWords() {
  if (behavior_.active()) cancel("the server is shut down");
}

template <class Action, class Result, class Feedback>
void BehaviorServerNode::addPort(const char* name) {
  ports_.push_back(std::make_unique<BehaviorActionPort<Action, Result, Feedback>>(
      node_, name, [this](BehaviorPort& port, const BehaviorGoal& goal) { start(port, goal); },
      [this](const std::string& why) { cancel(why); }));
}

void BehaviorServerNode::start(BehaviorPort& port, const BehaviorGoal& goal) {
  cancel("replaced by a newer goal");
  port_ = &port;
  THROTTLED_INFO(toString(goal.kind) << " asked for: " << goal.target);
  put(behavior_.start(goal, rosNow()));
}

void BehaviorServerNode::cancel(const std::string& why) { put(behavior_.cancel(why, rosNow())); }

void BehaviorServerNode::handleStop(const std_msgs::Bool& msg) {
  emergency_stop_ = msg.data != 0;
  if (emergency_stop_) tick();
}

void BehaviorServerNode::tick() {
  if (!behavior_.active()) return;
  const std::optional<Time> now = connections_.clock().now();
  if (!now || !behavior_.active()) return;
  BehaviorInputs inputs = around_.inputs(parameters_.behavior.costmap_timeout, *now);
  inputs.emergency_stop = emergency_stop_;
  put(behavior_.update(inputs, *now));
}

void BehaviorServerNode::publishFootprint() {
  const Time stamp = around_.poseStamp().value_or(Time{});
  const Outline outline = parameters_.behavior.robot.exactOutline();
  footprint_.publish(toPolygonStampedMsg(outline.corners(), around_.frames().base_frame, stamp));
}

void BehaviorServerNode::put(const BehaviorOutput& output) {
  if (!output.command || port_ == nullptr) return;
  cmd_vel_.publish(toTwistMsg(*output.command));
  port_->publishFeedback(output, behavior_.goal());
  if (behavior_.active()) return;
  last_result_ = std::string(toString(behavior_.goal().kind)) + ": " + toString(output.outcome) + ", " + output.message;
  THROTTLED_INFO(last_result_);
  port_->finish(output, behavior_.goal());
  diagnostics_.publish();
}

void BehaviorServerNode::fillDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  status.summary(emergency_stop_ ? Level::WARN : Level::OK,
                 emergency_stop_ ? "emergency stop" : (behavior_.active() ? toString(behavior_.goal().kind) : "ready"));
  status.add("last result", last_result_);
  around_.rejections().report(status);
  for (const auto& port : ports_) port->report(status);
  tf_.report(status);
}

}  // namespace frontier_pilot
