// The arbiter's services: what has to leave on cmd_vel leaves before the answer.
#include <ros/console.h>

#include "frontier_pilot/ros/cmd_vel_arbiter_adapter.h"
#include "frontier_pilot/ros/names.h"

namespace frontier_pilot {
namespace {

template <class Response>
bool reply(const ArbiterAnswer& answer, Response& response) {
  response.success = static_cast<std::uint8_t>(answer.success);
  response.message = answer.message;
  return true;
}

}  // namespace

void CmdVelArbiterNode::addStopServices() {
  ros::AdvertiseServiceOptions set;
  set.initBySpecType<SetBoolCall>(names::kSetEmergencyStop, [this](SetBoolCall& call) { return handleSetStop(call); });
  set.callback_queue = &calls_;
  services_.push_back(node_.advertiseService(set));
  ros::AdvertiseServiceOptions trigger;
  trigger.initBySpecType<TriggerCall>(names::kEmergencyStop, [this](TriggerCall& call) { return handleStop(call); });
  trigger.callback_queue = &calls_;
  services_.push_back(node_.advertiseService(trigger));
}

bool CmdVelArbiterNode::handleEnable(std::size_t source, std_srvs::SetBool::Request& request,
                                     std_srvs::SetBool::Response& response) {
  const ArbiterAnswer answer = arbiter_.setEnabled(source, request.data != 0, instantNow());
  publish(answer.publish);
  publishStatus(false);
  return reply(answer, response);
}

bool CmdVelArbiterNode::handleSetStop(SetBoolCall& call) {
  const bool on = call.getRequest().data != 0;
  return reply(on ? stop(names::kSetEmergencyStop, call.getCallerName()) : clear(call.getCallerName()),
               call.getResponse());
}

bool CmdVelArbiterNode::handleStop(TriggerCall& call) {
  return reply(stop(names::kEmergencyStop, call.getCallerName()), call.getResponse());
}

ArbiterAnswer CmdVelArbiterNode::stop(const std::string& service, const std::string& caller) {
  ArbiterAnswer answer = arbiter_.stop(service + " called by " + caller, instantNow());
  publish(answer.publish);
  around_.memory_problem = memory_.remember(arbiter_.stopCause());
  if (!around_.memory_problem.empty()) answer.message += "; would not survive a restart: " + around_.memory_problem;
  publishStopState();
  publishStatus(false);
  return answer;
}

ArbiterAnswer CmdVelArbiterNode::clear(const std::string& caller) {
  ArbiterAnswer answer = arbiter_.clear(calls_.arrival(), instantNow());
  publish(answer.publish);
  if (!arbiter_.stopped()) around_.memory_problem = memory_.forget();
  ROS_INFO_STREAM("set_emergency_stop false called by " << caller << ": " << answer.message);
  publishStopState();
  publishStatus(false);
  return answer;
}

}  // namespace frontier_pilot
