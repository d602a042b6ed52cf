#include "ros/teleop_gui/service_caller.h"

#include <ros/names.h>
#include <std_srvs/Trigger.h>

#include <algorithm>

#include "ros/common/clock.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kSlow = std::chrono::seconds(2);
constexpr Duration kBetweenConnections = std::chrono::seconds(1);
constexpr auto kBetweenLooks = std::chrono::milliseconds(50);

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
void ServiceCaller::insist(const std::string& service, Duration patience, Signature expected) {
  Call call{service, Call::Type::kTrigger, Late::kDone};
  call.insists = true;
  call.patience = patience;
  call.expected = expected;
  post(call);
}
void ServiceCaller::saveMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kSaveMap, Late::kDone, false, path});
}
void ServiceCaller::loadMap(const std::string& service, const std::string& path) {
  post({service, Call::Type::kLoadMap, Late::kDropped, false, path});
}

void ServiceCaller::withdraw() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    withdrawn_ = true;
    takeOut([](const Call& call) { return call.insists; });
  }
  wake_.notify_all();
}

std::optional<std::string> ServiceCaller::whatInsists() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (under_way_ && under_way_->insists) return under_way_->service;
  const auto call = std::find_if(calls_.begin(), calls_.end(), [](const Call& queued) { return queued.insists; });
  if (call == calls_.end()) return std::nullopt;
  return call->service;
}

void ServiceCaller::finishInsisting(const std::function<bool()>& running) {
  const auto service = whatInsists();
  if (!service) return;
  log_(teleop::Severity::kWarning, "this window ends once " + *service + " has been answered");
  while (running() && whatInsists()) {
    lookAfter(steadyNow());
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

bool ServiceCaller::isReady(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);  // a client must not be asked while another thread shuts it down
  return ready_service_ == service && ready_.isValid();
}

void ServiceCaller::getReady(const std::string& service, bool seen) {
  if (!isServiceName(service)) return;
  const bool ready = isReady(service);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    seen_ = seen;
    if (ready || !seen || steadyNow() - connected_at_ < kBetweenConnections) return;
    ready_service_ = service;
    to_connect_ = true;
  }
  wake_.notify_all();
}

void ServiceCaller::connectAhead(std::unique_lock<std::mutex>& lock) {
  const std::string service = ready_service_;
  to_connect_ = false;
  connected_at_ = steadyNow();
  lock.unlock();
  ros::ServiceClient fresh;
  guard_.run("connecting to " + service, [&] {
    if (pidOfMaster()) fresh = node_.serviceClient<std_srvs::Trigger>(service, true);
  });
  lock.lock();
  ready_ = fresh;
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
      if (to_connect_) {
        connectAhead(lock);
      } else {
        wake_.wait(lock);
      }
      continue;
    }
    const Call call = calls_.front();
    calls_.pop_front();
    under_way_ = call;
    since_ = steadyNow();
    insists_until_ = *since_ + kInsists;  // it may have waited for the call before it
    patience_ = call.patience;
    withdrawn_ = sent_ = gave_up_ = no_master_ = false;
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
  if (!insists || !asking_since_) return;
  const Duration left = insists_until_ - *asking_since_;
  if (now - *asking_since_ < std::min(patience_, std::max(left, under_way_->patience))) return;
  patience_ *= 2;
  gave_up_ = true;
  asking_since_.reset();
  client_.shutdown();
}

}  // namespace frontier_pilot
