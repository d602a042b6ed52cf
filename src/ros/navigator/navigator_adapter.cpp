#include "ros/navigator/navigator_adapter.h"

#include <geometry_msgs/Twist.h>

#include <cmath>
#include <utility>

#include "frontier_pilot/system/behavior_ladder.h"
#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/odometry_source.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

NavigatorAdapter::NavigatorAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<NavigatorNodeParameters>(private_node)),
      base_frame_(parameters_.robot.baseFrameOr(parameters_.base_frame)),
      navigator_(parameters_, system::behaviorLadder(parameters_, parameters_.rate)),
      server_(node, tf_, parameters_.map_frame, parameters_.use_goal_yaw),
      motions_(parameters_.fleet, parameters_.map_frame, parameters_.robot.drivenOutline().circumscribedRadius(), tf_),
      publisher_(node, parameters_.map_frame, parameters_.robot.limits.max_linear),
      diagnostics_(node, private_node),
      connections_(node) {
  command_ = node.advertise<geometry_msgs::Twist>(names::kCmdVelNav, 1);
  diagnostics_.add("navigation", [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  map_.subscribe(connections_, parameters_.map_frame);
  server_.subscribe(connections_);
  motions_.connect(connections_, node, diagnostics_);
  connections_.subscribeToScanner(tf_, base_frame_, 1, &NavigatorAdapter::handleScan, this);
  connections_.needPoseIn(parameters_.map_frame, "map_frame", tf_, base_frame_);
  localization_.subscribe(connections_);
  followOdometry(connections_, tf_, parameters_.robot, base_frame_, 20, &NavigatorAdapter::handleOdometry, this);
  connections_.followStop(&NavigatorAdapter::handleStop, this);
  tuning_.emplace(parameters_, connections_, [this](const auto& changed) { take(changed); });
  connections_.serve(names::kMakePlan, &NavigatorAdapter::handlePlan, this);
  connections_.serve(names::kClearCostmaps, &NavigatorAdapter::handleClear, this);
  connections_.every(ros::Duration(1.0 / parameters_.rate), [this] {
    const auto now = connections_.clock().now();
    if (now && !connections_.clock().isCatchingUp()) return tick(*now);
    if (navigator_.hasGoal()) command_.publish(toTwistMsg({}));
  });
  connections_.clock().onJump([this] {  // the goal stays
    scan_.reset();
    placer_.clear();
    if (navigator_.hasGoal()) command_.publish(toTwistMsg({}));
  });
}

void NavigatorAdapter::sayLastWords() {
  if (navigator_.hasGoal()) command_.publish(toTwistMsg({}));
}

void NavigatorAdapter::handleScan(const sensor_msgs::LaserScan& msg) {
  std::string why;
  const auto T_base_sensor = tf_.lookup3d(base_frame_, msg.header.frame_id, Time{}, Duration::zero(), &why);
  if (!T_base_sensor) return bad_scans_.addWaiting(why);
  auto scan = toLaserScan(msg, *T_base_sensor, &why);
  if (!scan) return bad_scans_.add(why);
  if (!scan_motion_.place(placer_, *scan)) return bad_scans_.add(kFrozenScan);
  scan_ = std::move(scan);
}

void NavigatorAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  std::string why;
  const auto odometry = toOdometry(msg, &why);
  if (!odometry) return bad_odometry_.add(why);
  twist_.put(odometry->twist, steadyNow());
  placer_.addOdometry(odometry->stamp, odometry->T_odom_base);
}

void NavigatorAdapter::handleStop(const std_msgs::Bool& msg) { server_.setStopped(msg.data != 0); }

std::optional<StampedPose2> NavigatorAdapter::pose() const {
  const auto stamp = tf_.latestStamp(parameters_.map_frame, base_frame_);
  if (!stamp) return std::nullopt;
  const auto T_map_base = tf_.lookup(parameters_.map_frame, base_frame_, *stamp);
  return T_map_base ? std::make_optional(StampedPose2{*stamp, *T_map_base}) : std::nullopt;
}

std::optional<Vec2> NavigatorAdapter::positionNow() const {
  const auto now = pose();
  return now ? std::optional<Vec2>(now->pose.position()) : std::nullopt;
}

void NavigatorAdapter::takeMap() {
  const CellRect changed = map_.takeChanged();
  if (!changed.empty()) navigator_.setMap(map_.map(), changed);
  if (map_.takeReplaced()) server_.endForReplacedMap();
}

navigation::NavigatorInputs NavigatorAdapter::gather(Time now) {
  takeMap();
  navigation::NavigatorInputs inputs;
  inputs.pose = pose();
  inputs.scan = scan_ ? &*scan_ : nullptr;
  inputs.map_alive = map_.published() || !parameters_.map_must_live;
  inputs.localized = localization_.isLocalizedAt(inputs.pose);
  inputs.twist = twist_.fresh(steadyNow(), fromSeconds(parameters_.max_age)).value_or(Twist2{});
  server_.fill(inputs);
  const bool knows_where =
      inputs.localized && inputs.pose && std::abs(toSeconds(now - inputs.pose->stamp)) <= parameters_.max_age;
  if (knows_where) {
    inputs.order = motions_.order(navigator_, inputs.pose->pose, server_.goal(), map_.map(), now);
  } else {
    motions_.forget();
  }
  return inputs;
}

void NavigatorAdapter::tick(Time now) {
  navigation::NavigatorInputs inputs;
  navigation::NavigatorOutput output;
  try {
    inputs = gather(now);
    output = pursue(inputs, now);
  } catch (...) {
    // Neither the last command stays in force nor a goal without an end: it would be thrown again in each tick. [FLT-1]
    if (navigator_.hasGoal() || server_.goal()) command_.publish(toTwistMsg({}));
    server_.abortAll(toString(navigation::NavReason::kInternalError));
    throw;
  }
  const auto T_map_base = inputs.pose ? std::make_optional(inputs.pose->pose) : std::nullopt;
  if (T_map_base) server_.feedback(*T_map_base, inputs.pose->stamp);
  publisher_.publish(navigator_, output, server_.goal(), T_map_base, now);
}

navigation::NavigatorOutput NavigatorAdapter::pursue(const navigation::NavigatorInputs& inputs, Time now) {
  navigation::NavigatorOutput output = navigator_.update(inputs, now);
  state_ = output.state;
  motions_.note(output);
  // The zero is published before the result is sent to the client. [NAV-1]
  if (output.command) command_.publish(toTwistMsg(mustStand() ? Twist2{} : *output.command));
  for (const navigation::NavFinished& finished : output.finished) {
    failure_ = finished.result == navigation::NavResult::kAborted ? toString(finished.reason) : "";
    server_.settle(finished);
  }
  return output;
}

/// Whether nothing but a zero may be sent: while the stop is latched, and after a tick that took so long that a stop
/// and its clear may have come meanwhile, which nobody has read yet. [ARB-8] [FLT-2]
bool NavigatorAdapter::mustStand() {
  return server_.isStopped() || !connections_.clock().now() || connections_.clock().isCatchingUp();
}

}  // namespace frontier_pilot
