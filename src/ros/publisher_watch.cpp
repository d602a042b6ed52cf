#include "frontier_pilot/ros/publisher_watch.h"

#include <ros/master.h>
#include <ros/this_node.h>

#include "frontier_pilot/ros/xml_rpc.h"

namespace frontier_pilot {
namespace {

std::vector<std::string> toNames(XmlRpc::XmlRpcValue& list) {
  std::vector<std::string> names;
  for (XmlRpc::XmlRpcValue& name : elements(list)) names.push_back(static_cast<std::string>(name));
  return names;
}

/// Nothing if the master does not answer.
std::optional<Publishers> askMaster(const std::vector<std::string>& topics) {
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return std::nullopt;
  Publishers found;
  for (const std::string& topic : topics) found[topic] = {};
  for (XmlRpc::XmlRpcValue& topic : elements(state[0])) {
    const auto entry = found.find(static_cast<std::string>(topic[0]));
    if (entry != found.end()) entry->second = toNames(topic[1]);
  }
  return found;
}

}  // namespace

PublisherWatch::PublisherWatch(std::vector<std::string> topics, Duration period)
    : topics_(std::move(topics)), period_(period), thread_(&PublisherWatch::run, this) {}

PublisherWatch::~PublisherWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void PublisherWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    lock.unlock();
    if (auto found = askMaster(topics_)) found_.put(std::move(*found));
    lock.lock();
    wake_.wait_for(lock, period_, [this] { return ending_; });
  }
}

}  // namespace frontier_pilot
