#include "ros/common/parameters.h"

#include <ros/console.h>

#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {

namespace {

std::string joined(const std::string& where, const Problems& problems) {
  std::string text = "bad configuration of " + where + ":";
  for (const std::string& problem : problems) text += "\n  " + problem;
  return text;
}

ParameterList toList(XmlRpc::XmlRpcValue& value) {
  ParameterList list;
  for (XmlRpc::XmlRpcValue& item : elements(value)) list.push_back(toParameterValue(item));
  return list;
}

ParameterMap toMap(XmlRpc::XmlRpcValue& value) {
  ParameterMap map;
  for (auto& [name, item] : value) map[name] = toParameterValue(item);
  return map;
}

}  // namespace

ConfigurationError::ConfigurationError(const std::string& where, const Problems& problems)
    : std::runtime_error(joined(where, problems)) {}

ParameterValue toParameterValue(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return {static_cast<bool>(value)};
    case XmlRpc::XmlRpcValue::TypeInt:
      return {std::int64_t{static_cast<int>(value)}};
    case XmlRpc::XmlRpcValue::TypeDouble:
      return {static_cast<double>(value)};
    case XmlRpc::XmlRpcValue::TypeString:
      return {static_cast<std::string>(value)};
    case XmlRpc::XmlRpcValue::TypeArray:
      return {toList(value)};
    case XmlRpc::XmlRpcValue::TypeStruct:
      return {toMap(value)};
    default:
      return {};
  }
}

ParameterMap readParameters(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue value;
  if (!node.getParam(node.getNamespace(), value)) return {};
  if (value.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    throw ConfigurationError(node.getNamespace(), {"is a single value, not a dictionary of parameters"});
  }
  return toMap(value);
}

void logParameters(const std::string& where, const std::vector<detail::Describer::Row>& rows) {
  ROS_DEBUG_STREAM("configuration of " << where << ":\n" << printRows(rows));
}

}  // namespace frontier_pilot
