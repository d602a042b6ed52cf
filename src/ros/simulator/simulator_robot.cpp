#include "ros/simulator/simulator_robot.h"

#include <std_msgs/Bool.h>

#include <algorithm>
#include <vector>

#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

// From the URDF of the TurtleBot3 Burger [m].
constexpr double kBaseLinkHeight = 0.010;
constexpr double kScannerHeight = 0.172;

}  // namespace

SimulatorRobot::SimulatorRobot(const ros::NodeHandle& node, NodeConnections& connections, TfBridge& tf,
                               sim::Simulator& simulator, std::size_t index, const RobotModel& model)
    : tf_(tf),
      simulator_(simulator),
      index_(index),
      base_frame_(simulator.name(index).empty() ? model.base_frame : frame(names::kBaseFootprintFrame)),
      odom_frame_(simulator.name(index).empty() ? model.odom_frame : frame(names::kOdomFrame)),
      scan_time_(1.0 / model.scanner.rate),
      command_topic_(names::ofRobot(simulator.name(index), names::kCmdVel)),
      rejections_(command_topic_) {
  ros::NodeHandle robot(node, simulator.name(index));
  odometry_ = robot.advertise<nav_msgs::Odometry>(names::kOdom, 50);
  truth_ = robot.advertise<nav_msgs::Odometry>(names::kGroundTruth, 50);
  scan_ = robot.advertise<sensor_msgs::LaserScan>(names::kScan, 10);
  stalled_topic_ = robot.advertise<std_msgs::Bool>(names::kStalled, 50);
  connections.subscribe(command_topic_, 10, &SimulatorRobot::handleCommand, this, ros::TransportHints().tcpNoDelay());
  publishStaticFrames(model);
}

std::string SimulatorRobot::frame(const std::string& name) const {
  return names::ofRobot(simulator_.name(index_), name);
}

// If the robot's base frame is `base_link` itself, there is no separate frame on the floor.
void SimulatorRobot::publishStaticFrames(const RobotModel& model) {
  const std::string base_link = frame(names::kBaseLinkFrame);
  if (base_frame_ != base_link) tf_.broadcastStatic(base_frame_, base_link, {}, kBaseLinkHeight);
  tf_.broadcastStatic(base_link, frame(names::kBaseScanFrame), model.scanner.T_base_sensor(), kScannerHeight);
}

void SimulatorRobot::handleCommand(const geometry_msgs::Twist& msg) {
  std::string why;
  const std::optional<Twist2> twist = toTwist(msg, &why);
  if (!twist) return rejections_.add(why);
  simulator_.setCommand(index_, *twist);
}

FramePose SimulatorRobot::odometryPose() const { return {odom_frame_, base_frame_, simulator_.odometry(index_)}; }

void SimulatorRobot::publishState() {
  const Time now = simulator_.now();
  const Pose2& odometry = simulator_.odometry(index_);
  const Twist2& twist = simulator_.velocity(index_);
  odometry_.publish(toOdometryMsg({now, odometry, twist}, odom_frame_, base_frame_));
  truth_.publish(toOdometryMsg({now, simulator_.pose(index_), twist}, names::kWorldFrame, base_frame_));
  publishStalled();
}

void SimulatorRobot::publishNews() {
  if (simulator_.stalled(index_) != stalled_) publishStalled();
  const LaserScan2* scan = simulator_.newScan(index_);
  if (scan != nullptr) scan_.publish(toLaserScanMsg(*scan, frame(names::kBaseScanFrame), scan_time_));
}

void SimulatorRobot::publishStalled() {
  stalled_ = simulator_.stalled(index_);
  std_msgs::Bool msg;
  msg.data = stalled_;
  stalled_topic_.publish(msg);
}

void SimulatorRobot::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const std::string& name = simulator_.name(index_);
  status.add(name.empty() ? "contacts" : name + ": contacts", simulator_.contactCount(index_));
  rejections_.report(status);
}

bool newScans(const std::list<SimulatorRobot>& robots) {
  return std::any_of(robots.begin(), robots.end(), [](const SimulatorRobot& robot) { return robot.hasNewScan(); });
}

void publishStates(std::list<SimulatorRobot>& robots, TfBridge& tf, Time now) {
  std::vector<FramePose> poses;
  for (const SimulatorRobot& robot : robots) poses.push_back(robot.odometryPose());
  tf.broadcast(poses, now);
  for (SimulatorRobot& robot : robots) robot.publishState();
}

}  // namespace frontier_pilot
