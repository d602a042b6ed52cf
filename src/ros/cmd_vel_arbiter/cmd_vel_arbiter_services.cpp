// The arbiter's services. A command that a call causes on cmd_vel is published before the call is answered.
#include <ros/console.h>

#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/messages/stop_words.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

/// How long an answer waits for the zero to be written to the sockets. A subscriber that does not read must not delay
/// the stop.
constexpr Duration kFlushPatience = std::chrono::milliseconds(50);

/// How long the subscriptions of a new arbiter take to connect; after that it hears every source that commands motion.
constexpr Duration kConnectTime = std::chrono::milliseconds(500);

template <class Response>
bool reply(const arbiter::ArbiterAnswer& answer, Response& response) {
  response.success = static_cast<std::uint8_t>(answer.success);
  response.message = answer.message;
  return true;
}

std::string causeOf(const std::string& service, const std::string& caller) { return service + " called by " + caller; }

}  // namespace

void CmdVelArbiterAdapter::addStopServices() {
  ros::AdvertiseServiceOptions trigger;
  trigger.initBySpecType<TriggerCall>(names::kEmergencyStop, [this](TriggerCall& call) { return handleStop(call); });
  trigger.callback_queue = &calls_;
  connections_.serve(trigger);
  ros::AdvertiseServiceOptions set;
  set.initBySpecType<SetBoolCall>(names::kSetEmergencyStop, [this](SetBoolCall& call) { return handleSetStop(call); });
  set.callback_queue = &clears_;
  connections_.serve(set);
  fleet_.listen(connections_, node_.resolveName(names::kEmergencyStop));
  stop_listeners_.begin(steadyNow());  // after whatever the start had to wait for
  connections_.master().watchListeners(around_.emergency_stop_state);
}

void CmdVelArbiterAdapter::addServices() {
  addStopServices();
  tuning_.emplace(arbiter_.parameters(), connections_, [this](const arbiter::ArbiterParameters& parameters) {
    publish(arbiter_.setLimits(parameters.robot.limits, instantNow()));
  });
}

/// A new arbiter, or one that was held up, does not know yet which sources command motion. A call that may clear the
/// stop waits until it has listened to them for as long as they have to be quiet before a clear, and until the nodes
/// that follow the stop are connected to a new one, or have had the time for it. [ARB-8] [FLT-2]
void CmdVelArbiterAdapter::listenBeforeClears() {
  const SteadyTime now = steadyNow();
  const bool held_up = hold_ups_.isCatchingUp(now);  // is noticed only if it is asked for in each tick
  if (!arbiter_.stopped()) return;
  const SteadyTime connected = stop_listeners_.begun() + kConnectTime;
  const SteadyTime hears_all = held_up ? std::max(connected, now) : connected;
  const SteadyTime until = hears_all + fromSeconds(arbiter_.parameters().clear_quiet_time);
  if (now >= until && !stop_listeners_.areAwaited(now)) return;
  clears_.hold();
  listening_until_ = std::max(listening_until_.value_or(until), until);
}

void CmdVelArbiterAdapter::endListening() {
  const SteadyTime now = steadyNow();
  if (!listening_until_ || now < *listening_until_ || stop_listeners_.areAwaited(now)) return;
  listening_until_.reset();
  clears_.release();
}

void CmdVelArbiterAdapter::listListeners(std::vector<std::string> nodes) {
  stop_listeners_.list(std::move(nodes));
  if (!stop_listeners_.mayBeAwaited(steadyNow())) connections_.master().watchListeners("");
}

/// The queue holds a stop and its clear: one that has not been sent yet is not replaced by the other.
ros::Publisher CmdVelArbiterAdapter::advertiseStopState() {
  return node_.advertise<std_msgs::Bool>(
      names::kEmergencyStopState, 10,
      [this](const ros::SingleSubscriberPublisher& to) { stop_listeners_.connect(to.getSubscriberName()); },
      [this](const ros::SingleSubscriberPublisher& to) { stop_listeners_.disconnect(to.getSubscriberName()); },
      ros::VoidConstPtr(), true);
}

void CmdVelArbiterAdapter::publishStopState() {
  std_msgs::Bool state;
  state.data = static_cast<std::uint8_t>(arbiter_.stopped());
  stop_state_.publish(state);
}

bool CmdVelArbiterAdapter::handleEnable(std::size_t source, std_srvs::SetBool::Request& request,
                                        std_srvs::SetBool::Response& response) {
  arbiter::ArbiterAnswer answer = arbiter_.setEnabled(source, request.data != 0, instantNow());
  answer.message += switches_[source].set(request.data == 0);
  publish(answer.publish);
  if (answer.publish) flush_.wait(kFlushPatience);
  publishStatus(false);
  return reply(answer, response);
}

bool CmdVelArbiterAdapter::handleSetStop(SetBoolCall& call) {
  const bool on = call.getRequest().data != 0;
  return reply(
      signedBy(on ? stop(causeOf(names::kSetEmergencyStop, call.getCallerName())) : clear(call.getCallerName())),
      call.getResponse());
}

bool CmdVelArbiterAdapter::handleStop(TriggerCall& call) {
  return reply(signedBy(stop(causeOf(names::kEmergencyStop, call.getCallerName()))), call.getResponse());
}

arbiter::ArbiterAnswer CmdVelArbiterAdapter::signedBy(arbiter::ArbiterAnswer answer) const {
  answer.message += " " + signatureOf(around_.own_name);
  return answer;
}

arbiter::ArbiterAnswer CmdVelArbiterAdapter::stop(const std::string& cause) {
  // It names a caller or a node, whose name may be anything of any length. [FLT-1]
  arbiter::ArbiterAnswer answer = arbiter_.stop(printable(cause, bounds::kMostLine), instantNow());
  publish(answer.publish);
  answer.message = answerOfStop(answer.message, flush_.wait(kFlushPatience));
  around_.memory_problem = memory_.remember(arbiter_.stopCause());
  if (!around_.memory_problem.empty()) answer.message += "; would not survive this node: " + around_.memory_problem;
  publishStopState();
  publishStatus(true);  // the count of stops has changed
  keepCount();
  arbiter_.answerStop(steadyNow());
  return answer;
}

arbiter::ArbiterAnswer CmdVelArbiterAdapter::clear(const std::string& caller) {
  const bool was_stopped = arbiter_.stopped();
  arbiter::ArbiterAnswer answer = arbiter_.clear(clears_.arrival(), instantNow());
  publish(answer.publish);
  if (!arbiter_.stopped()) {
    around_.memory_problem = memory_.forget();
    if (!around_.memory_problem.empty())
      answer.message += "; would come back with the next start of this node: " + around_.memory_problem;
  }
  THROTTLED_INFO("set_emergency_stop false called by " << caller << ": " << answer.message);
  publishStopState();
  publishStatus(false);
  // The explorer pauses when it hears of the clear: it has to hear of it before whoever is answered can let it go on.
  if (was_stopped && !arbiter_.stopped()) flush_.wait(kFlushPatience);
  return answer;
}

}  // namespace frontier_pilot
