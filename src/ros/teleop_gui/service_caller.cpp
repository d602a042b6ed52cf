#include "ros/teleop_gui/service_caller.h"

#include <frontier_pilot/LoadMap.h>
#include <frontier_pilot/SaveMap.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/service.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/clock.h"
#include "ros/common/publish_flush.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kSlow = std::chrono::seconds(2);
constexpr Duration kInsists = std::chrono::seconds(10);
constexpr auto kBetweenCalls = std::chrono::milliseconds(200);
constexpr auto kWatchPeriod = std::chrono::seconds(1);

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

void ServiceCaller::set(const std::string& service, bool value) {
  post({service, Call::Type::kSetBool, value, {}, false});
}
void ServiceCaller::trigger(const std::string& service) { post({service, Call::Type::kTrigger, false, {}, false}); }
void ServiceCaller::insist(const std::string& service) { post({service, Call::Type::kTrigger, false, {}, true}); }
void ServiceCaller::withdraw() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    withdrawn_ = true;
    calls_.erase(std::remove_if(calls_.begin(), calls_.end(), [](const Call& call) { return call.insists; }),
                 calls_.end());
  }
  wake_.notify_all();
}
void ServiceCaller::saveMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kSaveMap, false, path, false});
}
void ServiceCaller::loadMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kLoadMap, false, path, false});
}

bool ServiceCaller::isUnderWay(const Call& call) const {
  return call.type == Call::Type::kSetBool && under_way_ && under_way_->service == call.service &&
         under_way_->value == call.value;
}

void ServiceCaller::post(const Call& call) {
  bool waits = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waits = isUnderWay(call);
    if (!waits) {
      const auto same = [&call](const Call& other) { return other.service == call.service; };
      calls_.erase(std::remove_if(calls_.begin(), calls_.end(), same), calls_.end());
      calls_.push_back(call);
    }
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
    withdrawn_ = false;
    lock.unlock();
    tryPerform(call);
    lock.lock();
    since_.reset();
    under_way_.reset();
    client_ = {};
  }
}

bool ServiceCaller::begin(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = client;
  return !stopping_ && client_.isValid();
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
  const std::string none = "no such service, or it died";
  std::optional<Answer> answer = ask(call);
  if (!answer && call.insists && !isEnding()) {
    log_(teleop::Severity::kError, call.service + ": " + none + ", trying again for 10 s");
    answer = askAgain(call);
  }
  if (isEnding()) return;
  if (answered_) answered_(call.service, answer && answer->success, answer ? answer->message : none);
  if (!answer) return log_(teleop::Severity::kError, call.service + ": " + none);
  const std::string value = call.type != Call::Type::kSetBool ? "" : (call.value ? " on" : " off");
  const std::string said = !answer->message.empty() ? answer->message : (answer->success ? "done" : "refused");
  log_(severityOf(answer->success, said), call.service + value + ": " + said);
}

void ServiceCaller::reportSlow(SteadyTime now) {
  std::string slow;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!since_ || now - *since_ < kSlow) return;
    since_.reset();
    slow = under_way_->service;
  }
  log_(teleop::Severity::kWarning, slow + " does not answer");
}

ServiceWatch::ServiceWatch(const ros::NodeHandle& node, std::function<void(const std::string&)> appeared)
    : node_(node), appeared_(std::move(appeared)), thread_([this] { run(); }) {}

ServiceWatch::~ServiceWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void ServiceWatch::watch(const std::string& service) {
  if (!isServiceName(service)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (up_.size() < bounds::kMostServices && up_.emplace(service, false).second) wake_.notify_all();
}

bool ServiceWatch::up(const std::string& service) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = up_.find(service);
  return found != up_.end() && found->second;
}

bool ServiceWatch::masterUp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return master_up_;
}

void ServiceWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    guard_.run("the watch on the services", [this] { lookOnce(); });
    lock.lock();
    if (!stopping_) wake_.wait_for(lock, kWatchPeriod);
  }
}

void ServiceWatch::lookOnce() {
  std::map<std::string, bool> before;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    before = up_;
  }
  const bool master = ros::master::check();
  for (const auto& [service, was_up] : before) {
    // This contacts the server itself, too, so that the death of a server that is still registered is noticed.
    const bool is_up = master && ros::service::exists(node_.resolveName(service), false);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      up_[service] = is_up;
    }
    if (is_up && !was_up) appeared_(service);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  master_up_ = master;
}

}  // namespace frontier_pilot
