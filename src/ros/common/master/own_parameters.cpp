#include "ros/common/master/own_parameters.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "frontier_pilot/core/text.h"
#include "ros/common/master/ros_sessions.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/common/memory/disk.h"

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

constexpr const char* kUseSimTime = "/use_sim_time";
constexpr std::size_t kMostKept = 60000;  // [bytes], as XML
constexpr std::chrono::milliseconds kMasterRetry(200);

bool g_replaces_a_process = false;

std::optional<XmlRpcValue> ask(const char* method, const std::string& name) {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  request[1] = name;
  return requestFromMaster(method, request);
}

XmlRpcValue read(const std::string& name) { return ask("getParam", name).value_or(XmlRpcValue()); }

bool set(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  request[1] = name;
  request[2] = value;
  return requestFromMaster("setParam", request).has_value();
}

/// Adds to `present` what only `kept` has; returns whether there was anything to add. A value stays as it is.
bool complete(XmlRpcValue& present, const XmlRpcValue& kept) {
  if (!kept.valid()) return false;
  if (!present.valid()) {
    present = kept;
    return true;
  }
  constexpr auto kStruct = XmlRpcValue::TypeStruct;
  if (present.getType() != kStruct || kept.getType() != kStruct) return false;
  bool added = false;
  for (const auto& [name, value] : kept) added = complete(present[name], value) || added;
  return added;
}

/// Which of the parameters of a namespace are set that the master has already in part.
enum class Missing { kNone, kEach };

/// Sets what the master lacks of the parameter `name`; returns whether there was anything to set.
bool restoreOne(const std::string& name, const XmlRpcValue& kept, Missing missing) {
  const std::optional<XmlRpcValue> known = ask("hasParam", name);
  if (!kept.valid() || !known || known->getType() != XmlRpcValue::TypeBoolean) return false;
  if (missing == Missing::kNone && static_cast<bool>(*known)) return false;
  XmlRpcValue present = read(name);
  return complete(present, kept) && set(name, present);
}

/// The same of both.
bool restoreBoth(const XmlRpcValue& private_parameters, const XmlRpcValue& use_sim_time, Missing missing) {
  const bool clock = restoreOne(kUseSimTime, use_sim_time, missing);
  return restoreOne(ros::this_node::getName(), private_parameters, missing) || clock;
}

/// Sets the parameter `name` ("limits/max_linear") in a namespace.
void setIn(XmlRpcValue& space, const std::string& name, const XmlRpcValue& value) {
  if (space.valid() && space.getType() != XmlRpcValue::TypeStruct) space.clear();
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) {
    space[name] = value;
  } else {
    setIn(space[name.substr(0, slash)], name.substr(slash + 1), value);
  }
}

const XmlRpcValue* find(const XmlRpcValue& space, const std::string& name) {
  const std::size_t slash = name.find('/');
  const std::string first = name.substr(0, slash);
  if (space.getType() != XmlRpcValue::TypeStruct || !space.hasMember(first)) return nullptr;
  return slash == std::string::npos ? &space[first] : find(space[first], name.substr(slash + 1));
}

/// In memory only, so that no disk holds it up.
SessionMemory memoryOfThisNode() {
  constexpr auto kKind = SessionMemory::Owner::kLastingNode;
  return {{}, rosSessions(), "parameters", ros::this_node::getName(), kKind, spareFolder()};
}

}  // namespace

OwnParameters::OwnParameters()
    : private_(read(ros::this_node::getName())), use_sim_time_(read(kUseSimTime)), memory_(memoryOfThisNode()) {
  keep();
}

/// That there was a process is kept: one that is started after it in this session has to know which of the commands
/// that are latched are old.
OwnParameters::~OwnParameters() {
  memory_.remember({});
  memory_.endInOrder();
}

void OwnParameters::keep() {
  XmlRpcValue both;
  both["node"] = ros::this_node::getName();
  if (private_.valid()) both["private"] = private_;
  if (use_sim_time_.valid()) both["use_sim_time"] = use_sim_time_;
  const std::string text = both.toXml();
  memory_.remember(printable(text, kMostKept) == text ? text : std::string());
}

void OwnParameters::change(const std::string& name, const XmlRpcValue& value) {
  const std::lock_guard<std::mutex> lock(mutex_);
  setIn(private_, name, value);
  unsent_.insert(name);
  keep();
}

void OwnParameters::enter(const std::vector<std::string>& sessions) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (memory_.enter(sessions)) keep();
}

bool OwnParameters::restore() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return restoreBoth(private_, use_sim_time_, Missing::kNone);
}

void OwnParameters::sendChanges() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto name = unsent_.begin(); name != unsent_.end();) {
    const XmlRpcValue* value = find(private_, *name);
    if (value != nullptr && !set(ros::this_node::getName() + "/" + *name, *value)) return;
    name = unsent_.erase(name);
  }
}

std::shared_ptr<OwnParameters> sharedParameters() {
  static std::mutex mutex;
  static std::weak_ptr<OwnParameters> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<OwnParameters> parameters = shared.lock();
  if (!parameters) shared = parameters = std::make_shared<OwnParameters>();
  return parameters;
}

void followThePredecessor(bool is_of_roslaunch) {
  const SessionMemory memory = memoryOfThisNode();
  g_replaces_a_process = memory.recall().has_value();
  if (!is_of_roslaunch) return;
  const std::vector<std::string> kept = memory.recallFromElsewhere();
  int offset = 0;
  XmlRpcValue both;
  if (kept.empty() || !both.fromXml(kept.front(), &offset) || both.getType() != XmlRpcValue::TypeStruct) return;
  while (!pidOfMaster()) std::this_thread::sleep_for(kMasterRetry);
  const XmlRpcValue none;
  const auto member = [&](const char* name) { return both.hasMember(name) ? both[name] : none; };
  if (restoreBoth(member("private"), member("use_sim_time"), Missing::kEach)) {
    ROS_WARN("the master had lost the parameters of this node: they are set as they were before it was started again");
  }
}

bool replacesAProcess() { return g_replaces_a_process; }

}  // namespace frontier_pilot
