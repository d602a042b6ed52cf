#include <geometry_msgs/Twist.h>
#include <ros/console.h>

#include <algorithm>
#include <string_view>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"
#include "ros/teleop_gui/gui_bridge.h"
#include "ros/teleop_gui/operator_views.h"

/// The bridge's subscriptions, and the state that it hands to the window.
namespace frontier_pilot {
namespace {

const Duration kFresh = fromSeconds(teleop::kStatusLifetime);

constexpr const char* kManualSource = "manual";
constexpr const char* kStopped = "somebody stopped the robot after it";

}  // namespace

void GuiBridge::subscribe() {
  const auto keep = [this](auto& latest, auto value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest.put(std::move(value), steadyNow());
  };
  connections_.subscribe<AvoiderStatus>(names::kAvoiderStatus, 1, [=](const AvoiderStatus& msg) {
    if (isShown(msg)) keep(avoider_, msg);
  });
  connections_.subscribe<dynamic_reconfigure::Config>(names::kAvoiderUpdates, 1,
                                                      [this](const auto& msg) { onAvoiderTuned(msg); });
  connections_.subscribe<ExplorerStatus>(names::kExplorerStatus, 1, [=](const ExplorerStatus& msg) {
    if (isShown(msg)) keep(explorer_, msg);
  });
  navigation_subscriber_ =
      connections_.subscribe<NavigatorProgress>(names::kNavigatorProgress, 1, [=](const NavigatorProgress& msg) {
        if (isShown(msg)) keep(navigation_, msg);
      });
  connections_.subscribeToEvents<ArbiterStatus>(names::kArbiterStatus, 1,
                                                [this](const auto& event) { onArbiter(event); });
  connections_.subscribe<geometry_msgs::Twist>(names::kCmdVel, 1, [=](const geometry_msgs::Twist& msg) {
    keep(command_, Twist2{msg.linear.x, msg.angular.z});
  });
  connections_.subscribe(names::kScan, 1, &GuiBridge::onScan, this);
  stop_subscriber_ =
      connections_.subscribe<std_msgs::Bool>(names::kEmergencyStopState, 1, [=](const std_msgs::Bool& msg) {
        keep(stop_, msg.data != 0);
        if (msg.data == 0) refuseClear("");
        if (msg.data != 0) dropWhatWaits(kStopped);
      });
  connections_.subscribe<std_msgs::Bool>(names::kStalled, 1,
                                         [=](const std_msgs::Bool& msg) { keep(contact_, msg.data != 0); });
}

void GuiBridge::refuseClear(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  clear_refusal_ = reason;
}

/// Keeps why the arbiter refuses to clear the stop, for the button that was pressed.
void GuiBridge::onAnswer(const std::string& service, bool success, const std::string& message) {
  if (service != names::kSetEmergencyStop) return;
  constexpr std::string_view kRefused = "refused: ";
  const std::size_t begin = message.rfind(kRefused, 0) == 0 ? kRefused.size() : 0;
  refuseClear(success ? "" : printable(withoutSignature(message.substr(begin)), bounds::kMostReason));
}

void GuiBridge::onMapAnswer(bool success, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  map_answer_ = {map_answer_.count + 1, success, printable(message, bounds::kMostReason)};
}

void GuiBridge::onArbiter(const ros::MessageEvent<const ArbiterStatus>& event) {
  const ArbiterStatus& msg = *event.getConstMessage();
  if (!isShown(msg)) return;
  for (const ArbiterSource& source : msg.sources) watchSwitchOf(source.name);
  if (isAnotherStop(msg)) dropWhatWaits(kStopped);
  const std::lock_guard<std::mutex> lock(mutex_);
  arbiter_.put(msg, steadyNow());
  if (event.getConnectionHeaderPtr() != arbiter_header_) ++arbiter_changes_;
  arbiter_header_ = event.getConnectionHeaderPtr();
}

bool GuiBridge::isAnotherStop(const ArbiterStatus& msg) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return arbiter_.has() && msg.stops > arbiter_.get()->stops;
}

void GuiBridge::onListenerLost(const ros::SingleSubscriberPublisher& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool was_arbiter = arbiter_header_ && (*arbiter_header_)["callerid"] == listener.getSubscriberName();
  if (was_arbiter) ++arbiter_changes_;
}

/// Watches the switch of a source. A source whose name cannot be part of a service name is shown without one. [FLT-1]
void GuiBridge::watchSwitchOf(const std::string& source) {
  const std::string service = names::setEnabled(source);
  if (isServiceName(service)) return watch_.watch(service);
  const std::string name = printable(source, bounds::kMostReason);
  nameless_.add("'" + name + "' cannot be part of a service's name");
  const bool is_news = said_nameless_.size() < bounds::kMostReasons && said_nameless_.insert(name).second;
  if (is_news) log(teleop::Severity::kWarning, "the source '" + name + "' has no switch: no service can have its name");
}

