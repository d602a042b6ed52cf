#include "ros/common/master/master_watch.h"

#include <ros/this_node.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/master/registration.h"
#include "ros/common/master/topic_list.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kRemembered = std::chrono::seconds(10);  // how long a repaired registration stays in the diagnostics
constexpr Duration kSecondLook = std::chrono::milliseconds(400);  // whether what is missing is still missing
constexpr std::size_t kOften =
    5;  // looks within kRemembered in which a service is missing; a restart of the master causes two or three

}  // namespace

MasterWatch::MasterWatch(Duration period) : period_(period), last_answer_(steadyNow()) {
  claimService(ros::this_node::getName() + "/set_logger_level");  // roscpp's own
  session_.add([this](const auto& sessions) { parameters_->enter(sessions); });
  thread_ = std::thread(&MasterWatch::run, this);
}

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

void MasterWatch::claimTopics(const std::vector<std::string>& topics) {
  const std::lock_guard<std::mutex> lock(mutex_);
  claims_.topics.push_back(topics);
  looks_anew_ = true;
  report_.take();
  wake_.notify_all();
}

void MasterWatch::watchListeners(const std::string& topic) {
  const std::lock_guard<std::mutex> lock(mutex_);
  listened_ = topic;
}

Claims MasterWatch::claims() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return claims_;
}

void MasterWatch::setParameter(const std::string& name, const XmlRpc::XmlRpcValue& value) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    new_parameters_[name] = value;
  }
  wake_.notify_all();
}

void MasterWatch::sendParameters() {
  std::map<std::string, XmlRpc::XmlRpcValue> changed;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    changed.swap(new_parameters_);
  }
  for (const auto& [name, value] : changed) parameters_->change(name, value);
  parameters_->sendChanges();
}

void MasterWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    looks_anew_ = false;
    lock.unlock();
    guard_.run("the watch on the master", [this] {
      watched_.look();  // before all that a master which does not answer delays
      sendParameters();
      look();
    });
    lock.lock();
    const Duration pause = missing_.empty() ? period_ : std::min(period_, kSecondLook);
    wake_.wait_for(lock, pause, [this] { return ending_ || looks_anew_ || !new_parameters_.empty(); });
  }
}

void MasterWatch::look() {
  std::optional<MasterState> state = askMaster();
  if (!state) return;
  last_answer_ = steadyNow();
  MasterReport report;
  missing_before_ = std::exchange(missing_, {});
  if (nameIsTaken()) return giveWay();
  report.rivals = findRivals(claims(), *state);
  lookAtServices(*state, report.rivals);  // before the topics: a stop is a service, and each registration takes time
  lookAtTopics(*state);
  lookAtAnAddress(*state);
  findTakers(report.rivals);
  report.listeners = findListeners(*state);
  sayWhatWasRenewed();
  session_.tell();
  setRivals(report.rivals);
  if (missing_.empty() && remembered_.empty()) nodes_.look();
  if (lists_topics_) {
    if (const auto types = askTopicTypes()) {
      const std::lock_guard<std::mutex> lock(mutex_);
      topics_ = frontier_pilot::listTopics(*state, *types);
    }
  }
  report.publishers = std::move(state->publishers);
  report.providers = std::move(state->providers);
  const std::lock_guard<std::mutex> lock(mutex_);
  publishers_ = report.publishers;
  if (!looks_anew_) report_.put(std::move(report));
}

std::optional<std::vector<std::string>> MasterWatch::findListeners(const MasterState& state) const {
  std::string topic;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    topic = listened_;
  }
  if (topic.empty()) return std::nullopt;
  std::vector<std::string> nodes = nodesOf(state.subscribers, topic);
  // Its services' port is not tried: rospy warns of a connection that ends at once.
  const auto isDead = [](const std::string& node) { return !anyMayLivePatiently({uriOf(node)}); };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), isDead), nodes.end());
  return nodes;
}

