#include "ros/teleop_gui/service_watch.h"

#include "frontier_pilot/core/bounds.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/teleop_gui/service_caller.h"

namespace frontier_pilot {
namespace {

constexpr auto kWatchPeriod = std::chrono::seconds(1);

}  // namespace

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

bool ServiceWatch::isEnding() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

void ServiceWatch::lookOnce() {
  std::map<std::string, bool> before;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    before = up_;
  }
  const bool master = pidOfMaster().has_value();
  for (const auto& [service, was_up] : before) {
    if (isEnding()) return;
    ServiceProbe& probe = probes_.try_emplace(service, node_.resolveName(service)).first->second;
    // This contacts the server itself, too, so that the death of a server that is still registered is noticed.
    const bool is_up = master && probe.look();
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
