#include "ros/frontier_explorer/save_map_caller.h"

#include <frontier_pilot/SaveMap.h>

#include <algorithm>
#include <filesystem>

#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr const char* kNoAnswer = ": no such service, or it died";

}  // namespace

std::string pathOfRobot(const std::string& path, const std::string& robot) {
  if (path.empty() || robot.empty()) return path;
  std::filesystem::path base = path;
  const std::string extension = base.extension().string();
  if (extension == ".pgm" || extension == ".yaml" || extension == ".bt") base.replace_extension();  // as save_map does
  std::string name = robot;
  std::replace(name.begin(), name.end(), '/', '_');
  return base.string() + "_" + name;
}

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

}  // namespace frontier_pilot
