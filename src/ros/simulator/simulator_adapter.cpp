#include "ros/simulator/simulator_adapter.h"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>

#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kSlice = std::chrono::milliseconds(10);        // of steps, before commands and calls are read again
constexpr Duration kClockPeriod = std::chrono::milliseconds(20);  // not each step: /clock wakes every node

ros::WallDuration tickPeriod(double speed) {
  return ros::WallDuration(speed > 0.0 ? std::clamp(toSeconds(sim::Simulator::kStep) / speed, 0.001, 0.01) : 0.001);
}

template <class Response>
bool answer(Response& response, sim::Placement placement) {
  response.success = placement == sim::Placement::kDone;
  response.message = sim::toString(placement);
  return true;
}

Pose2 pose(const geometry_msgs::Pose2D& msg) { return {msg.x, msg.y, msg.theta}; }

}  // namespace

SimulatorAdapter::SimulatorAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<SimulatorNodeParameters>(private_node)),
      simulator_(sim::loadWorld(parameters_.world), parameters_),
      pace_(parameters_.speed, sim::Simulator::kStep),
      state_period_(fromSeconds(1.0 / parameters_.state_rate)),
      diagnostics_(node, private_node),
      connections_(node) {
  // As in stage_ros: nodes that start later use /clock. A launch file sets it before the first node starts.
  ros::param::set("/use_sim_time", true);
  if (simulator_.startWasChosen()) {
    const Pose2& start = simulator_.startPose(0);
    ROS_INFO_STREAM(
        "neither the world (start:) nor x and y say where the robot starts: it starts at the free place "
        "nearest to the middle of the world, x "
        << start.x << ", y " << start.y);
  }
  advertise(node);
  publishWorld();
  for (std::size_t i = 0; i < simulator_.robotCount(); ++i) {
    robots_.emplace_back(node, connections_, tf_, simulator_, i, simulator_.model(i));
    const std::string map_frame = names::ofRobot(parameters_.common_map ? "" : simulator_.name(i), names::kMapFrame);
    if (!parameters_.common_map || i == 0) {
      tf_.broadcastStatic(names::kWorldFrame, map_frame, simulator_.startPose(i));
    }
  }
  diagnostics_.add("simulation", [this](auto& status) { report(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  connections_.everySteady(tickPeriod(parameters_.speed), [this] { tick(); });
}

void SimulatorAdapter::advertise(ros::NodeHandle& node) {
  clock_ = node.advertise<rosgraph_msgs::Clock>(names::kClock, 100, true);
  world_ = node.advertise<nav_msgs::OccupancyGrid>(names::kWorld, 1, true);
  connections_.serve(names::kResetPositions, &SimulatorAdapter::resetPositions, this);
  connections_.serve(names::kSetPose, &SimulatorAdapter::setPose, this);
  connections_.serve(names::kSpawnObstacle, &SimulatorAdapter::spawnObstacle, this);
  connections_.serve(names::kRemoveObstacle, &SimulatorAdapter::removeObstacle, this);
  connections_.serve(names::kPauseSimulator, &SimulatorAdapter::pause, this);
}

void SimulatorAdapter::publishWorld() {
  if (!world_) return;  // ROS was shut down while the node was being built
  world_.publish(toOccupancyGridMsg(simulator_.map(), names::kWorldFrame, simulator_.now()));
}

void SimulatorAdapter::tick() {
  if (paused_) return;
  const SteadyTime end = steadyNow() + kSlice;
  for (std::int64_t due = pace_.due(steadyNow()); due > 0 && steadyNow() < end; --due) step();
}

void SimulatorAdapter::step() {
  simulator_.step();
  pace_.stepped();
  const bool state_due = simulator_.now() >= next_state_;
  if (state_due || newScans(robots_) || simulator_.now() - clock_published_ >= kClockPeriod) publishClock();
  if (state_due) {
    next_state_ = std::max(next_state_ + state_period_, simulator_.now());
    publishStates(robots_, tf_, simulator_.now());
  }
  for (SimulatorRobot& robot : robots_) robot.publishNews();
}

void SimulatorAdapter::publishClock() {
  clock_published_ = simulator_.now();
  rosgraph_msgs::Clock msg;
  msg.clock = toRosTime(clock_published_);
  clock_.publish(msg);
}

bool SimulatorAdapter::resetPositions(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  for (const std::string& name : simulator_.resetPositions()) {
    THROTTLED_WARN("reset_positions: robot '" << name
                                              << "' stays where it is: an obstacle or another robot is at its start");
  }
  return true;
}

bool SimulatorAdapter::setPose(SetPose::Request& request, SetPose::Response& response) {
  return answer(response, simulator_.setPose(request.robot, pose(request.pose)));
}

bool SimulatorAdapter::spawnObstacle(SpawnObstacle::Request& request, SpawnObstacle::Response& response) {
  return answer(response, simulator_.spawnObstacle(request.name, pose(request.pose), request.radius));
}

bool SimulatorAdapter::removeObstacle(RemoveObstacle::Request& request, RemoveObstacle::Response& response) {
  return answer(response, simulator_.removeObstacle(request.name));
}

bool SimulatorAdapter::pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  response.success = true;
  response.message = paused_ == static_cast<bool>(request.data) ? "unchanged: " : "now ";
  response.message += request.data ? "paused" : "running";
  paused_ = request.data;
  pace_.rest();
  diagnostics_.publish();
  return true;
}

void SimulatorAdapter::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const SteadyTime now = steadyNow();
  const double real = std::max(1e-3, toSeconds(now - reported_real_));
  bool touches = false;
  for (std::size_t i = 0; i < simulator_.robotCount(); ++i) touches = touches || simulator_.stalled(i);
  status.summary(paused_ || touches ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
                 paused_ ? "paused" : (touches ? "a robot touches something" : "running"));
  status.addf("simulated time", "%.2f s", toSeconds(simulator_.now()));
  status.addf("simulated over real time", "%.2f", toSeconds(simulator_.now() - reported_sim_) / real);
  status.add("times behind the requested speed", pace_.timesBehind());
  for (const SimulatorRobot& robot : robots_) robot.report(status);
  reported_sim_ = simulator_.now();
  reported_real_ = now;
}

}  // namespace frontier_pilot
