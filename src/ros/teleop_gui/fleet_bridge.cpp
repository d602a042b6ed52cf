#include "ros/teleop_gui/fleet_bridge.h"

#include <ros/console.h>

#include <string_view>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/teleop_gui/operator_views.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostRobots = 50;  // that a window listens to
constexpr const char* kNavigatorNode = "navigator";

/// The name of the robot whose service emergency_stop is `service`; empty where there is none.
std::string robotOf(const std::string& service) {
  constexpr std::string_view kEnd = "/emergency_stop";
  const bool is_stop = service.size() > kEnd.size() && service.size() <= bounds::kMostName && service[0] == '/' &&
                       std::string_view(service).substr(service.size() - kEnd.size()) == kEnd;
  return is_stop && isServiceName(service) ? service.substr(1, service.size() - kEnd.size() - 1) : std::string();
}

/// The robot and the limits that a node of the robot was started with.
struct KnownRobot {
  RobotModel robot;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
  }
};

}  // namespace

FleetBridge::FleetBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters,
                         std::function<bool()> running)
    : parameters_(parameters),
      running_(std::move(running)),
      node_(onQueue(node, queue_)),
      stop_caller_(
          node_, [](teleop::Severity, const std::string& text) { ROS_INFO_STREAM(text); },
          [this](const auto&, bool success, const std::string& message) {
            const std::lock_guard<std::mutex> lock(mutex_);
            stop_answer_ = {stop_answer_.count + 1, success, printable(message, bounds::kMostReason)};
          }),
      watch_(node_, [](const std::string&) {}),
      connections_(node_),
      spinner_(1, &queue_) {
  watch_.watch(names::kFleetEmergencyStop);
  connections_.subscribe(names::kFleetStopStatus, 1, &FleetBridge::handleStopStatus, this);
  spinner_.start();
}

FleetBridge::~FleetBridge() { spinner_.stop(); }

void FleetBridge::handleStopStatus(const FleetStopStatus& msg) {
  std::map<std::string, bool> listed;
  for (const auto& [services, reached] : {std::pair(&msg.not_reached, false), std::pair(&msg.reached, true)}) {
    for (const std::string& service : *services) {
      const std::string name = robotOf(service);
      if (!name.empty() && (listed.size() < kMostRobots || listed.count(name) > 0)) listed[name] = reached;
    }
  }
  for (const auto& [name, reached] : listed) listenTo(name);
  const std::lock_guard<std::mutex> lock(mutex_);
  listed_ = std::move(listed);
}

void FleetBridge::listenTo(const std::string& name) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (heard_.size() >= kMostRobots || !heard_.emplace(name, Robot()).second) return;
  }
  keep(name, names::kArbiterStatus, &Robot::arbiter);
  keep(name, names::kExplorerStatus, &Robot::explorer);
  keep(name, names::kNavigatorProgress, &Robot::navigation);
}

template <class Msg>
void FleetBridge::keep(const std::string& name, const std::string& topic, Latest<Msg> Robot::*latest) {
  const std::string absolute = names::ofRobot("/" + name, topic);
  connections_.subscribe<Msg>(absolute, 1, [this, name, latest](const Msg& msg) {
    if (!isShown(msg)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    (heard_[name].*latest).put(msg, steadyNow());
  });
}

teleop::FleetView FleetBridge::fleet() {
  teleop::FleetView view;
  view.connected = watch_.masterUp();
  view.stop_up = watch_.up(names::kFleetEmergencyStop);
  const SteadyTime now = steadyNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  view.stop_answer = stop_answer_;
  for (const auto& [name, reached] : listed_) {
    const auto robot = heard_.find(name);
    if (robot == heard_.end()) continue;
    teleop::RobotReports reports;
    show(robot->second.arbiter, now, reports.arbiter);
    show(robot->second.explorer, now, reports.explorer);
    show(robot->second.navigation, now, reports.navigation);
    view.robots.push_back(teleop::atAGlance(name, reports, reached));
  }
  return view;
}

/// A robot is described by the parameters of its navigator; what is not found there is the window's own.
teleop::TeleopParameters FleetBridge::parametersOf(const std::string& robot) {
  teleop::TeleopParameters parameters = parameters_;
  if (robot.empty()) return parameters;
  parameters.robot.base_frame = names::ofRobot(robot, parameters_.robot.base_frame);
  connections_.guard().run("the parameters of " + robot, [&] {
    const ParameterMap all = readParameters(ros::NodeHandle("/" + names::ofRobot(robot, kNavigatorNode)));
    ParameterMap known;
    for (const char* group : {"robot", "limits"}) {
      const auto found = all.find(group);
      if (found != all.end()) known.insert(*found);
    }
    KnownRobot described{parameters.robot};
    if (loadParameters(known, described).empty()) parameters.robot = described.robot;
  });
  return parameters;
}

std::unique_ptr<teleop::OperatorLink> FleetBridge::open(const std::string& robot,
                                                        const teleop::TeleopParameters& parameters) {
  const ros::NodeHandle node = robot.empty() ? ros::NodeHandle() : ros::NodeHandle("/" + robot);
  return std::make_unique<GuiBridge>(node, parameters, GuiBridge::Manual::kAlways, running_);
}

void FleetBridge::stopAll() { stop_caller_.insist(names::kFleetEmergencyStop); }

}  // namespace frontier_pilot
