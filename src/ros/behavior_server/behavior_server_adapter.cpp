#include "ros/behavior_server/behavior_server_adapter.h"

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Twist.h>

#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr double kFootprintPeriod = 0.2;  // [s]

}  // namespace

BehaviorServerAdapter::BehaviorServerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      parameters_(loadNodeParameters<BehaviorServerParameters>(private_node)),
      behavior_(parameters_.behavior),
      around_(parameters_.surroundings, parameters_.behavior.robot, parameters_.frames, tf_),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVelBehavior, 10)),
      footprint_(node_.advertise<geometry_msgs::PolygonStamped>(names::kFootprint, 1, true)),
      diagnostics_(node, private_node),
      connections_(node) {
  around_.subscribe(connections_);
  take(parameters_);
  tuning_.emplace(parameters_, connections_, [this](const auto& changed) { take(changed); });
  connections_.followStop(&BehaviorServerAdapter::handleStop, this);
  diagnostics_.add("behaviours", [this](auto& status) { fillDiagnostics(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  addPort<SpinAction, SpinResult, SpinFeedback>(names::kSpin);
  addPort<BackUpAction, BackUpResult, BackUpFeedback>(names::kBackUp);
  addPort<DriveOnHeadingAction, DriveOnHeadingResult, DriveOnHeadingFeedback>(names::kDriveOnHeading);
  addPort<WaitAction, WaitResult, WaitFeedback>(names::kWait);
  connections_.every(ros::Duration(1.0 / parameters_.behavior.frequency), [this] { tick(); });
  // Published repeatedly although it is latched, because rviz draws it where the robot was at its stamp.
  connections_.every(ros::Duration(kFootprintPeriod), [this] {
    if (footprint_.getNumSubscribers() > 0) publishFootprint();
  });
  publishFootprint();
  connections_.clock().onJump([this] {
    around_.clear();
    put(behavior_.abortByClockJump());
  });
}

void BehaviorServerAdapter::take(const BehaviorServerParameters& changed) {
  behavior_.setParameters(changed.behavior);
  around_.setReach(changed.behavior.reach());
}

void BehaviorServerAdapter::sayLastWords() {
  if (behavior_.active()) cancel("the server is shut down");
}

template <class Action, class Result, class Feedback>
void BehaviorServerAdapter::addPort(const char* name) {
  ports_.push_back(std::make_unique<BehaviorActionPort<Action, Result, Feedback>>(
      node_, name, [this](BehaviorPort& port, const behavior::BehaviorGoal& goal) { start(port, goal); },
      [this](const std::string& why) { cancel(why); }));
}

void BehaviorServerAdapter::start(BehaviorPort& port, const behavior::BehaviorGoal& goal) {
  cancel("replaced by a newer goal");
  port_ = &port;
  THROTTLED_INFO(toString(goal.kind) << " requested: " << goal.target);
  put(behavior_.start(goal, rosNow()));
}

void BehaviorServerAdapter::cancel(const std::string& why) { put(behavior_.cancel(why, rosNow())); }

void BehaviorServerAdapter::handleStop(const std_msgs::Bool& msg) {
  emergency_stop_ = msg.data != 0;
  if (emergency_stop_) step(connections_.clock().now().value_or(rosNow()));  // also by a clock that just jumped
}

void BehaviorServerAdapter::tick() {
  const std::optional<Time> now = connections_.clock().now();
  if (!connections_.clock().isCatchingUp()) return step(now);
  if (behavior_.active()) cmd_vel_.publish(geometry_msgs::Twist());
}

void BehaviorServerAdapter::step(const std::optional<Time>& now) {
  if (!now || !behavior_.active()) return;
  behavior::BehaviorInputs inputs = around_.inputs(parameters_.behavior.costmap_timeout, *now);
  inputs.emergency_stop = emergency_stop_;
  put(behavior_.update(inputs, *now));
}

void BehaviorServerAdapter::publishFootprint() {
  const Time stamp = around_.poseStamp().value_or(Time{});
  const Outline outline = parameters_.behavior.robot.exactOutline();
  footprint_.publish(toPolygonStampedMsg(outline.corners(), around_.frames().base_frame, stamp));
}

void BehaviorServerAdapter::put(const behavior::BehaviorOutput& output) {
  if (!output.command || port_ == nullptr) return;
  cmd_vel_.publish(toTwistMsg(*output.command));
  port_->publishFeedback(output, behavior_.goal());
  if (behavior_.active()) return;
  last_result_ = std::string(toString(behavior_.goal().kind)) + ": " + toString(output.outcome) + ", " + output.message;
  THROTTLED_INFO(last_result_);
  port_->finish(output, behavior_.goal());
  diagnostics_.publish();
}

void BehaviorServerAdapter::fillDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  status.summary(emergency_stop_ ? Level::WARN : Level::OK,
                 emergency_stop_ ? "emergency stop" : (behavior_.active() ? toString(behavior_.goal().kind) : "ready"));
  status.add("last result", last_result_);
  around_.report(status);
  for (const auto& port : ports_) port->report(status);
  tf_.report(status);
}

}  // namespace frontier_pilot
