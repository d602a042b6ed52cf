#include "ros/teleop_gui/gui_bridge.h"

#include <geometry_msgs/Twist.h>

#include <chrono>
#include <ctime>
#include <utility>

#include "ros/common/master/xml_rpc.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/publish_flush.h"
#include "ros/common/throttled_log.h"
#include "ros/teleop_gui/operator_views.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostLogLines = 200;  // kept for a window that does not fetch them
constexpr Duration kMotionLinger = std::chrono::seconds(1);

PatrolGoal toPatrolGoal(const teleop::OperatorRequest& request) {
  PatrolGoal goal;
  goal.goal.x = request.shape;
  goal.goal.y = request.side;
  goal.goal.z = request.laps;
  return goal;
}

SpinGoal toSpinGoal(const teleop::OperatorRequest& request) {
  SpinGoal goal;
  goal.target_yaw = request.angle;
  return goal;
}

}  // namespace

GuiBridge::GuiBridge(const ros::NodeHandle& node, const teleop::TeleopParameters& parameters, Manual manual,
                     std::function<bool()> running)
    : manual_output_(fromSeconds(parameters.liveness_timeout)),
      parameters_(parameters),
      manual_(manual),
      running_(std::move(running)),
      node_(onQueue(node, queue_)),
      connections_(node_),
      patrol_(node_, connections_, names::kPatrol, "patrol", logger()),
      spin_(node_, connections_, names::kSpin, "spin", logger()),
      navigate_(node_, connections_, names::kMoveBase, "navigation", logger(), NavigationLink::Logs::kOwn),
      map_(node, tf_, parameters.robot.base_frame),
      waypoints_(node_, connections_, names::kFollowWaypoints, "waypoints", logger()),
      caller_(node_, logger()),
      arbiter_caller_(
          node_, logger(),
          [this](const auto& service, bool success, const auto& message) { onAnswer(service, success, message); }),
      stop_caller_(node_, logger()),
      map_caller_(node_, logger(),
                  [this](const auto&, bool success, const auto& message) { onMapAnswer(success, message); }),
      watch_(node_, [this](const std::string& service) { onServiceUp(service); }),
      spinner_(1, &queue_) {
  watchServices();
  subscribe();
  connections_.everySteady(ros::WallDuration(1.0 / parameters_.publish_rate), [this] { publishManual(); });
  spinner_.start();
}

/// A publisher that is destroyed drops what has not been written yet.
GuiBridge::~GuiBridge() {
  close();
  stop_caller_.finishInsisting(running_);
  flushLastWords();
  spinner_.stop();
}

void GuiBridge::watchServices() {
  for (const char* service : {names::kEmergencyStop, names::kSetEmergencyStop, names::kSetObstacleAvoidEnabled,
                              names::kSetExplorationEnabled, names::kResetExplorer, names::kClearExplorationBounds,
                              names::kClearInspections, names::kSetReturnToStart, names::kSaveMap, names::kLoadMap}) {
    watch_.watch(service);
  }
}

SteadyTime GuiBridge::now() const {
  timespec time{};
  clock_gettime(CLOCK_BOOTTIME, &time);  // steady_clock stands still while the computer is suspended
  return SteadyTime(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

void GuiBridge::beat(const Twist2& set_point) {
  const std::lock_guard<std::mutex> lock(mutex_);
  manual_output_.beat(set_point, this->now());
  if (!set_point.isZero()) last_motion_ = steadyNow();
}

bool GuiBridge::manualWanted(SteadyTime now) {
  return manual_ == Manual::kAlways || (last_motion_ != SteadyTime{} && now - last_motion_ < kMotionLinger);
}

bool GuiBridge::isContested() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto status = arbiter_.get();
  return status && status->state == ArbiterStatus::CONTESTED;
}

void GuiBridge::publishManual() {
  const SteadyTime now = steadyNow();
  for (ServiceCaller* caller : {&caller_, &arbiter_caller_, &stop_caller_, &map_caller_}) caller->lookAfter(now);
  // Where another node has taken the service, the master would lead to that: the connection of before counts.
  stop_caller_.getReady(names::kEmergencyStop, watch_.up(names::kEmergencyStop) && !isContested());
  switch (publishManual(now)) {
    case TopicNeed::kNone:
      break;
    case TopicNeed::kOpen:
      openManual();
      break;
    case TopicNeed::kClose:
      closeManual();
      break;
  }
}

/// Publishes while holding the lock, so that nothing can be published after the zero of close().
GuiBridge::TopicNeed GuiBridge::publishManual(SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto before = manual_output_.state();
  // Also while nobody drives: a set-point that is the first ever told would be taken for one from before a freeze.
  const std::optional<Twist2> command = manual_output_.update(manualOn(now), this->now());
  if (!manualWanted(now)) return manual_publisher_ ? TopicNeed::kClose : TopicNeed::kNone;
  if (manual_output_.state() == teleop::ManualOutput::State::kFrozen &&
      before != teleop::ManualOutput::State::kFrozen) {
    THROTTLED_WARN("the window does not respond: zero sent, manual is silent");
  }
  if (!command) return TopicNeed::kNone;
  if (!manual_publisher_) return TopicNeed::kOpen;
  manual_publisher_.publish(toTwistMsg(*command));
  return TopicNeed::kNone;
}

/// roscpp waits for a master that is gone for ever, and so would whoever closes the window.
bool GuiBridge::masterAnswers() const { return watch_.masterUp() && pidOfMaster(); }

/// The command that needs the topic is not published, because it may be old by then: the next one comes soon enough.
void GuiBridge::openManual() {
  if (!masterAnswers()) return;
  ros::Publisher publisher = node_.advertise<geometry_msgs::Twist>(
      names::kCmdVelManual, 1, {},
      [this](const ros::SingleSubscriberPublisher& listener) { onListenerLost(listener); });
  const std::lock_guard<std::mutex> lock(mutex_);
  manual_publisher_ = publisher;
}

void GuiBridge::closeManual() {
  if (!masterAnswers()) return;
  ros::Publisher publisher;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(publisher, manual_publisher_);
  }
  publisher.shutdown();
}

