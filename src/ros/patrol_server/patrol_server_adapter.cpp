#include "ros/patrol_server/patrol_server_adapter.h"

#include <geometry_msgs/Twist.h>

#include "ros/common/inputs/arbiter_source.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/odometry_source.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
PatrolServerAdapter::PatrolServerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      parameters_(loadNodeParameters<PatrolServerParameters>(private_node)),
      patrol_(parameters_.patrol),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVelPatrol, 10)),
      server_(
          node_, names::kPatrol, [this](const PatrolGoal& goal) { handleGoal(goal); },
          [this](const std::string&) { put(patrol_.cancel()); }),
      diagnostics_(node, private_node),
      surroundings_(parameters_.surroundings, parameters_.patrol.robot, tf_),
      connections_(node) {
  subscribe();
  surroundings_.lookAheadFor(parameters_.patrol);
  tuning_.emplace(parameters_, connections_, [this](const auto& changed) {
    patrol_.setParameters(changed.patrol);
    surroundings_.lookAheadFor(changed.patrol);
  });
  diagnostics_.add("patrol", [this](auto& status) { fillDiagnostics(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  connections_.every(ros::Duration(1.0 / parameters_.patrol.frequency), [this] { tick(); });
  connections_.clock().onJump([this] {
    inputs_.odometry.reset();
    surroundings_.clear();
    put(patrol_.abortByClockJump());
  });
}

void PatrolServerAdapter::sayLastWords() {
  if (patrol_.active()) put(patrol_.cancel());
}

void PatrolServerAdapter::subscribe() {
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  const RobotModel& robot = parameters_.patrol.robot;
  surroundings_.subscribe(connections_);
  followOdometry(connections_, tf_, robot, robot.base_frame, 1, &PatrolServerAdapter::handleOdometry, this, hints);
  connections_.followStop(&PatrolServerAdapter::handleStop, this);
  connections_.subscribe(names::kArbiterStatus, 1, &PatrolServerAdapter::handleArbiter, this, hints);
}

void PatrolServerAdapter::handleGoal(const PatrolGoal& msg) {
  // The action server has already ended a patrol that was active.
  const patrol::PatrolOrder order{msg.goal.x, msg.goal.y, msg.goal.z};
  THROTTLED_INFO("patrol requested: mode " << order.mode << ", size " << order.size << " m, " << order.laps << " laps");
  if (surroundings_.isBlind()) THROTTLED_WARN("nobody publishes a scan: the patrol is driven without looking ahead");
  put(patrol_.start(order, rosNow()));
}

void PatrolServerAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  std::string why;
  const std::optional<MotionSample> odometry = toOdometry(msg, &why);
  if (!odometry) {
    bad_odometry_.add(why);
    inputs_.odometry_problem = why;
    return tick();
  }
  inputs_.odometry_problem.reset();
  // Stamped with the time of arrival, so that a small offset of the base's clock does not stop the patrol. A message
  // that comes again is as old as it was; a base that sets no stamps has only the arrival, also for the look ahead.
  const bool has_stamp = odometry->stamp != Time{};
  const bool is_repeat = inputs_.odometry && odometry->stamp == odometry_stamp_ && has_stamp;
  const Time arrival = is_repeat ? inputs_.odometry->stamp : rosNow();
  surroundings_.addOdometry(has_stamp ? odometry->stamp : arrival, odometry->T_odom_base);
  odometry_stamp_ = odometry->stamp;
  inputs_.odometry = MotionSample{arrival, odometry->T_odom_base, odometry->twist};
}

void PatrolServerAdapter::handleStop(const std_msgs::Bool& msg) {
  inputs_.emergency_stop = msg.data != 0;
  if (inputs_.emergency_stop) step(connections_.clock().now().value_or(rosNow()));  // also by a clock that just jumped
}

void PatrolServerAdapter::handleArbiter(const ArbiterStatus& msg) {
  wheels_held_by_.put(findOtherDriver(msg, cmd_vel_.getTopic(), parameters_.source), steadyNow());
}

void PatrolServerAdapter::tick() {
  const std::optional<Time> now = connections_.clock().now();
  if (!connections_.clock().isCatchingUp()) return step(now);
  if (patrol_.active()) cmd_vel_.publish(geometry_msgs::Twist());
}

void PatrolServerAdapter::step(const std::optional<Time>& now) {
  if (!now) return;
  inputs_.wheels_held_by = wheels_held_by_.fresh(steadyNow(), kArbiterPatience).value_or(std::nullopt);
  inputs_.is_connecting = surroundings_.isConnecting();
  inputs_.way_ahead = surroundings_.wayAhead(*now);
  put(patrol_.update(inputs_, *now));
}

void PatrolServerAdapter::put(const patrol::PatrolOutput& output) {
  if (output.command) cmd_vel_.publish(toTwistMsg(*output.command));
  if (output.started_leg) {
    PatrolFeedback feedback;
    feedback.state = "line " + std::to_string(*output.started_leg);
    server_.publishFeedback(feedback);
  }
  if (output.command && !patrol_.active()) finish(output);
}

void PatrolServerAdapter::finish(const patrol::PatrolOutput& output) {
  last_text_ = output.text;
  PatrolResult result;
  result.result = output.text;
  if (output.outcome == patrol::PatrolOutcome::kCompleted) {
    server_.setSucceeded(result, output.text);
  } else if (output.outcome == patrol::PatrolOutcome::kCanceled) {
    server_.setPreempted(result, output.text);
  } else {
    server_.setAborted(result, output.text);
  }
  THROTTLED_INFO(output.text);
  diagnostics_.publish();
}

void PatrolServerAdapter::fillDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const bool no_odometry = !inputs_.odometry || toSeconds(rosNow() - inputs_.odometry->stamp) > 1.0;
  if (inputs_.emergency_stop) {
    status.summary(Level::WARN, "emergency stop");
  } else if (no_odometry) {
    status.summary(Level::WARN, "no odometry");
  } else if (surroundings_.isBlind()) {
    status.summary(Level::WARN, "no scan: patrols are driven without looking ahead");
  } else {
    status.summary(Level::OK, patrol_.active() ? "patrolling" : "ready");
  }
  status.add("last result", last_text_);
  status.add("wheels held by", inputs_.wheels_held_by.value_or("nobody else"));
  surroundings_.report(status);
  bad_odometry_.report(status);
  server_.report(status);
}

}  // namespace frontier_pilot
