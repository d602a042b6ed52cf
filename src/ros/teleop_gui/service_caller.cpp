#include "ros/teleop_gui/service_caller.h"

#include <frontier_pilot/LoadMap.h>
#include <frontier_pilot/SaveMap.h>
#include <ros/names.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <algorithm>

#include "ros/common/clock.h"
#include "ros/common/publish_flush.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kSlow = std::chrono::seconds(2);
constexpr Duration kMostWait = std::chrono::seconds(2);  // after that a call that waits is no more what is wanted
constexpr Duration kInsists = std::chrono::seconds(10);
constexpr auto kBetweenCalls = std::chrono::milliseconds(200);

teleop::Severity severityOf(bool success, const std::string& said) {
  if (!success) return teleop::Severity::kError;
  return mayBeUnsent(said) ? teleop::Severity::kWarning : teleop::Severity::kGood;
}

}  // namespace

void logForOperator(teleop::Severity severity, const std::string& text) {
  if (severity == teleop::Severity::kError || severity == teleop::Severity::kWarning) {
    THROTTLED_WARN(text);
  } else {
    THROTTLED_INFO(text);
  }
}

bool isServiceName(const std::string& service) {
  std::string why;
  return ros::names::validate(service, why);
}

ServiceCaller::ServiceCaller(const ros::NodeHandle& node, OperatorLog log, ServiceAnswered answered)
    : node_(node), log_(std::move(log)), answered_(std::move(answered)), thread_([this] { run(); }) {}

ServiceCaller::~ServiceCaller() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    calls_.clear();
    client_.shutdown();  // ends the call that waits for an answer
  }
  wake_.notify_all();
  thread_.join();
}

void ServiceCaller::set(const std::string& service, bool value, Late late) {
  post({service, Call::Type::kSetBool, late, value});
}
void ServiceCaller::trigger(const std::string& service) { post({service, Call::Type::kTrigger, Late::kDropped}); }
void ServiceCaller::insist(const std::string& service, Duration patience) {
  Call call{service, Call::Type::kTrigger, Late::kDone};
  call.insists = true;
  call.patience = patience;
  post(call);
}
void ServiceCaller::saveMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kSaveMap, Late::kDone, false, path});
}
void ServiceCaller::loadMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kLoadMap, Late::kDone, false, path});
}

void ServiceCaller::withdraw() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    withdrawn_ = true;
    takeOut([](const Call& call) { return call.insists; });
  }
  wake_.notify_all();
}

void ServiceCaller::dropWhatWaits(const std::string& why) {
  std::vector<Call> dropped;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dropped = takeOut([](const Call& call) { return call.late == Late::kDropped; });
    if (under_way_ && under_way_->late == Late::kDropped && !sent_) why_not_ = why;
  }
  for (const Call& call : dropped) sayNotDone(call, why);
}

std::string ServiceCaller::Call::text() const {
  if (type == Type::kSetBool) return service + (value ? " on" : " off");
  return path.empty() ? service : service + " " + path;
}

std::vector<ServiceCaller::Call> ServiceCaller::takeOut(const std::function<bool(const Call&)>& which) {
  const auto first =
      std::stable_partition(calls_.begin(), calls_.end(), [&](const Call& call) { return !which(call); });
  std::vector<Call> taken(first, calls_.end());
  calls_.erase(first, calls_.end());
  return taken;
}

void ServiceCaller::sayNotDone(const Call& call, const std::string& why) {
  if (answered_) answered_(call.service, false, "not done: " + why);
  log_(teleop::Severity::kWarning, call.text() + " is not done: " + why);
}

bool ServiceCaller::isUnderWay(const Call& call) const {
  return call.type == Call::Type::kSetBool && under_way_ && under_way_->service == call.service &&
         under_way_->value == call.value;
}

void ServiceCaller::post(Call call) {
  call.asked_at = steadyNow();
  bool waits = false;
  std::vector<Call> replaced;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waits = isUnderWay(call);
    replaced = takeOut([&call](const Call& other) { return other.service == call.service; });
    if (call.insists) {
      patience_ = call.patience;
      giveUpASilentStop(call.asked_at);
    }
    if (!waits) calls_.push_back(call);
  }
  for (const Call& other : replaced) {
    if (other.text() != call.text()) sayNotDone(other, call.text() + " was asked for after it");
  }
  if (waits) return log_(teleop::Severity::kWarning, call.service + " has not answered the last call yet");
  wake_.notify_all();
}

void ServiceCaller::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopping_) {
    if (calls_.empty()) {
      wake_.wait(lock);
      continue;
    }
    const Call call = calls_.front();
    calls_.pop_front();
    under_way_ = call;
    since_ = steadyNow();
    patience_ = call.patience;
    withdrawn_ = sent_ = gave_up_ = false;
    why_not_.clear();
    lock.unlock();
    tryPerform(call);
    lock.lock();
    since_.reset();
    asking_since_.reset();
    under_way_.reset();
    client_ = {};
  }
}

bool ServiceCaller::begin(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = client;
  asking_since_ = steadyNow();
  const bool too_late = under_way_->late == Late::kDropped && *asking_since_ - under_way_->asked_at > kMostWait;
  if (too_late && why_not_.empty()) why_not_ = "it has waited too long: ask again";
  sent_ = !stopping_ && why_not_.empty() && client_.isValid();
  return sent_;
}

bool ServiceCaller::isEnding() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
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
  ros::ServiceClient client = node_.serviceClient<Service>(name, true);
  if (!begin(client) || !client.call(service)) return std::nullopt;
  return Answer{service.response.success != 0, service.response.message};
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
  const SteadyTime end = steadyNow() + kInsists;
  std::optional<Answer> answer;
  while (!answer && steadyNow() < end) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      if (wake_.wait_for(lock, kBetweenCalls, [this] { return stopping_ || withdrawn_; })) return std::nullopt;
    }
    answer = ask(call);
  }
  return answer;
}

void ServiceCaller::perform(const Call& call) {
  std::optional<Answer> answer = ask(call);
  if (!answer && call.insists && !isEnding()) {
    log_(teleop::Severity::kError, call.service + ": " + whyNone() + ", trying again for 10 s");
    answer = askAgain(call);
  }
  if (isEnding()) return;
  if (const std::string why_not = whyNotDone(); !why_not.empty()) return sayNotDone(call, why_not);
  const std::string none = whyNone();
  if (answered_) answered_(call.service, answer && answer->success, answer ? answer->message : none);
  if (!answer) return log_(teleop::Severity::kError, call.service + ": " + none);
  const std::string said = !answer->message.empty() ? answer->message : (answer->success ? "done" : "refused");
  log_(severityOf(answer->success, said), (call.path.empty() ? call.text() : call.service) + ": " + said);
}

std::string ServiceCaller::whyNone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return gave_up_ ? "it does not answer" : "no such service, or it died";
}

std::string ServiceCaller::whyNotDone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return why_not_;
}

void ServiceCaller::lookAfter(SteadyTime now) {
  std::string slow;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    giveUpASilentStop(now);
    if (!since_ || now - *since_ < kSlow) return;
    since_.reset();
    slow = under_way_->service;
  }
  log_(teleop::Severity::kWarning, slow + " does not answer");
}

void ServiceCaller::giveUpASilentStop(SteadyTime now) {
  const bool insists = under_way_ && under_way_->insists;
  if (!insists || !asking_since_ || now - *asking_since_ < patience_) return;
  patience_ *= 2;
  gave_up_ = true;
  asking_since_.reset();
  client_.shutdown();
}

}  // namespace frontier_pilot