void GuiBridge::onScan(const sensor_msgs::LaserScan& msg) {
  const auto T_base_sensor = tf_.lookup3d(parameters_.robot.base_frame, msg.header.frame_id, Time{});
  if (!T_base_sensor) return;  // the window then shows the growing age of the last scan
  auto scan = toLaserScan(msg, *T_base_sensor);
  if (!scan) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  scan_.put(std::move(*scan), steadyNow());
}

/// Reads the avoider's sectors from its parameters, which exist once it is running.
void GuiBridge::onServiceUp(const std::string& service) {
  if (service != names::kSetObstacleAvoidEnabled) return;
  connections_.guard().run("the avoider's parameters", [this] {
    avoid::AvoiderParameters parameters;
    const ParameterMap map = readParameters(ros::NodeHandle(node_, names::kObstacleAvoiderNode));
    loadParameters(map, parameters);  // the avoider itself reports errors in them
    const std::lock_guard<std::mutex> lock(mutex_);
    avoider_parameters_ = parameters;
  });
}

void GuiBridge::onAvoiderTuned(const dynamic_reconfigure::Config& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  avoider_parameters_ = tuned(avoider_parameters_.value_or(avoid::AvoiderParameters()), msg);
}

/// Also off while an arbiter that was heard is silent: what is sent over a link that has failed waits in it, and would
/// move the robot after a stop and its clear. [ARB-8]
bool GuiBridge::manualOn(SteadyTime now) const {
  const auto status = arbiter_.fresh(now, kFresh);
  if (!status) return !arbiter_.has();
  return std::none_of(status->sources.begin(), status->sources.end(),
                      [](const ArbiterSource& source) { return source.name == kManualSource && source.enabled == 0; });
}

/// The latched topic, as long as the arbiter that publishes it lives.
std::optional<bool> GuiBridge::stopState(SteadyTime now) const {
  const bool dead = arbiter_.has() && !arbiter_.fresh(now, kFresh);
  return dead || stop_subscriber_.getNumPublishers() == 0 ? std::nullopt : stop_.get();
}

teleop::OperatorState GuiBridge::state() {
  teleop::OperatorState state;
  state.connected = watch_.masterUp();
  state.stop_service_up = watch_.up(names::kEmergencyStop);
  state.clear_service_up = watch_.up(names::kSetEmergencyStop);
  state.avoider_service_up = watch_.up(names::kSetObstacleAvoidEnabled);
  state.explorer_service_up = watch_.up(names::kSetExplorationEnabled);
  state.explorer_reset_up = watch_.up(names::kResetExplorer);
  state.explorer_bounds_up = watch_.up(names::kClearExplorationBounds);
  state.explorer_inspections_up = watch_.up(names::kClearInspections);
  state.explorer_return_up = watch_.up(names::kSetReturnToStart);
  state.patrol = patrol_.view();
  state.spin = spin_.view();
  state.navigate = navigate_.view();
  state.waypoints = waypoints_.view();
  state.save_map_up = watch_.up(names::kSaveMap);
  state.load_map_up = watch_.up(names::kLoadMap);
  const bool stop_ready = stop_caller_.isReady(names::kEmergencyStop);
  const SteadyTime now = steadyNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  // A connection alone says nothing: after an outage of the network it looks sound for minutes.
  if (stop_ready && arbiter_.fresh(now, kFresh)) state.stop_service_up = true;
  state.emergency_stop = stopState(now);
  state.arbiter_changes = arbiter_changes_;
  state.clear_refusal = clear_refusal_;
  state.map_answer = map_answer_;
  state.contact = contact_.fresh(now, kFresh);
  if (avoider_parameters_) state.sectors = toSectors(*avoider_parameters_);
  show(arbiter_, now, state.arbiter);
  show(avoider_, now, state.avoider);
  show(explorer_, now, state.explorer);
  if (navigation_subscriber_.getNumPublishers() > 0) show(navigation_, now, state.navigation);
  if (scan_.has()) state.scan = teleop::ScanView{toSeconds(*scan_.age(now)), *scan_.get()};
  if (state.arbiter) {
    // The status comes only once a second, too slowly for the gauges.
    state.arbiter->command = command_.fresh(now, kFresh).value_or(state.arbiter->command);
    for (teleop::SourceView& source : state.arbiter->sources)
      source.service_up = watch_.up(names::setEnabled(source.name));
  }
  return state;
}

}  // namespace frontier_pilot
