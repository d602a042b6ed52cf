#include "ros/teleop_gui/fleet_bridge.h"

#include <ros/init.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"
#include "ros/fleet_stop/stop_answer.h"
#include "ros/teleop_gui/operator_views.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostRobots = 50;  // that a window listens to
constexpr const char* kRoot = "/";       // as fleet_stop calls a robot without a namespace
// A stop that was pressed is asked for again and again for ten seconds, also when another robot is shown by then.
constexpr Duration kRetirement = std::chrono::seconds(12);
constexpr Duration kHeard = std::chrono::seconds(3);  // fleet_stop reports once a second
constexpr Duration kNews = std::chrono::seconds(10);  // after that a robot that was stopped may have been cleared
/// For the answer to a stop of all robots: fleet_stop waits for theirs for as long as its `patience`, which is at most
/// three seconds.
constexpr Duration kFleetPatience = std::chrono::seconds(5);
constexpr Duration kRobotPatience = std::chrono::milliseconds(1500);

/// The absolute name of what belongs to a robot.
std::string absolute(const std::string& robot, const std::string& name) {
  return robot == kRoot ? "/" + name : "/" + names::ofRobot(robot, name);
}

/// A robot's names as its navigator has them: one with a name in the fleet plans on the map that map_merger makes for
/// it. [MUL-1]
ros::NodeHandle nodeOf(const std::string& robot) {
  const auto fleet_name = ros::NodeHandle(absolute(robot, names::kNavigatorNode)).param<std::string>("fleet/name", "");
  ros::M_string remappings;
  if (!fleet_name.empty())
    remappings = {{names::kMap, names::kMergedMap}, {names::kMapUpdates, names::kMergedMapUpdates}};
  return {robot == kRoot ? robot : "/" + robot, remappings};
}

/// A robot as its navigator was told.
struct DescribedRobot {
  RobotModel robot;
  std::string base_frame;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.field("base_frame", base_frame, "", "", FrameName::kMayBeEmpty);
  }
};

}  // namespace

FleetBridge::FleetBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters,
                         std::function<bool()> running)
    : parameters_(parameters),
      running_(std::move(running)),
      own_node_(node),
      node_(onQueue(node, queue_)),
      stop_caller_(node_, logForOperator,
                   [this](const auto&, bool success, const std::string& message) { showAnswer(success, message); }),
      robot_stop_caller_(node_, logForOperator,
                         [this](const auto& service, bool success, const std::string& message) {
                           showAnswer(success, service + ": " + message);
                         }),
      watch_(node_, [](const std::string&) {}),
      connections_(node_),
      spinner_(1, &queue_) {
  watch_.watch(names::kFleetEmergencyStop);
  connections_.subscribe(names::kFleetStopStatus, 1, &FleetBridge::handleStopStatus, this);
  spinner_.start();
}

/// A robot that is being opened may wait for a master that is gone: only the end of ROS ends that.
FleetBridge::~FleetBridge() {
  for (ServiceCaller* caller : {&stop_caller_, &robot_stop_caller_}) caller->finishInsisting(running_);
  if (!opener_.idle()) ros::requestShutdown();
  spinner_.stop();
}

void FleetBridge::handleStopStatus(const FleetStopStatus& msg) {
  if (!isShown(msg)) return;
  std::map<std::string, bool> listed;
  for (const auto& [services, reached] : {std::pair(&msg.not_reached, false), std::pair(&msg.reached, true)}) {
    for (const std::string& service : *services) {
      if (service.size() <= bounds::kMostName && isServiceName(service)) listed[robotOf(service)] = reached;
    }
  }
  makeRoom(listed);
  for (const auto& [name, reached] : listed) listenTo(name);
  const std::lock_guard<std::mutex> lock(mutex_);
  listed_ = std::move(listed);
  listed_at_ = steadyNow();
}

/// fleet_stop lists a robot until an hour after it was seen last. As long as there is room the window goes on listening
/// to those that it no longer lists, also because a fleet_stop that has just been started lists few.
void FleetBridge::makeRoom(const std::map<std::string, bool>& listed) {
  const auto is_new = [this](const auto& robot) { return topics_.count(robot.first) == 0; };
  const auto more = static_cast<std::size_t>(std::count_if(listed.begin(), listed.end(), is_new));
  if (topics_.size() + more <= kMostRobots) return;
  for (auto robot = topics_.begin(); robot != topics_.end();) {
    if (listed.count(robot->first) > 0) {
      ++robot;
      continue;
    }
    for (ros::Subscriber& topic : robot->second) topic.shutdown();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      heard_.erase(robot->first);
    }
    robot = topics_.erase(robot);
  }
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
  const auto handle = [this, name, latest](const Msg& msg) {
    if (!isShown(msg)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    (heard_[name].*latest).put(msg, steadyNow());
  };
  topics_[name].push_back(connections_.subscribe<Msg>(absolute(name, topic), 1, handle));
}

