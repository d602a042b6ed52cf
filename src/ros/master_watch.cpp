#include "frontier_pilot/ros/master_watch.h"

#include <ros/console.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <utility>

#include "frontier_pilot/ros/clock.h"
#include "frontier_pilot/ros/registration.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(500);
constexpr Duration kRemembered = std::chrono::seconds(10);  // so that an operator sees what has been mended

/// Whether a node lives, asked once in a look.
using LivingNodes = std::map<std::string, bool>;

bool isIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void findRival(const std::string& what, const NodesByName& registered, LivingNodes& living,
               std::map<std::string, std::string>& rivals) {
  for (const std::string& node : nodesOf(registered, what)) {
    if (node == ros::this_node::getName()) continue;
    const auto [entry, unknown] = living.try_emplace(node);
    if (unknown) entry->second = nodeLives(node);
    if (entry->second) rivals[what] = node;
  }
}

}  // namespace

MasterWatch::MasterWatch() : thread_(&MasterWatch::run, this) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void MasterWatch::claimService(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  claims_.services.push_back(service);
}

void MasterWatch::claimTopic(const std::string& topic) {
  const std::lock_guard<std::mutex> lock(mutex_);
  claims_.topics.push_back(topic);
}

MasterWatch::Claims MasterWatch::claims() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return claims_;
}

void MasterWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    lock.unlock();
    try {
      look();
    } catch (const std::exception& error) {
      ROS_ERROR_STREAM_THROTTLE(5.0, "the master's state could not be read: " << error.what());
    } catch (const XmlRpc::XmlRpcException& error) {  // which is no std::exception
      ROS_ERROR_STREAM_THROTTLE(5.0, "the master's state could not be read: " << error.getMessage());
    }
    lock.lock();
    wake_.wait_for(lock, kPeriod, [this] { return ending_; });
  }
}

void MasterWatch::look() {
  std::optional<MasterState> state = askMaster();
  if (!state) return;
  MasterReport report;
  missing_before_ = std::exchange(missing_, {});
  const Claims own = claims();
  LivingNodes living;
  for (const std::string& service : own.services) findRival(service, state->providers, living, report.rivals);
  for (const std::string& topic : own.topics) findRival(topic, state->publishers, living, report.rivals);
  lookAtTopics(*state);
  lookAtServices(*state, report.rivals);
  setRivals(report.rivals);
  report.publishers = std::move(state->publishers);
  report_.put(std::move(report));
}

void MasterWatch::lookAtTopics(const MasterState& state) {
  const std::string& self = ros::this_node::getName();
  std::vector<std::string> advertised, subscribed;
  ros::this_node::getAdvertisedTopics(advertised);
  ros::this_node::getSubscribedTopics(subscribed);
  for (const std::string& topic : advertised) {
    const bool known = isIn(nodesOf(state.publishers, topic), self);
    if (!known && missingTwice("publisher of " + topic) && registerPublisher(topic)) note("publisher of " + topic);
  }
  for (const std::string& topic : subscribed) {
    const bool known = isIn(nodesOf(state.subscribers, topic), self);
    if (!known && missingTwice("subscriber of " + topic) && registerSubscriber(topic)) note("subscriber of " + topic);
  }
}

void MasterWatch::lookAtServices(const MasterState& state, const std::map<std::string, std::string>& rivals) {
  const std::string& self = ros::this_node::getName();
  for (const std::string& service : claims().services) {
    if (isIn(nodesOf(state.providers, service), self) || rivals.count(service) > 0) continue;
    if (missingTwice("service " + service) && registerService(service)) note("service " + service);
  }
}

bool MasterWatch::missingTwice(const std::string& what) {
  missing_.insert(what);
  return missing_before_.count(what) > 0;
}

void MasterWatch::note(const std::string& what) {
  renewed_[what] = steadyNow();
  ROS_ERROR_STREAM("the master did not know this node as " << what << " any more: registered again");
}

void MasterWatch::setRivals(const std::map<std::string, std::string>& rivals) {
  std::vector<std::string> problems;
  for (const auto& [what, node] : rivals) {
    problems.push_back(node + " offers " + what + " as well");
    const auto before = rivals_.find(what);
    if (before == rivals_.end() || before->second != node) ROS_ERROR_STREAM(problems.back());
  }
  rivals_ = rivals;
  const SteadyTime now = steadyNow();
  for (auto entry = renewed_.begin(); entry != renewed_.end();) {
    const bool recent = now - entry->second < kRemembered;
    if (recent) problems.push_back("the master had forgotten this node as " + entry->first + ": registered again");
    entry = recent ? std::next(entry) : renewed_.erase(entry);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  problems_ = std::move(problems);
}

std::vector<std::string> MasterWatch::problems() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problems_;
}

void MasterWatch::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, "registered at the master");
  const std::vector<std::string> all = problems();
  if (all.empty()) return;
  const std::string more = all.size() > 1 ? " (and " + std::to_string(all.size() - 1) + " more)" : "";
  status.summary(DiagnosticStatus::ERROR, all.front() + more);
  for (std::size_t i = 0; i < all.size(); ++i) status.add("problem " + std::to_string(i + 1), all[i]);
}

}  // namespace frontier_pilot
