#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"

#include <geometry_msgs/Twist.h>

#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/odometry_source.h"
#include "ros/common/throttled_log.h"
#include "ros/obstacle_avoider/avoider_report.h"

namespace frontier_pilot {
namespace {

constexpr const char* kSafeState = "avoider_enabled";
constexpr double kTick = 0.1;     // [s], the heartbeat
constexpr double kUpdate = 0.02;  // [s], so that reversing and turning end on time between two heartbeats

/// A hold is zero for a wheeled base, which ignores the z axis, but not an all-zero message to the arbiter.
geometry_msgs::Twist toCommandMsg(const avoid::AvoiderCommand& command) {
  geometry_msgs::Twist msg = toTwistMsg(command.twist);
  if (command.hold) msg.linear.z = 1e-9;
  return msg;
}

}  // namespace

ObstacleAvoiderAdapter::ObstacleAvoiderAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : node_(node),
      parameters_(loadNodeParameters<ObstacleAvoiderNodeParameters>(private_node)),
      base_frame_(parameters_.avoider.robot.baseFrameOr(parameters_.base_frame)),
      avoider_(parameters_.avoider),
      cmd_vel_(node_.advertise<geometry_msgs::Twist>(names::kCmdVelAvoid, 1)),
      status_(node_.advertise<AvoiderStatus>(names::kAvoiderStatus, 1, true)),
      diagnostics_(node, private_node),
      connections_(node) {
  switched_on_.emplace(kSafeState, names::kSetObstacleAvoidEnabled, connections_);
  if (!switched_on_->wasLeftSafe().value_or(parameters_.enabled)) avoider_.setEnabled(false, rosNow());
  tuning_.emplace(parameters_, connections_, [this](const auto& changed) { avoider_.setParameters(changed.avoider); });
  connections_.serve(names::kSetObstacleAvoidEnabled, &ObstacleAvoiderAdapter::handleEnable, this);
  connections_.subscribeToScanner(tf_, base_frame_, 1, &ObstacleAvoiderAdapter::handleScan, this,
                                  ros::TransportHints().tcpNoDelay());
  followOdometry(connections_, tf_, parameters_.avoider.robot, base_frame_, 20, &ObstacleAvoiderAdapter::handleOdometry,
                 this, ros::TransportHints().tcpNoDelay(), Need::kOptional);
  connections_.clock().onJump([this] { placer_.clear(); });
  followStops();
  diagnostics_.add("obstacle avoidance", [this](auto& status) {
    fillDiagnostics(avoider_.status(rosNow()), status);
    scan_motion_.report(status);
    rejections_.report(status);
    bad_odometry_.report(status);
    tf_.report(status);
  });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  diagnostics_.add("memory", [this](auto& status) { connections_.memory().report(status); });
  // Both in ROS time, so that the heartbeat stays within the arbiter's timeout at any speed of a simulation.
  connections_.every(ros::Duration(kTick), [this] { tick(); });
  connections_.every(ros::Duration(kUpdate), [this] { publish(avoider_.update(rosNow())); });
  connections_.everySteady(ros::WallDuration(1.0), [this] { publishStatus(true); });
  publishStatus(true);
}

void ObstacleAvoiderAdapter::sayLastWords() {
  publish(avoider_.setEnabled(false, rosNow()));
  switched_on_->end();
}

void ObstacleAvoiderAdapter::handleScan(const sensor_msgs::LaserScan& msg) {
  std::string why;
  const std::optional<LaserScan2> scan = read(msg, &why);
  if (!scan) rejections_.add(why);
  publish(scan ? avoider_.onScan(*scan, rosNow()) : avoider_.onBadScan(why, rosNow()));
  publishStatus(false);
}

void ObstacleAvoiderAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  std::string why;
  const auto odometry = toOdometry(msg, &why);
  if (!odometry) return bad_odometry_.add(why);
  placer_.addOdometry(odometry->stamp, odometry->T_odom_base);
}

std::optional<LaserScan2> ObstacleAvoiderAdapter::read(const sensor_msgs::LaserScan& msg, std::string* why) {
  // The latest transform, not the one at the scan's stamp: the mount does not move, but its publisher may be late.
  const auto T_base_sensor = tf_.lookup3d(base_frame_, msg.header.frame_id, Time{}, Duration::zero(), why);
  auto scan = T_base_sensor ? toLaserScan(msg, *T_base_sensor, why) : std::nullopt;
  if (!scan || scan_motion_.place(placer_, *scan)) return scan;
  *why = kFrozenScan;
  return std::nullopt;
}

bool ObstacleAvoiderAdapter::handleEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  const bool on = request.data != 0;
  const bool changes = on != avoider_.enabled();
  publish(avoider_.setEnabled(on, rosNow()));
  const std::string problem = switched_on_->set(on);
  publishStatus(false);
  response.success = 1;
  response.message = std::string("obstacle avoider ") + (on ? "enabled" : "disabled");
  if (!changes) response.message += " already: nothing changed";
  response.message += problem;
  return true;
}

void ObstacleAvoiderAdapter::tick() {
  publish(avoider_.tick(rosNow()));
  publishStatus(false);
}

/// After a hold-up the robot is held until what came meanwhile was read, a stop and its clear among it perhaps. [FLT-2]
void ObstacleAvoiderAdapter::publish(const std::optional<avoid::AvoiderCommand>& command) {
  if (!command) return;
  connections_.clock().now();  // notices a hold-up
  const bool waits = !command->twist.isZero() && connections_.clock().isCatchingUp();
  cmd_vel_.publish(toCommandMsg(waits ? avoid::AvoiderCommand{{}, true} : *command));
}

void ObstacleAvoiderAdapter::publishStatus(bool always) {
  const avoid::AvoiderSnapshot snapshot = avoider_.status(rosNow());
  const std::string summary = summarize(snapshot);
  const bool changed = summary != last_summary_;
  last_summary_ = summary;
  if (changed || always) status_.publish(toStatusMsg(snapshot));
  if (!changed) return;
  THROTTLED_INFO(summary);
  diagnostics_.publish();
}

}  // namespace frontier_pilot