teleop::RobotView FleetBridge::viewOf(const std::string& name, bool reached, SteadyTime now) const {
  const auto robot = heard_.find(name);
  if (robot == heard_.end()) return {name, teleop::Severity::kWarning, "not watched: there are too many robots"};
  teleop::RobotReports reports;
  show(robot->second.arbiter, now, reports.arbiter);
  show(robot->second.explorer, now, reports.explorer);
  show(robot->second.navigation, now, reports.navigation);
  return teleop::atAGlance(name, reports, reached);
}

teleop::FleetView FleetBridge::fleet() {
  const SteadyTime now = steadyNow();
  stop_caller_.lookAfter(now);
  robot_stop_caller_.lookAfter(now);
  endRetired(now);
  teleop::FleetView view;
  view.connected = watch_.masterUp();
  const bool stop_seen = watch_.up(names::kFleetEmergencyStop);
  stop_caller_.getReady(names::kFleetEmergencyStop, stop_seen);
  const bool stop_ready = stop_caller_.isReady(names::kFleetEmergencyStop);
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_news = now - answered_at_ < kNews;
  if (is_news || stop_.severity != teleop::Severity::kGood) view.stop = stop_;
  // A connection alone says nothing: after an outage of the network it looks sound for minutes.
  const bool stop_up = stop_seen || (stop_ready && listed_at_ && now - *listed_at_ < kHeard);
  if (!stop_up && !(is_news && stop_.severity == teleop::Severity::kError))
    view.stop = {teleop::Severity::kError, "fleet/emergency_stop is down: stop each robot by itself."};
  for (const auto& [name, reached] : listed_) view.robots.push_back(viewOf(name, reached, now));
  return view;
}

/// A robot is described by the parameters of its navigator. A robot without any is taken for one like the window's own.
void FleetBridge::describe(teleop::OpenedRobot& opened) const {
  const std::string& robot = opened.name;
  teleop::TeleopParameters& parameters = opened.parameters = parameters_;
  const std::string frame = RobotModel().base_frame;
  parameters.robot.base_frame = robot == kRoot ? frame : names::ofRobot(robot, frame);
  const ParameterMap all = readParameters(ros::NodeHandle(absolute(robot, names::kNavigatorNode)));
  ParameterMap known;
  for (const char* group : {"robot", "limits", "base_frame"}) {
    const auto found = all.find(group);
    if (found != all.end()) known.insert(*found);
  }
  opened.is_described = !all.empty();
  if (all.empty()) {
    THROTTLED_WARN(robot << " has no navigator: it is taken for a robot like the one of this window's parameters");
    return;
  }
  DescribedRobot described;
  described.robot.base_frame = parameters.robot.base_frame;
  const Problems problems = loadParameters(known, described);
  for (const std::string& problem : problems) THROTTLED_WARN("the navigator of " << robot << ": " << problem);
  parameters.robot = described.robot;
  parameters.robot.base_frame = described.robot.baseFrameOr(described.base_frame);
}

teleop::OpenedRobot FleetBridge::openOwn() {
  teleop::OpenedRobot own;
  own.parameters = parameters_;
  own.link = std::make_unique<GuiBridge>(own_node_, parameters_, GuiBridge::Manual::kAlways, running_);
  return own;
}

void FleetBridge::open(const std::string& robot) {
  opener_.startNext([this, robot] {
    teleop::OpenedRobot opened;
    opened.name = robot;
    connections_.guard().run("opening " + robot, [&] {
      describe(opened);
      opened.link = std::make_unique<GuiBridge>(nodeOf(robot), opened.parameters, GuiBridge::Manual::kAlways, running_);
    });
    return opened;
  });
}

std::optional<teleop::OpenedRobot> FleetBridge::takeOpened() { return opener_.take(); }

void FleetBridge::retire(std::unique_ptr<teleop::OperatorLink> link) {
  retired_.push_back({std::move(link), steadyNow()});
}

void FleetBridge::endRetired(SteadyTime now) {
  ender_.take();
  if (retired_.empty() || !ender_.idle() || now - retired_.front().since < kRetirement) return;
  ender_.start([link = std::move(retired_.front().link)]() mutable {
    link.reset();
    return true;
  });
  retired_.pop_front();
}

void FleetBridge::showAnswer(bool success, const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stop_ = {severityOfAnswer(success, text), printable(text, bounds::kMostReason)};
  answered_at_ = steadyNow();
}

void FleetBridge::stop(const std::string& robot) {
  robot_stop_caller_.insist(absolute(robot, names::kEmergencyStop), kRobotPatience,
                            ServiceCaller::Signature::kOfArbiter);
}

void FleetBridge::stopAll() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = {teleop::Severity::kWarning, "asking all robots to stop …"};
  }
  stop_caller_.insist(names::kFleetEmergencyStop, kFleetPatience);
}

void sayWhyNoWindow(const std::string& why) {
  std::cerr << "teleop_gui: no window can be opened: " << why << std::endl;
}

}  // namespace frontier_pilot
