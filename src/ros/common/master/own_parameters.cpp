#include "ros/common/master/own_parameters.h"

#include <ros/this_node.h>

#include <optional>
#include <string>

#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

constexpr const char* kUseSimTime = "/use_sim_time";

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

/// Sets `name` to `value` if `value` is known and the master has no such parameter. Returns whether it was set.
bool restoreOne(const std::string& name, const XmlRpcValue& value) {
  if (!value.valid()) return false;
  std::optional<XmlRpcValue> known = ask("hasParam", name);
  if (!known || known->getType() != XmlRpcValue::TypeBoolean || static_cast<bool>(*known)) return false;
  return set(name, value);
}

}  // namespace

OwnParameters::OwnParameters() : private_(read(ros::this_node::getName())), use_sim_time_(read(kUseSimTime)) {}

bool OwnParameters::restore() {
  const bool clock = restoreOne(kUseSimTime, use_sim_time_);
  for (const auto& [name, value] : changed_) unsent_.insert(name);
  return restoreOne(ros::this_node::getName(), private_) || clock;
}

void OwnParameters::sendChanges() {
  for (auto name = unsent_.begin(); name != unsent_.end();) {
    if (!set(ros::this_node::getName() + "/" + *name, changed_[*name])) return;
    name = unsent_.erase(name);
  }
}

}  // namespace frontier_pilot