void MasterWatch::lookAtTopics(const MasterState& state) {
  const std::string& self = ros::this_node::getName();
  std::vector<std::string> advertised, subscribed;
  ros::this_node::getAdvertisedTopics(advertised);
  ros::this_node::getSubscribedTopics(subscribed);
  for (const std::string& topic : advertised) {
    const bool known = isNodeOf(state.publishers, topic, self);
    if (!known && missingTwice("publisher of " + topic) && registerPublisher(topic))
      renewed_.push_back("publisher of " + topic);
  }
  const std::optional<UrisByTopic> connected = connectedPublishers();
  for (const std::string& topic : subscribed) {
    const bool known = isNodeOf(state.subscribers, topic, self);
    if (!known && missingTwice("subscriber of " + topic) && registerSubscriber(topic, connected))
      renewed_.push_back("subscriber of " + topic);
  }
  if (!connected) return;
  connections_.mend(state, subscribed, *connected);
  const std::lock_guard<std::mutex> lock(mutex_);
  connected_ = *connected;
}

void MasterWatch::lookAtServices(const MasterState& state, const std::map<std::string, std::string>& rivals) {
  const std::string& self = ros::this_node::getName();
  for (const std::string& service : claims().services) {
    if (isNodeOf(state.providers, service, self) || rivals.count(service) > 0) continue;
    if (missingTwice("service " + service) && registerService(service)) renewed_.push_back("service " + service);
  }
}

void MasterWatch::lookAtAnAddress(const MasterState& state) {
  const std::vector<std::string> services = claims().services;
  if (services.empty()) return;
  const std::string& service = services[next_service_++ % services.size()];
  if (!isNodeOf(state.providers, service, ros::this_node::getName()) || pointsHere(service)) return;
  THROTTLED_ERROR("the master sends calls of " << service << " elsewhere, under the name of this node");
  if (registerService(service)) renewed_.push_back("service " + service);
}

void MasterWatch::findTakers(std::map<std::string, std::string>& rivals) {
  const SteadyTime now = steadyNow();
  for (const std::string& service : claims().services) {
    std::deque<SteadyTime>& losses = losses_[service];
    if (missing_.count("service " + service) > 0) losses.push_back(now);
    while (!losses.empty() && now - losses.front() > kRemembered) losses.pop_front();
    if (losses.size() >= kOften) rivals.try_emplace(service, "a node that comes and goes");
  }
}

void MasterWatch::giveWay() {
  THROTTLED_ERROR("the master has another living process under this node's name: this node ends");
  std::raise(SIGTERM);  // a node that is told to end says its last words
}

bool MasterWatch::missingTwice(const std::string& what) {
  missing_.insert(what);
  return missing_before_.count(what) > 0;
}

void MasterWatch::sayWhatWasRenewed() {
  const std::vector<std::string> renewed = std::exchange(renewed_, {});
  if (renewed.empty()) return;
  const std::string more = renewed.size() > 1 ? " and " + std::to_string(renewed.size() - 1) + " more" : "";
  THROTTLED_ERROR("the master had forgotten this node: registered again as " << renewed.front() << more);
  for (const std::string& what : renewed) remembered_[what] = steadyNow();
  if (parameters_->restore()) THROTTLED_WARN("the master had lost the parameters of this node: they are set again");
  session_.renew();
}

void MasterWatch::setRivals(const std::map<std::string, std::string>& rivals) {
  const std::vector<std::string> services = claims().services;
  std::vector<std::string> problems;
  for (const auto& [what, node] : rivals) {
    const bool offered = std::find(services.begin(), services.end(), what) != services.end();
    std::string problem = node;
    problem.append(offered ? " offers " : " publishes ").append(what).append(" as well");
    problems.push_back(std::move(problem));
    const auto before = rivals_.find(what);
    if (before == rivals_.end() || before->second != node) THROTTLED_ERROR(problems.back());
  }
  rivals_ = rivals;
  const SteadyTime now = steadyNow();
  for (auto entry = remembered_.begin(); entry != remembered_.end();) {
    const bool recent = now - entry->second < kRemembered;
    if (recent) problems.push_back("the master had forgotten this node as " + entry->first + ": registered again");
    entry = recent ? std::next(entry) : remembered_.erase(entry);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  problems_ = std::move(problems);
}

std::set<std::string> MasterWatch::connectedPublishersOf(const std::string& topic) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return urisOf(connected_, topic);
}

bool MasterWatch::hasLooked() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_.has_value();
}

std::vector<std::string> MasterWatch::publishersOf(const std::string& topic) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_ ? nodesOf(*publishers_, topic) : std::vector<std::string>();
}

std::vector<robot_check::Topic> MasterWatch::topics() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topics_;
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
