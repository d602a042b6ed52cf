#pragma once

#include <ros/node_handle.h>

#include <stdexcept>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// An invalid configuration; `what()` has one line for each problem.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// `where` is the namespace that the parameters were read from.
  ConfigurationError(const std::string& where, const Problems& problems);
};

/// All parameters in the namespace of `node`, which is usually the private one; empty if there are none. Without
/// `diagnostic_period`, of which it says that it is ignored.
ParameterMap readParameters(const ros::NodeHandle& node);

/// Logs the effective configuration at DEBUG.
void logParameters(const std::string& where, const std::vector<detail::Describer::Row>& rows);

/// The parameters of a node: `P`'s defaults, overwritten by its private namespace. To be called before anything is
/// advertised. Throws a ConfigurationError that names every unknown key and every bad value.
template <class P>
P loadNodeParameters(const ros::NodeHandle& private_node) {
  P parameters;
  const Problems problems = loadParameters(readParameters(private_node), parameters);
  if (!problems.empty()) throw ConfigurationError(private_node.getNamespace(), problems);
  logParameters(private_node.getNamespace(), describeParameters(parameters));
  return parameters;
}

}  // namespace frontier_pilot
