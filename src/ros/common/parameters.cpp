#include "ros/common/parameters.h"

#include <ros/console.h>

#include "ros/common/master/parameter_values.h"

namespace frontier_pilot {

namespace {

/// A parameter of diagnostic_updater's, which a launch file may set for all its nodes.
constexpr const char* kDiagnosticPeriod = "diagnostic_period";

/// Values are quoted in problems; one of the size of a file would hide all other lines.
std::string shortened(const std::string& problem) {
  constexpr std::size_t kLongest = 1000;
  return problem.size() <= kLongest ? problem : problem.substr(0, kLongest) + " ...";
}

std::string joined(const std::string& where, const Problems& problems) {
  std::string text = "bad configuration of " + where + ":";
  for (const std::string& problem : problems) text += "\n  " + shortened(problem);
  return text;
}

}  // namespace

ConfigurationError::ConfigurationError(const std::string& where, const Problems& problems)
    : std::runtime_error(joined(where, problems)) {}

ParameterMap readParameters(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue value;
  if (!node.getParam(node.getNamespace(), value)) return {};
  if (value.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    throw ConfigurationError(node.getNamespace(), {"is a single value, not a dictionary of parameters"});
  }
  try {
    auto parameters = std::get<ParameterMap>(toParameterValue(value).value);
    if (parameters.erase(kDiagnosticPeriod) > 0) {
      ROS_WARN_STREAM(node.getNamespace()
                      << "/" << kDiagnosticPeriod << " is ignored: a node publishes its diagnostics each second");
    }
    return parameters;
  } catch (const std::length_error& error) {
    throw ConfigurationError(node.getNamespace(), {error.what()});
  }
}

void logParameters(const std::string& where, const std::vector<detail::Describer::Row>& rows) {
  ROS_DEBUG_STREAM("configuration of " << where << ":\n" << printRows(rows));
}

}  // namespace frontier_pilot
