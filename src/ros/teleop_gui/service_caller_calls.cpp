// The calls themselves, on the caller's thread.
#include <frontier_pilot/LoadMap.h>
#include <frontier_pilot/SaveMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "ros/common/clock.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/common/messages/stop_words.h"
#include "ros/teleop_gui/service_caller.h"

namespace frontier_pilot {
namespace {

constexpr Duration kMostWait = std::chrono::seconds(2);  // after that a call that waits is no more what is wanted
constexpr auto kBetweenCalls = std::chrono::milliseconds(200);

}  // namespace

teleop::Severity severityOfAnswer(bool success, const std::string& said) {
  if (!success) return teleop::Severity::kError;
  return leavesDoubt(said) ? teleop::Severity::kWarning : teleop::Severity::kGood;
}

bool ServiceCaller::begin(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = client;
  const SteadyTime now = steadyNow();
  const bool too_late = under_way_->late == Late::kDropped && now - under_way_->asked_at > kMostWait;
  if (too_late && why_not_.empty()) why_not_ = "it has waited too long: ask again";
  sent_ = !stopping_ && why_not_.empty() && client_.isValid();
  asking_since_ = sent_ ? std::optional<SteadyTime>(now) : std::nullopt;
  return sent_;
}

bool ServiceCaller::isEnding() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

bool ServiceCaller::isCalledOff() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_ || withdrawn_;
}

bool ServiceCaller::isSeen(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ready_service_ != service || seen_;
}

bool ServiceCaller::masterAnswers() {
  const bool answers = pidOfMaster().has_value();
  const std::lock_guard<std::mutex> lock(mutex_);
  no_master_ = !answers;
  return answers;
}

void ServiceCaller::tryPerform(const Call& call) {
  if (!isServiceName(call.service))
    return log_(teleop::Severity::kError, "'" + call.service + "' is not a valid service name");
  const bool came_to_its_end = guard_.run("a call of " + call.service, [&] { perform(call); });
  if (!came_to_its_end) log_(teleop::Severity::kError, call.service + " failed");
}

template <class Service>
std::optional<ServiceCaller::Answer> ServiceCaller::ask(const std::string& name, Service& service) {
  // Persistent, because only such a client can be shut down in the middle of a call.
  return ask(node_.serviceClient<Service>(name, true), service);
}

template <class Service>
std::optional<ServiceCaller::Answer> ServiceCaller::ask(ros::ServiceClient client, Service& service) {
  if (!begin(client) || !client.call(service)) return std::nullopt;
  return Answer{service.response.success != 0, service.response.message};
}

std::optional<ServiceCaller::Answer> ServiceCaller::attempt(const Call& call) {
  // The master knows best where a server is, which may have moved.
  if ((!call.insists || isSeen(call.service)) && masterAnswers()) return ask(call);
  if (!call.insists) return std::nullopt;
  const std::optional<Answer> answer = askReady(call);
  return answer || isCalledOff() || !masterAnswers() ? answer : ask(call);
}

std::optional<ServiceCaller::Answer> ServiceCaller::askReady(const Call& call) {
  ros::ServiceClient client;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (ready_service_ != call.service) return std::nullopt;
    client = ready_;
  }
  std_srvs::Trigger trigger;
  return ask(client, trigger);
}

std::optional<ServiceCaller::Answer> ServiceCaller::ask(const Call& call) {
  if (call.type == Call::Type::kSetBool) {
    std_srvs::SetBool set;
    set.request.data = call.value ? 1 : 0;
    return ask(call.service, set);
  }
  if (call.type == Call::Type::kSaveMap) {
    SaveMap save;
    save.request.path = call.path;
    return ask(call.service, save);
  }
  if (call.type == Call::Type::kLoadMap) {
    LoadMap load;
    load.request.path = call.path;
    return ask(call.service, load);
  }
  std_srvs::Trigger trigger;
  return ask(call.service, trigger);
}

std::optional<ServiceCaller::Answer> ServiceCaller::askAgain(const Call& call) {
  std::optional<Answer> answer;
  while (!answer && steadyNow() < insistsUntil()) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      if (wake_.wait_for(lock, kBetweenCalls, [this] { return stopping_ || withdrawn_; })) return std::nullopt;
    }
    answer = attempt(call);
  }
  return answer;
}

void ServiceCaller::perform(const Call& call) {
  std::optional<Answer> answer = attempt(call);
  if (!answer && call.insists && !isEnding()) {
    log_(teleop::Severity::kError, call.service + ": " + whyNone() + ", trying again");
    answer = askAgain(call);
  }
  if (isEnding()) return;
  if (const std::string why_not = whyNotDone(); !why_not.empty()) return sayNotDone(call, why_not);
  const std::string none = whyNone();
  const bool is_success = answer && answer->success;
  if (is_success && call.expected == Signature::kOfArbiter && !isSigned(answer->message))
    answer->message += (answer->message.empty() ? "" : "; ") + unsignedAnswerOf(call.service);
  if (answered_) answered_(call.service, is_success, answer ? answer->message : none);
  if (!answer) return log_(teleop::Severity::kError, call.service + ": " + none);
  const std::string said = !answer->message.empty() ? answer->message : (answer->success ? "done" : "refused");
  log_(severityOfAnswer(answer->success, said), (call.path.empty() ? call.text() : call.service) + ": " + said);
}

SteadyTime ServiceCaller::insistsUntil() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return insists_until_;
}

std::string ServiceCaller::whyNone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (gave_up_) return "it does not answer";
  return no_master_ ? "the ROS master does not answer" : "no such service, or it died";
}

std::string ServiceCaller::whyNotDone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return why_not_;
}

}  // namespace frontier_pilot
