#include "ros/frontier_explorer/map_at_end.h"

#include <frontier_pilot/SaveMap.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr const char* kNoAnswer = ": no such service, or it died";

/// `path` for one robot of several: with its name at the end, or else each one's map would be saved over the others'.
std::string pathOfRobot(const std::string& path, const std::string& robot) {
  if (path.empty() || robot.empty()) return path;
  std::filesystem::path base = path;
  const std::string extension = base.extension().string();
  if (extension == ".pgm" || extension == ".yaml" || extension == ".bt") base.replace_extension();  // as save_map does
  std::string name = robot;
  std::replace(name.begin(), name.end(), '/', '_');
  return base.string() + "_" + name;
}

}  // namespace

SaveMapCaller::~SaveMapCaller() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ending_ = true;
  client_.shutdown();
}

void SaveMapCaller::save(const std::string& path) {
  worker_.startNext([this, path] { return call(path); });
}

std::optional<SaveMapCaller::End> SaveMapCaller::take() {
  if (std::optional<std::string> failure = worker_.takeFailure()) return End{false, *failure};
  return worker_.take();
}

SaveMapCaller::End SaveMapCaller::call(const std::string& path) {
  // Persistent, because only such a client can be shut down in the middle of a call.
  ros::ServiceClient client = node_.serviceClient<SaveMap>(names::kSaveMap, true);
  bool connected = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);  // the client is not asked while another thread shuts it down
    if (ending_) return {};
    client_ = client;
    connected = client.isValid();
  }
  SaveMap service;
  service.request.path = path;
  if (!connected || !client.call(service)) return {false, client.getService() + kNoAnswer};
  return {service.response.success != 0, service.response.message};
}

MapAtEnd::MapAtEnd(const ros::NodeHandle& node, const std::string& path, const std::string& robot)
    : caller_(node), path_(pathOfRobot(path, robot)) {}

bool MapAtEnd::update(bool ended, bool done, SteadyTime now) {
  constexpr Duration kBetweenAttempts = std::chrono::seconds(5);
  if (path_.empty()) return false;
  if (ended) outcome_ = "saving " + path_;
  if (ended || (done && again_ && now >= *again_)) {
    again_.reset();
    caller_.save(path_);
  }
  const auto end = caller_.take();
  if (!end) return false;
  lost_ = !end->success;
  again_ = lost_ ? std::make_optional(now + kBetweenAttempts) : std::nullopt;
  const std::string said = std::exchange(outcome_, (lost_ ? "not saved: " : "saved: ") + end->message);
  if (outcome_ == said) return false;
  if (lost_) THROTTLED_WARN("the map at the end was " << outcome_ << "; saving is tried again");
  if (!lost_) THROTTLED_INFO("the map at the end was " << outcome_);
  return true;
}

}  // namespace frontier_pilot