void GuiBridge::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (manual_output_.state() == teleop::ManualOutput::State::kClosed) return;
  const Twist2 zero = manual_output_.close();
  if (manual_publisher_) manual_publisher_.publish(toTwistMsg(zero));
  patrol_.cancelOwn();
  spin_.cancelOwn();
  waypoints_.cancelOwn();
  navigate_.cancelOwn();
}

void GuiBridge::goTo(const Pose2& goal) {
  move_base_msgs::MoveBaseGoal msg;
  msg.target_pose = toPoseStampedMsg(goal, map_.frame(), rosNow());
  navigate_.start(msg);
}

void GuiBridge::followWaypoints(const std::vector<Pose2>& poses) {
  FollowWaypointsGoal msg;
  for (const Pose2& pose : poses) msg.poses.push_back(toPoseStampedMsg(pose, map_.frame(), rosNow()));
  waypoints_.start(msg);
}

void GuiBridge::dropWhatWaits(const std::string& why) {
  for (ServiceCaller* caller : {&caller_, &arbiter_caller_, &map_caller_}) caller->dropWhatWaits(why);
  patrol_.cancelUnlessArrived();
  spin_.cancelUnlessArrived();
  waypoints_.cancelUnlessArrived();
  navigate_.cancelUnlessArrived();
}

void GuiBridge::request(const teleop::OperatorRequest& request) {
  using Kind = teleop::OperatorRequest::Kind;
  using Late = ServiceCaller::Late;
  const Late unless_on = request.on ? Late::kDropped : Late::kDone;
  switch (request.kind) {
    case Kind::kEmergencyStop:
      dropWhatWaits("the emergency stop was pressed after it");
      return stop_caller_.insist(names::kEmergencyStop, std::chrono::milliseconds(1500),
                                 ServiceCaller::Signature::kOfArbiter);
    case Kind::kClearEmergencyStop:
      stop_caller_.withdraw();
      return arbiter_caller_.set(names::kSetEmergencyStop, false);
    case Kind::kEnableSource:
      return arbiter_caller_.set(names::setEnabled(request.name), request.on, unless_on);
    case Kind::kEnableAvoider:
      return caller_.set(names::kSetObstacleAvoidEnabled, request.on);
    case Kind::kExplore:
      return caller_.set(names::kSetExplorationEnabled, request.on, unless_on);
    case Kind::kResetExplorer:
      return caller_.trigger(names::kResetExplorer);
    case Kind::kClearBounds:
      return caller_.trigger(names::kClearExplorationBounds);
    case Kind::kClearInspections:
      return caller_.trigger(names::kClearInspections);
    case Kind::kReturnToStart:
      return caller_.set(names::kSetReturnToStart, request.on);
    case Kind::kPatrol:
      return patrol_.start(toPatrolGoal(request));
    case Kind::kStopPatrol:
      return patrol_.cancelAll();
    case Kind::kSpin:
      return spin_.start(toSpinGoal(request));
    case Kind::kStopSpin:
      return spin_.cancelAll();
    case Kind::kStopNavigation:
      if (waypoints_.view().connected) waypoints_.cancelAll();  // first, so that they do not go on with the next one
      return navigate_.cancelAll();
    case Kind::kGoTo:
      return request.poses.empty() ? void() : goTo(request.poses.front());
    case Kind::kFollowWaypoints:
      return followWaypoints(request.poses);
    case Kind::kSaveMap:
      return map_caller_.saveMap(names::kSaveMap, request.name);
    case Kind::kLoadMap:
      return map_caller_.loadMap(names::kLoadMap, request.name);
  }
}

std::vector<teleop::OperatorLogLine> GuiBridge::takeLog() {
  const std::lock_guard<std::mutex> lock(log_mutex_);
  return std::exchange(log_, {});
}

OperatorLog GuiBridge::logger() {
  return [this](teleop::Severity severity, const std::string& text) { log(severity, text); };
}

void GuiBridge::log(teleop::Severity severity, const std::string& text) {
  logForOperator(severity, text);
  const std::lock_guard<std::mutex> lock(log_mutex_);
  if (log_.size() < kMostLogLines) log_.push_back({severity, text});
}

}  // namespace frontier_pilot
